#include "surface.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace physgen::truthcube {

namespace {

using fem::Face;
using fem::Index;

Face sorted(Face face) {
  std::ranges::sort(face);
  return face;
}

}  // namespace

Surface surface_of(const fem::TetMesh& mesh) {
  Surface surface;
  surface.triangles = fem::boundary_faces(mesh);
  for (const Face& face : surface.triangles) {
    const auto node = static_cast<std::size_t>(face[0]);
    for (Index i = mesh.node_tets.first[node]; i < mesh.node_tets.first[node + 1]; ++i) {
      const Index tet = mesh.node_tets.entries[static_cast<std::size_t>(i)].element;
      const auto& corners = mesh.tets[static_cast<std::size_t>(tet)];
      const auto has = [&](Index n) { return std::ranges::find(corners, n) != corners.end(); };
      if (!has(face[1]) || !has(face[2])) continue;
      surface.tets.push_back(tet);
      break;
    }
    surface.nodes.insert(surface.nodes.end(), face.begin(), face.end());
  }
  std::ranges::sort(surface.nodes);
  surface.nodes.erase(std::ranges::unique(surface.nodes).begin(), surface.nodes.end());
  for (Face& face : surface.triangles) {
    for (Index& n : face) {
      n = static_cast<Index>(std::ranges::lower_bound(surface.nodes, n) - surface.nodes.begin());
    }
  }
  return surface;
}

std::vector<fem::Point> points_of(const Surface& surface, std::span<const fem::Point> points) {
  std::vector<fem::Point> result;
  result.reserve(surface.nodes.size());
  for (const Index n : surface.nodes) result.push_back(points[static_cast<std::size_t>(n)]);
  return result;
}

std::vector<CellGroup> groups_of(const Surface& surface, std::span<const fem::MeshGroup> groups) {
  std::vector<CellGroup> result;
  for (const fem::MeshGroup& group : groups) {
    if (group.faces.empty() && group.tets.empty()) continue;
    CellGroup cells{"group_" + group.name, std::vector<std::uint8_t>(surface.triangles.size(), 0)};
    std::ranges::replace_if(
        cells.name, [](char c) { return std::string_view("/.|:").find(c) != std::string_view::npos; },
        '_');  // | and : part what XDMF names
    const std::string name = cells.name;
    for (int k = 2; std::ranges::find(result, cells.name, &CellGroup::name) != result.end(); ++k) {
      cells.name = name + "_" + std::to_string(k);
    }
    std::vector<Face> faces;
    for (const Face& face : group.faces) faces.push_back(sorted(face));
    std::ranges::sort(faces);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      Face face = surface.triangles[t];
      for (Index& n : face) n = surface.nodes[static_cast<std::size_t>(n)];
      const bool is_in = faces.empty() ? std::ranges::binary_search(group.tets, surface.tets[t])
                                       : std::ranges::binary_search(faces, sorted(face));
      cells.is_in[t] = is_in ? 1 : 0;
    }
    result.push_back(std::move(cells));
  }
  return result;
}

}  // namespace physgen::truthcube
