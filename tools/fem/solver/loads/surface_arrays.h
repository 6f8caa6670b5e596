// The arrays that a level keeps of faces that pressures push which follow them; made only where there are some.
#pragma once

#include <contact.physgen.h>
#include <fem/solver/arrays/over_groups.h>
#include <fem/solver/arrays/solver_arrays.h>
#include <fem/solver/hierarchy/level_graph.h>
#include <fem/solver/loads/pressed_faces.h>
#include <fem/solver/loads/surface_pressure.h>

#include <utility>
#include <vector>

namespace physgen::fem {

/// @tparam Group with the arrays of Surface in solver_groups.h
template <class Group>
struct SurfaceOver : Group {
  Vector3<double> centre = Vector3<double>::Zero();  ///< of the faces at rest [m]
  RowsOf<decltype(Group::node_face_ranges), decltype(Group::node_face_entries)> node_faces{this->node_face_ranges,
                                                                                           this->node_face_entries};
  RowsOf<decltype(Group::edge_face_ranges), decltype(Group::edge_face_entries)> edge_faces{this->edge_face_ranges,
                                                                                           this->edge_face_entries};

  explicit SurfaceOver(Group&& arrays) : Group(std::move(arrays)) {}
  SurfaceOver(const MeshLevel& level, const LevelGraph& graph, const std::vector<PressedFace>& given) {
    const auto count = index_t(given.size());
    this->allocate(counts(level.mesh.nodes, index_t(graph.edges.size()), count));
    const FaceLists lists = lists_of(given, level.mesh.nodes, graph.edges);
    put_packed<NodeTetEntry>(this->node_face_ranges, this->node_face_entries, lists.of_nodes, count, "pressed faces");
    put_packed<NodeTetEntry>(this->edge_face_ranges, this->edge_face_entries, lists.of_edges, count, "pressed faces");
    store(given);
    for (const PressedFace& face : given) {
      for (const Index node : face.nodes) {
        for (int k = 0; k < 3; ++k) {
          centre[k] += level.rest[std::size_t(node)][std::size_t(k)] / (3 * double(given.size()));
        }
      }
    }
  }

  [[nodiscard]] static auto counts(index_t nodes, index_t edges, index_t faces) {
    return typename Group::Counts{.face = faces, .node = nodes, .face_corner = 3 * faces, .edge = edges};
  }
  /// @pre as many as there were, with the same nodes
  void store(const std::vector<PressedFace>& given) {
    put_each(this->faces, [&](index_t f, auto&& face) {
      for (int k = 0; k < 3; ++k) face.nodes()[k] = given[std::size_t(f)].nodes[std::size_t(k)];
      face.pressure() = given[std::size_t(f)].pressure;
    });
  }
};

}  // namespace physgen::fem
