// Functions to fill and read the solver's arrays.
#pragma once

#include <elasticity.physgen.h>
#include <fem/mesh/mesh_arrays.h>
#include <fem/solver/arrays/packed_rows.h>
#include <fem/solver/hierarchy/hierarchy.h>
#include <fem/solver/settings.h>
#include <quasistatic.physgen.h>

namespace physgen::fem {

/// An array in another space, with the same objects.
template <class Array, class From>
[[nodiscard]] Array moved_to(const From& from) {
  Array array(from.size());
  copy(array, from);
  synchronize();
  return array;
}

/// Fills an array from one that may go afterwards, on the host. @pre both have as many objects
template <class Array, class From>
void put(Array& array, const From& from) {
  copy(array, from);
  synchronize();
}

/// Fills an array by store(i, object) for each of its objects, on several threads; in place where the host reaches it.
template <class Array, class Store>
void put_each(Array& array, const Store& store) {
  if constexpr (host_accessible(Array::View::Space::kind)) {
    const auto view = contents_of(array).view();
    physgen::detail::for_each_index(0, array.size(), [&](index_t i) { store(i, view[i]); });
  } else {
    using Object = typename Array::Object;
    physgen::Array<Object, typename Array::Precision, Host, Aos, FormatsOf<Object, Host>> host(array.size());
    put_each(host, store);
    put(array, host);
  }
}

/// By which lists the parts of the tangent that patches and tets have are summed, beside the tets of each node.
enum class TangentLists {
  of_edges,  ///< tets and patches of each edge: the assembled tangent
  of_nodes,  ///< patches of each node: sums at nodes of a product without blocks of edges, and nodes' blocks
  none,      ///< such a product by atomics, without nodes' blocks
};
template <class Space>
[[nodiscard]] TangentLists tangent_lists(const NewtonSettings& settings) {
  if (settings.product == Product::assembled) return TangentLists::of_edges;
  const bool blocks = asks_for(settings.preconditioner.kind, asks::inverses);
  return blocks || Space::kind == SpaceKind::host ? TangentLists::of_nodes : TangentLists::none;
}

}  // namespace physgen::fem
