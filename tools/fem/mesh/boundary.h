// The surface of a tet mesh, and loads on its nodes: dead pressure on faces, gravity in the volume.
#pragma once

#include <fem/mesh/mesh.h>

#include <array>
#include <span>
#include <vector>

namespace physgen::fem {

/// A triangle of nodes; its normal is (b - a) x (c - a).
using Face = std::array<Index, 3>;

/// A force on a node [N].
using Force = std::array<double, 3>;

/// The faces that belong to one tet alone. Their normals point outward where tets have positive volume; each starts
/// with its lowest node, and they ascend by their nodes in ascending order.
/// @pre a mesh of make_tet_mesh()
[[nodiscard]] std::vector<Face> boundary_faces(const TetMesh& mesh);

/// Nodes that lie in the plane x[axis] = value, ascending: no farther from it than the tolerance. May be empty. Faces
/// of meshes from files are flat but for rounding, so that a tolerance of 0 finds a part of one.
/// @param tolerance a length, as coordinates are
/// @throws Error when axis is not 0, 1 or 2, or the tolerance is negative or not finite
[[nodiscard]] std::vector<Index> nodes_on_plane(std::span<const Point> rest, int axis, double value, double tolerance);

/// Forces of a pressure [Pa] that keeps the faces' area and normal at rest (a dead load): each corner of a face gets
/// -pressure area normal / 3. Positive pressure pushes against the normal. Sums in the order of the faces.
/// @return one force per point
/// @throws Error when a face names no point
[[nodiscard]] std::vector<Force> pressure_loads(std::span<const Point> rest, std::span<const Face> faces,
                                                double pressure);

/// The share of each point in the faces' areas: a third of those that it is a corner of. Sums in the order of the
/// faces.
/// @throws Error when a face names no point
[[nodiscard]] std::vector<double> surface_areas(std::span<const Point> rest, std::span<const Face> faces);

/// Forces of gravity on nodes: each corner of a tet gets density V acceleration / 4, density in [kg/m^3], V the signed
/// volume at rest, acceleration as a vector [m/s^2]. Sums in the order of the tets.
/// @return one force per node
/// @throws Error when rest has not mesh.nodes points
[[nodiscard]] std::vector<Force> gravity_loads(const TetMesh& mesh, std::span<const Point> rest, double density,
                                               const std::array<double, 3>& acceleration);

}  // namespace physgen::fem
