// The views of levels that a V-cycle needs, as a kernel on the device is handed them: under the names of its
// arrays.
#pragma once

#include <fem/kernels/edge_rows.h>
#include <physgen/kernel.h>

#include <cstddef>
#include <utility>

namespace physgen::fem {

/// Stands for an array, or for arrays of rows, where there are only views.
/// @tparam View_ which changes objects, or is the only one
template <class View_, class ConstView>
class ArrayViews {
 public:
  template <class Array>
  explicit ArrayViews(Array& array) : view_(array.view()) {}

  [[nodiscard]] PHYSGEN_FUNCTION const View_& view() const { return view_; }
  [[nodiscard]] PHYSGEN_FUNCTION ConstView const_view() const { return view_; }
  [[nodiscard]] PHYSGEN_FUNCTION index_t size() const { return view_.size(); }

 private:
  View_ view_;
};

/// @tparam Level a LevelOver
template <class Level>
struct LevelViews {
  using Choices = typename Level::Choices;
  template <class Array>
  using Of = ArrayViews<typename Array::View, typename Array::ConstView>;
  template <class Rows>
  using OfRows = ArrayViews<typename Rows::ConstView, typename Rows::ConstView>;

  bool lies_in_grid;
  Of<decltype(Level::constraints)> constraints;
  EdgeRows::View rows;
  Of<decltype(Level::scales)> scales;
  Of<decltype(Level::scaled_nodes)> scaled_nodes;
  Of<decltype(Level::scaled_edges)> scaled_edges;
  Of<decltype(Level::inverse)> inverse;
  Of<decltype(Level::smoother)> smoother;
  Of<decltype(Level::residual)> residual;
  Of<decltype(Level::correction)> correction;
  Of<decltype(Level::direction)> direction;
  Of<decltype(Level::parents)> parents;
  Of<decltype(Level::grid_parents)> grid_parents;
  OfRows<decltype(Level::children)> children;
  Of<decltype(Level::coarse_inverse)> coarse_inverse;

  explicit LevelViews(Level& level)
      : lies_in_grid(level.lies_in_grid),
        constraints(level.constraints),
        rows(level.rows.view()),
        scales(level.scales),
        scaled_nodes(level.scaled_nodes),
        scaled_edges(level.scaled_edges),
        inverse(level.inverse),
        smoother(level.smoother),
        residual(level.residual),
        correction(level.correction),
        direction(level.direction),
        parents(level.parents),
        grid_parents(level.grid_parents),
        children(std::as_const(level.children)),
        coarse_inverse(level.coarse_inverse) {}

  [[nodiscard]] PHYSGEN_FUNCTION index_t nodes() const { return constraints.size(); }
};

/// Whether the levels from l on all have rows, and at most so many nodes: the finest level of a background grid may
/// have more than the mesh that lies in it. @param levels finest first
template <class Levels>
[[nodiscard]] bool are_small(const Levels& levels, std::size_t l, index_t most_nodes) {
  for (; l < levels.size(); ++l) {
    if (levels[l]->nodes() > most_nodes || levels[l]->rows.is_empty()) return false;
  }
  return true;
}

}  // namespace physgen::fem
