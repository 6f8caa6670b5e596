// Members are sorted lists, so that groups compare, and faces are found by search.
#include <fem/mesh/groups.h>
#include <fem/mesh/nearest_name.h>
#include <physgen/error.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

namespace physgen::fem {

namespace {

template <class Value>
void sort_once(std::vector<Value>& values) {
  std::ranges::sort(values);
  const auto repeated = std::ranges::unique(values);
  values.erase(repeated.begin(), repeated.end());
}

Face sorted(Face face) {
  std::ranges::sort(face);
  return face;
}

// The node in the middle of an edge of the coarse mesh.
Index middle(const TetMesh& mesh, const MeshGroup& group, Index a, Index b) {
  const std::array<Index, 2> ends{std::min(a, b), std::max(a, b)};
  const auto found = std::ranges::lower_bound(mesh.edges, ends);
  if (found == mesh.edges.end() || *found != ends) {
    throw Error("group '" + group.name + "': nodes " + std::to_string(a) + " and " + std::to_string(b) +
                " of it are the ends of no edge of a tet; mesh its lines and surfaces together with the volume");
  }
  return mesh.nodes + static_cast<Index>(found - mesh.edges.begin());
}

/// "(0.01, 0, 0.1)" [m]
std::string place(std::span<const Point> rest, Index node) {
  const Point& x = rest[static_cast<std::size_t>(node)];
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "(%.6g, %.6g, %.6g)", x[0], x[1], x[2]);
  return text.data();
}

}  // namespace

void complete(MeshGroup& group, std::span<const std::array<Index, 4>> tets) {
  for (auto& line : group.lines) std::ranges::sort(line);
  for (Face& face : group.faces) std::ranges::rotate(face, std::ranges::min_element(face));
  sort_once(group.lines);
  sort_once(group.faces);
  sort_once(group.tets);
  for (const auto& line : group.lines) group.nodes.insert(group.nodes.end(), line.begin(), line.end());
  for (const Face& face : group.faces) group.nodes.insert(group.nodes.end(), face.begin(), face.end());
  for (const Index t : group.tets) {
    const auto& tet = tets[static_cast<std::size_t>(t)];
    group.nodes.insert(group.nodes.end(), tet.begin(), tet.end());
  }
  sort_once(group.nodes);
}

const MeshGroup& group_named(std::span<const MeshGroup> groups, std::string_view name) {
  const auto found = std::ranges::find(groups, name, &MeshGroup::name);
  if (found != groups.end()) return *found;
  std::vector<std::string> names;
  std::string list;
  for (const MeshGroup& group : groups) {
    names.push_back(group.name);
    list += (list.empty() ? "" : ", ") + group.name;
  }
  const std::string near = nearest_name(std::string(name), names);
  throw Error("the mesh has no group '" + std::string(name) + "'" +
              (near.empty() ? "" : "; did you mean '" + near + "'?") +
              (list.empty() ? "; it has none at all: name physical groups in Gmsh, and save the mesh again"
                            : (near.empty() ? "; it has " : " It has ") + list));
}

std::vector<MeshGroup> refine_groups(const TetMesh& mesh, std::span<const MeshGroup> groups) {
  std::vector<MeshGroup> finer;
  for (const MeshGroup& group : groups) {
    MeshGroup& fine = finer.emplace_back();
    fine.name = group.name;
    fine.nodes = group.nodes;
    const auto middle_of = [&](Index a, Index b) { return middle(mesh, group, a, b); };
    for (const auto& [a, b] : group.lines) {
      const Index m = middle_of(a, b);
      fine.nodes.push_back(m);
      fine.lines.push_back({a, m});
      fine.lines.push_back({b, m});
    }
    for (const auto& [a, b, c] : group.faces) {
      const Index ab = middle_of(a, b), bc = middle_of(b, c), ca = middle_of(c, a);
      fine.nodes.insert(fine.nodes.end(), {ab, bc, ca});
      fine.faces.insert(fine.faces.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    std::vector<Index> tets;  // ascending, as the coarse ones are
    for (const Index t : group.tets) {
      for (Index k = 0; k < 8; ++k) tets.push_back(8 * t + k);
      const auto& tet = mesh.tets[static_cast<std::size_t>(t)];
      for (const auto& [i, k] : tet_edges) {
        fine.nodes.push_back(middle_of(tet[static_cast<std::size_t>(i)], tet[static_cast<std::size_t>(k)]));
      }
    }
    complete(fine, {});
    fine.tets = std::move(tets);
  }
  return finer;
}

std::vector<Face> outward_faces(const TetMesh& mesh, std::span<const Point> rest, const MeshGroup& group) {
  const std::vector<Face> surface = boundary_faces(mesh);
  std::vector<Face> faces;
  for (const Face& face : group.faces) {
    const Face nodes = sorted(face);
    const auto found = std::ranges::lower_bound(surface, nodes, {}, sorted);
    if (found == surface.end() || sorted(*found) != nodes) {
      throw Error("group '" + group.name + "': its face with corners at " + place(rest, face[0]) + ", " +
                  place(rest, face[1]) + " and " + place(rest, face[2]) +
                  " m is not of the surface of the mesh, so that a pressure has no side to act on; give a group of "
                  "faces of the surface");
    }
    faces.push_back(*found);
  }
  return faces;
}

}  // namespace physgen::fem
