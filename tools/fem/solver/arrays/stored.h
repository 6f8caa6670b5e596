// The ways in which preconditioners store their matrices: choices for the groups of solver_groups.h.
#pragma once

#include <elasticity.physgen.h>
#include <physgen/format/half.h>
#include <physgen/scenes/scene_arrays.h>
#include <quasistatic.physgen.h>

#include <type_traits>

namespace physgen::fem {

namespace detail {

/// Blocks that are gathered are records on CUDA: from tiles a block is read from nine places. Of corner forces a node
/// gathers three numbers, or nine, of many tets at once, which nvcc does with one array for each number, and not with
/// tiles (add_corners(), corner_sums.h).
template <class Tag, class Array>
auto as_computed() {
  constexpr bool on_cuda = Array::View::Space::kind == SpaceKind::cuda;
  constexpr bool gathered = is_named<Tag>("level.edge_stiffness") || is_named<Tag>("schwarz.pair_stiffness");
  if constexpr (gathered && on_cuda) {
    return std::type_identity<WithLayout<Array, Aos>>();
  } else if constexpr (is_named<Tag>("chunk.corners") && on_cuda) {
    return std::type_identity<WithLayout<Array, Soa>>();
  } else {
    return std::type_identity<Array>();
  }
}

template <class Formats>
struct EdgesInHalf : Formats {
  using E = format::Half<>;
};
template <class Formats>
struct FactorsInHalf : Formats {
  using W = format::Half<>;
};
template <class Tag, class Array>
auto in_half() {
  using Formats = typename Array::Formats;
  if constexpr (is_named<Tag>("level.scaled_edges")) {
    return std::type_identity<WithFormats<Array, EdgesInHalf<Formats>>>();
  } else if constexpr (is_named<Tag>("schwarz.factors")) {
    return std::type_identity<WithFormats<Array, FactorsInHalf<Formats>>>();
  } else {
    return as_computed<Tag, Array>();
  }
}

}  // namespace detail

/// The blocks of edges, and the factors of preconditioners' blocks, as they are computed.
struct StoredAsComputed {
  static constexpr bool rounds = false;
  template <class Tag, class Array>
  using Of = typename decltype(detail::as_computed<Tag, Array>())::type;
};
/// In half. Blocks of edges are scaled to a unit diagonal; what they lose is added to those of nodes
/// (KeepTranslations): without that, nearly incompressible bodies take a tenth more iterations, with it none.
struct StoredInHalf {
  static constexpr bool rounds = true;
  using Edge = format::Half<>;  ///< of their blocks
  template <class Tag, class Array>
  using Of = typename decltype(detail::in_half<Tag, Array>())::type;
};

}  // namespace physgen::fem
