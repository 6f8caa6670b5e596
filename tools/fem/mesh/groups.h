// Parts of a mesh under a name: Gmsh's physical groups.
#pragma once

#include <fem/mesh/boundary.h>
#include <fem/mesh/mesh.h>

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace physgen::fem {

/// What a mesh has under one name. Where a file has the name for points, lines, surfaces and volumes, all are here.
struct MeshGroup {
  std::string name;
  std::vector<Index> nodes;                 ///< of all that follows, and single ones; ascending
  std::vector<std::array<Index, 2>> lines;  ///< ends, the lower first; ascending, as the next are
  std::vector<Face> faces;                  ///< each begins with its lowest node and keeps its sense
  std::vector<Index> tets;
  bool operator==(const MeshGroup&) const = default;
};

/// Sorts a group's members, takes those that stand there twice once, and adds the nodes of lines, faces and tets.
void complete(MeshGroup& group, std::span<const std::array<Index, 4>> tets);

/// @throw Error when there is no group of this name, with the nearest name and all that there are
[[nodiscard]] const MeshGroup& group_named(std::span<const MeshGroup> groups, std::string_view name);

/// The same parts of the mesh that refine() makes of this one: halves of lines, quarters of faces, eighths of tets.
/// @param mesh the coarse one
/// @throw Error when a line or a side of a face is no edge of the mesh
[[nodiscard]] std::vector<MeshGroup> refine_groups(const TetMesh& mesh, std::span<const MeshGroup> groups);

/// The faces with the normals of the surface of the mesh: outward, where tets have positive volume.
/// @param rest where nodes are, for the message
/// @throw Error naming the group, and where the face is, when a face of it belongs to two tets or to none
[[nodiscard]] std::vector<Face> outward_faces(const TetMesh& mesh, std::span<const Point> rest, const MeshGroup& group);

}  // namespace physgen::fem
