// Linear interpolation from the next coarser level, for kernels: what a node takes of its parents, and what of it its
// parents are given.
#pragma once

#include <fem/numerics/scalar.h>
#include <fem/solver/arrays/packed_rows.h>

namespace physgen::fem {

/// Between nested meshes: a node lies half-way between two parents, or coincides with both.
template <class ParentsView>
struct HalfWay {
  ParentsView parents;  ///< quasistatic::NodeParents

  /// @param child of a coarse node: ChildEntry
  template <class Scalar, class Entry>
  PHYSGEN_FUNCTION Scalar weight(const Entry& child) const {
    const int same = ChildEntry::local(child);
    return Scalar(0.5) * Scalar(same);
  }
  template <class Scalar, class ValueOf>
  PHYSGEN_FUNCTION Vector3<Scalar> value(SingleObject auto node, const ValueOf& value_of) const {
    const auto names = parents[node].nodes();
    const index_t first = names[0], second = names[1];
    const Vector3<Scalar> a = value_of(first), b = value_of(second);
    return (a + b) * Scalar(0.5);
  }
};

/// In a tet of a background grid.
template <class ParentsView>
struct InGrid {
  ParentsView parents;  ///< quasistatic::GridParents

  /// @param child of a coarse node: ChildEntry
  template <class Scalar, class Entry>
  PHYSGEN_FUNCTION Scalar weight(const Entry& child) const {
    const index_t node = ChildEntry::element(child);
    const int which = ChildEntry::local(child);
    return parents[node].weights()[which];
  }
  template <class Scalar, class ValueOf>
  PHYSGEN_FUNCTION Vector3<Scalar> value(SingleObject auto node, const ValueOf& value_of) const {
    const auto names = parents[node].nodes();
    const auto weights = parents[node].weights();
    Vector3<Scalar> sum = Vector3<Scalar>::Zero();
    for (int k = 0; k < 4; ++k) {
      const index_t parent = names[k];
      const Vector3<Scalar> part = value_of(parent);
      sum += part * Scalar(weights[k]);
    }
    return sum;
  }
};

/// Calls use(interpolation) with that of a level's nodes. @pre there is a coarser level
template <class Level, class Use>
void with_interpolation(const Level& level, const Use& use) {
  if constexpr (Level::Choices::grids) {
    if (level.lies_in_grid) return use(InGrid{level.grid_parents.const_view()});
  }
  use(HalfWay{level.parents.const_view()});
}

}  // namespace physgen::fem
