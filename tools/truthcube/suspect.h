// The tet to look at in a state that no body can be in.
#pragma once

#include <fem/mesh/mesh.h>

#include <array>
#include <span>
#include <string>

#include "scene.h"

namespace physgen::truthcube {

struct SuspectTet {
  fem::Index tet = 0;
  std::array<double, 9> F{};  ///< deformation gradient, by rows
  double J = 1;
  bool is_finite = true;    ///< whether its F and stress are
  fem::Index inverted = 0;  ///< tets of J <= 0, where all are finite
};

/// The first tet whose deformation gradient or stress is not finite; where all are, that of the smallest J.
/// @param stresses of the solver, per tet, by columns [Pa]
[[nodiscard]] SuspectTet find_suspect(const fem::TetMesh& mesh, std::span<const fem::Point> rest,
                                      std::span<const fem::Point> positions,
                                      std::span<const std::array<double, 9>> stresses);

/// "tet 7 is deformed most: J 0.31, F = [...; ...; ...]", or what else is wrong with it. @param scene names its tets
[[nodiscard]] std::string describe(const SuspectTet& suspect, const Scene& scene);

}  // namespace physgen::truthcube
