// The faces of a level that pressures push which follow the surface.
#pragma once

#include <fem/mesh/boundary.h>
#include <fem/solver/quasistatic.h>

#include <array>
#include <span>
#include <vector>

namespace physgen::fem {

struct PressedFace {
  Face nodes;           ///< counter-clockwise, seen from outside
  double pressure = 0;  ///< at a load of 1 [Pa]
};

/// Those of the finest level, pressure after pressure.
[[nodiscard]] std::vector<PressedFace> pressed_faces(std::span<const FollowingPressure> pressures);

/// Those of the next coarser level, of which each is four of these: the one between the middles of its sides says where
/// it is.
/// @param parents of each node
/// @throw Error when the faces are not those that refine() makes
[[nodiscard]] std::vector<PressedFace> coarser_faces(std::span<const PressedFace> faces,
                                                     std::span<const std::array<Index, 2>> parents);

/// What touches each node or edge of a level: face and corner; of an edge the corner opposite it.
struct FaceLists {
  IncidenceList of_nodes, of_edges;
};
/// @param edges ascending
/// @throw Error when a side of a face is no edge
[[nodiscard]] FaceLists lists_of(std::span<const PressedFace> faces, Index nodes,
                                 std::span<const std::array<Index, 2>> edges);

}  // namespace physgen::fem
