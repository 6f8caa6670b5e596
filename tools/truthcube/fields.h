// The fields of a state that are drawn: stress, its measures, and the change of volume; by windows of rows of a file.
#pragma once

#include <fem/mesh/mesh.h>

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "body_state.h"
#include "output/window.h"
#include "state_windows.h"

namespace physgen::truthcube {

/// Of rows of points, which are nodes.
struct PointFields {
  std::vector<double> displacement;  ///< 3 each [m]
  std::vector<double> pressure;      ///< -tr(stress) / 3 of all tets at the node, averaged by their volume [Pa]
};

/// Of rows of cells, which are tets.
struct CellFields {
  std::vector<double> stress;        ///< Cauchy: xx yy zz xy yz xz [Pa]
  std::vector<double> von_mises;     ///< [Pa]
  std::vector<double> volume_ratio;  ///< J
};

/// Of which strain a solver's stresses are: small strain does not tell the first Piola-Kirchhoff stress from Cauchy's.
enum class Strain { finite, small };

/// Of which nodes and tets of the solver the rows of a file are.
struct DrawnRows {
  std::vector<fem::Index> nodes, tets;  ///< of each row; none: row r is of number r, of all
  std::vector<fem::Index> row_of_node;  ///< of each node, -1 where it has none; none likewise
};

class DrawnFields {
 public:
  /// @param mesh, rest stay alive as long as this @param window bytes
  DrawnFields(const fem::TetMesh& mesh, std::span<const fem::Point> rest, Strain strain, DrawnRows rows = {},
              std::size_t window = window_bytes);

  /// Calls visit(fields) with the next rows, until it has had all, on the rank that gets numbers. All ranks call it.
  /// @param state its stresses are of that strain, of finite strain first Piola-Kirchhoff
  void each_points(BodyState& state, const std::function<void(const PointFields&)>& visit) const;
  void each_cells(BodyState& state, const std::function<void(const CellFields&)>& visit) const;

 private:
  static constexpr std::size_t tets_of_block = 4096;
  using Numbers = std::span<const fem::Index>;

  [[nodiscard]] fem::Index row_of(fem::Index node) const {
    return rows_.row_of_node.empty() ? node : rows_.row_of_node[static_cast<std::size_t>(node)];
  }
  void add_pressures(BodyState& state, Numbers tets, fem::Index first, std::span<double> pressure,
                     std::span<double> volume) const;

  const fem::TetMesh& mesh_;
  std::span<const fem::Point> rest_;
  Strain strain_;
  DrawnRows rows_;
  WindowSizes window_;
  std::vector<std::array<fem::Index, 2>> rows_of_blocks_;  // the lowest and the highest row of a block of tets
};

}  // namespace physgen::truthcube
