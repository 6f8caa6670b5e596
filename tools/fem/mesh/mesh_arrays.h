// Meshes and node vectors into object arrays: the kernels' input, from the plain lists of mesh.h.
#pragma once

#include <fem/mesh/mesh.h>
#include <physgen/detail/launch.h>
#include <physgen/row_arrays.h>

#include <span>
#include <vector>

namespace physgen::fem {

/// Stores the corners of all tets. @pre a host view of mesh.tets.size() elasticity::Tet
template <class TetView>
void store_tets(const TetMesh& mesh, const TetView& view) {
  physgen::detail::for_each_index<4>(0, static_cast<index_t>(mesh.tets.size()), [&](index_t t) {
    const auto& tet = mesh.tets[static_cast<std::size_t>(t)];
    for (std::size_t c = 0; c < 4; ++c) view[t].nodes()[static_cast<int>(c)] = tet[c];
  });
}

/// Stores the ends of all edges. @pre a host view of mesh.edges.size() elasticity::Edge
template <class EdgeView>
void store_edges(const TetMesh& mesh, const EdgeView& view) {
  physgen::detail::for_each_index<2>(0, static_cast<index_t>(mesh.edges.size()), [&](index_t e) {
    const auto& edge = mesh.edges[static_cast<std::size_t>(e)];
    for (std::size_t c = 0; c < 2; ++c) view[e].nodes()[static_cast<int>(c)] = edge[c];
  });
}

/// Stores an incidence list. @pre host views of list.first.size() - 1 elasticity::IncidenceRange and of
/// list.entries.size() elasticity::Incidence
template <class RangeView, class IncidenceView>
void store_incidences(const IncidenceList& list, const RangeView& ranges, const IncidenceView& incidences) {
  physgen::detail::for_each_index<2>(0, static_cast<index_t>(list.first.size()) - 1, [&](index_t i) {
    ranges[i].begin() = list.first[static_cast<std::size_t>(i)];
    ranges[i].end() = list.first[static_cast<std::size_t>(i) + 1];
  });
  physgen::detail::for_each_index<2>(0, static_cast<index_t>(list.entries.size()), [&](index_t k) {
    incidences[k].element() = list.entries[static_cast<std::size_t>(k)].element;
    incidences[k].local() = list.entries[static_cast<std::size_t>(k)].local;
  });
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
  physgen::detail::for_each_index<4>(0, static_cast<index_t>(points.size()), [&](index_t n) {
    const Point& point = points[static_cast<std::size_t>(n)];
    for (std::size_t k = 0; k < 3; ++k) view[n].x()[static_cast<int>(k)] = static_cast<Real>(point[k]);
  });
}

}  // namespace physgen::fem
