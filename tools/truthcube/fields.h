// The fields of a state that are drawn: stress, its measures, and the change of volume.
#pragma once

#include <fem/mesh/mesh.h>

#include <array>
#include <span>
#include <vector>

namespace physgen::truthcube {

struct Fields {
  std::vector<double> displacement;  ///< per node, 3 each [m]
  std::vector<double> pressure;      ///< per node: -tr(stress) / 3 of its tets, averaged by their volume [Pa]
  std::vector<double> stress;        ///< per tet, Cauchy: xx yy zz xy yz xz [Pa]
  std::vector<double> von_mises;     ///< per tet [Pa]
  std::vector<double> volume_ratio;  ///< per tet: J
};

/// Of which strain a solver's stresses are: small strain does not tell the first Piola-Kirchhoff stress from Cauchy's.
enum class Strain { finite, small };

/// @param stresses per tet, by columns [Pa]; of finite strain first Piola-Kirchhoff
[[nodiscard]] Fields make_fields(const fem::TetMesh& mesh, std::span<const fem::Point> rest,
                                 std::span<const fem::Point> positions, std::span<const std::array<double, 9>> stresses,
                                 Strain strain);

}  // namespace physgen::truthcube
