// Faces with one tet are the boundary; loads are sums over faces and tets in a fixed order.
#include <fem/mesh/alike_nodes.h>
#include <fem/mesh/boundary.h>
#include <fem/mesh/box_lists.h>
#include <fem/mesh/faces.h>
#include <fem/mesh/geometry.h>
#include <fem/mesh/stages.h>
#include <physgen/error.h>
#include <physgen/fill_rows.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace physgen::fem {

namespace {

// The corners of the face opposite each corner, seen from outside a tet of positive volume counter-clockwise.
constexpr std::array<std::array<std::size_t, 3>, 4> outward{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

void add(Force& force, const Point& direction, double factor) {
  for (std::size_t k = 0; k < 3; ++k) force[k] += factor * direction[k];
}

/// @param who what an error names
Point twice_area_of(const char* who, std::size_t number, const Face& face, std::span<const Point> rest) {
  for (const Index node : face) {
    if (node < 0 || static_cast<std::size_t>(node) >= rest.size()) {
      throw Error(std::string(who) + ": face " + std::to_string(number) + " names node " + std::to_string(node) +
                  " of " + std::to_string(rest.size()));
    }
  }
  const auto x = [&](std::size_t corner) -> const Point& { return rest[static_cast<std::size_t>(face[corner])]; };
  return cross(difference(x(1), x(0)), difference(x(2), x(0)));
}

}  // namespace

std::vector<Face> boundary_faces(const TetMesh& mesh) {
  InStage stage("surface");
  const bool is_box = detail::has_tets_of_box(mesh);
  const auto tets_of = [&](Index node, const auto& act) {  // of a box without its rows, too
    if (!is_box) return tets_of_nodes(mesh)(node, act);
    detail::each_tet_of_box_node(mesh, node, [&](Index tet, Index /*corner*/) { act(tet); });
  };
  HostList<Index> first;
  HostList<Face> found;
  const auto make_scratch = [] { return FacesOfNode(); };
  const auto visit = [&](index_t n, FacesOfNode& faces, std::vector<Face>& row) {
    const auto node = static_cast<Index>(n);
    faces.each(
        node, mesh.tets, [&](const auto& act) { tets_of(node, act); },
        [&](std::span<const FaceUse> uses) {
          if (uses.size() != 1) return;
          Face face{};
          for (std::size_t c = 0; c < 3; ++c) {
            face[c] = mesh.tets[static_cast<std::size_t>(uses[0].tet())]
                               [outward[static_cast<std::size_t>(uses[0].corner())][c]];
          }
          std::ranges::rotate(face, std::ranges::min_element(face));
          row.push_back(face);
        });
  };
  if (is_box) {
    const detail::AlikeNodes nodes(*mesh.box, 1);
    const auto move = [&nodes](Face face, const detail::AlikeNodes::Node& node) {
      for (Index& corner : face) corner += nodes.nodes_beyond(node);
      return face;
    };
    detail::move_rows(nodes, make_scratch, visit, move, first, found);
  } else {
    append_rows(Host{}, mesh.nodes, make_scratch, visit, first, found);
  }
  stage.moves(mesh.tets, mesh.node_tets.first, mesh.node_tets.entries, found);
  return {found.begin(), found.end()};
}

std::vector<Index> nodes_on_plane(std::span<const Point> rest, int axis, double value, double tolerance) {
  if (axis < 0 || axis > 2) {
    throw Error("nodes on plane: axis " + std::to_string(axis) + "; it must be 0 (x), 1 (y) or 2 (z)");
  }
  if (!(tolerance >= 0 && std::isfinite(tolerance))) {
    throw Error("nodes on plane: tolerance " + std::to_string(tolerance) + "; it is a length, 0 or more");
  }
  std::vector<Index> nodes;
  for (std::size_t n = 0; n < rest.size(); ++n) {
    if (std::abs(rest[n][static_cast<std::size_t>(axis)] - value) <= tolerance) {
      nodes.push_back(static_cast<Index>(n));
    }
  }
  return nodes;
}

std::vector<Force> pressure_loads(std::span<const Point> rest, std::span<const Face> faces, double pressure) {
  std::vector<Force> forces(rest.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Point twice_area = twice_area_of("pressure loads", f, faces[f], rest);
    for (const Index node : faces[f]) add(forces[static_cast<std::size_t>(node)], twice_area, -pressure / 6);
  }
  return forces;
}

std::vector<double> surface_areas(std::span<const Point> rest, std::span<const Face> faces) {
  std::vector<double> areas(rest.size(), 0.0);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Point twice_area = twice_area_of("areas of the surface", f, faces[f], rest);
    const double third = std::hypot(twice_area[0], twice_area[1], twice_area[2]) / 6;
    for (const Index node : faces[f]) areas[static_cast<std::size_t>(node)] += third;
  }
  return areas;
}

std::vector<Force> gravity_loads(const TetMesh& mesh, std::span<const Point> rest, double density,
                                 const std::array<double, 3>& acceleration) {
  if (rest.size() != static_cast<std::size_t>(mesh.nodes)) {
    throw Error("gravity loads: " + std::to_string(rest.size()) + " positions for a mesh of " +
                std::to_string(mesh.nodes) + " nodes");
  }
  std::vector<Force> forces(rest.size());
  for (const auto& tet : mesh.tets) {
    const double quarter_mass = density * six_volumes(tet, rest) / 24;
    for (const Index node : tet) add(forces[static_cast<std::size_t>(node)], acceleration, quarter_mass);
  }
  return forces;
}

}  // namespace physgen::fem
