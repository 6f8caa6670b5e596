// Locates points in a tet mesh: finds the tet of each, and the weights of its corners, for linear interpolation.
#pragma once

#include <fem/mesh/mesh.h>
#include <physgen/error.h>

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace physgen::fem {

/// A point as the sum of weights[c] * position of corner c of the tet; the weights add up to 1.
struct Location {
  Index tet;
  std::array<double, 4> weights;
};

/// Thrown by locate() for the first point that no tet contains.
class OutsideMesh : public Error {
 public:
  OutsideMesh(std::size_t point, const std::string& what) : Error(what), point_(point) {}
  [[nodiscard]] std::size_t point() const { return point_; }  ///< its number among the points

 private:
  std::size_t point_;
};

/// The distance that a point may lie outside its tet, as a part of the tet's height there: weights are at least -1e-6.
inline constexpr double locate_tolerance = 1e-6;

/// The tet that contains each point: the one it lies deepest in where several do, the first of equals. Tets of either
/// orientation count, those without volume do not. Takes time linear in the sizes of mesh and points.
/// @param rest positions of the mesh's nodes [m]
/// @param points positions to be found [m]
/// @throws OutsideMesh when a point lies in no tet, within the tolerance, or is not finite
/// @throws Error when there are not as many positions as nodes
[[nodiscard]] std::vector<Location> locate(std::span<const Point> rest, const TetMesh& mesh,
                                           std::span<const Point> points);

}  // namespace physgen::fem
