// Meshes and node vectors into object arrays: the kernels' input, from the plain lists of mesh.h.
#pragma once

#include <fem/mesh/mesh.h>
#include <physgen/row_arrays.h>

#include <span>
#include <vector>

namespace physgen::fem {

/// Stores the corners of all tets. @pre a host view of mesh.tets.size() elasticity::Tet
template <class TetView>
void store_tets(const TetMesh& mesh, const TetView& view) {
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    for (std::size_t c = 0; c < 4; ++c) view[static_cast<index_t>(t)].nodes()[static_cast<int>(c)] = mesh.tets[t][c];
  }
}

/// Stores the ends of all edges. @pre a host view of mesh.edges.size() elasticity::Edge
template <class EdgeView>
void store_edges(const TetMesh& mesh, const EdgeView& view) {
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    for (std::size_t c = 0; c < 2; ++c) view[static_cast<index_t>(e)].nodes()[static_cast<int>(c)] = mesh.edges[e][c];
  }
}

/// Stores an incidence list. @pre host views of list.first.size() - 1 elasticity::IncidenceRange and of
/// list.entries.size() elasticity::Incidence
template <class RangeView, class IncidenceView>
void store_incidences(const IncidenceList& list, const RangeView& ranges, const IncidenceView& incidences) {
  for (std::size_t i = 0; i + 1 < list.first.size(); ++i) {
    ranges[static_cast<index_t>(i)].begin() = list.first[i];
    ranges[static_cast<index_t>(i)].end() = list.first[i + 1];
  }
  for (std::size_t k = 0; k < list.entries.size(); ++k) {
    incidences[static_cast<index_t>(k)].element() = list.entries[k].element;
    incidences[static_cast<index_t>(k)].local() = list.entries[k].local;
  }
}

/// An incidence list as rows for kernels.
/// @tparam Arrays RowArrays of elasticity::Incidence, in any space
/// @param targets how many elements there are: tets, or edges
/// @throw Error when the list names an element that is none of them
template <class Arrays>
[[nodiscard]] Arrays incidence_rows(const IncidenceList& list, index_t targets) {
  std::vector<typename Arrays::Value> entries;
  entries.reserve(list.entries.size());
  for (const auto [element, local] : list.entries) entries.push_back({element, local});
  return Arrays::from_offsets({"element", targets}, list.first, entries);
}

/// Stores node positions [m], rounded to the view's precision. @pre a host view of points.size()
/// elasticity::NodePosition
template <class PositionView>
void store_positions(std::span<const Point> points, const PositionView& view) {
  using Real = typename PositionView::Precision;
  for (std::size_t n = 0; n < points.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) {
      view[static_cast<index_t>(n)].x()[static_cast<int>(k)] = static_cast<Real>(points[n][k]);
    }
  }
}

}  // namespace physgen::fem
