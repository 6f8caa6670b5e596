// The plates that hold a body: which nodes of each level are theirs, and what a user should know of that.
#pragma once

#include <fem/solver/mesh_level.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace physgen::truthcube {

/// What plates hold unless a run says otherwise, in mean edge lengths of the mesh: far above the rounding of what
/// writes meshes (1e-9 m in one of 0.1 m is common), and far below what anyone draws as a step.
inline constexpr double default_plate_tolerance = 1e-4;

/// The largest tolerance: half an edge, below which the next layer of nodes is not reached.
inline constexpr double largest_plate_tolerance = 0.5;

struct Plate {
  std::vector<std::vector<fem::Index>> nodes;  ///< of each level, finest first; ascending
  double area = 0;                             ///< of the finest mesh's surface triangles whose corners it holds [m^2]
  std::int64_t just_beyond = 0;                ///< nodes of the coarsest mesh that lie near its plane and are not held
  double farthest_beyond = 0;                  ///< from its plane, of those [m]
  std::int64_t whole_tets = 0;                 ///< tets of the finest mesh whose four corners it holds
};

struct PlatesOfBody {
  Plate lower, upper;
  double low = 0, high = 0;  ///< the planes, those of the lowest and of the highest node along z [m]
  double mean_edge = 0;      ///< of the coarsest mesh, which is the one that a user has given [m]
  double tolerance = 0;      ///< how far from its plane a plate holds nodes [m]

  [[nodiscard]] double height() const { return high - low; }
};

/// Plates at the lowest and highest nodes of the coarsest mesh along z: they hold its nodes that lie within `tolerance`
/// mean edge lengths of them, and nodes of finer levels whose parents they hold. So levels agree, whatever rounding the
/// nodes have.
/// @param levels finest first, without a background grid
/// @pre 0 <= tolerance <= largest_plate_tolerance
[[nodiscard]] PlatesOfBody hold_between_plates(std::span<const fem::MeshLevel> levels, double tolerance);

/// "plates hold 25 and 25 nodes, 6400 and 6400 mm^2 of the surface (lower and upper)"
[[nodiscard]] std::string describe(const PlatesOfBody& plates);

/// Why what the plates hold may not be what a user means: nodes that lie just beyond the tolerance, up to ten times as
/// far off, and at least up to ten times the default. Where a face is rougher than the tolerance, a part of it is held;
/// then, for any even spread of heights, nine times as many nodes lie within ten times of it, so that three held nodes,
/// with less than which there is no run, and none beyond are no part of a rougher face.
[[nodiscard]] std::vector<std::string> warnings_of(const PlatesOfBody& plates);

/// @throw Error when a plate holds fewer than three nodes, saying how many lie just beyond
void require_faces(const PlatesOfBody& plates);

}  // namespace physgen::truthcube
