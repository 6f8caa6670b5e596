// What the solver's structs of arrays share.
#pragma once

#include <elasticity.physgen.h>
#include <fem/mesh/mesh_arrays.h>
#include <fem/solver/hierarchy.h>
#include <fem/solver/packed_rows.h>
#include <quasistatic.physgen.h>

namespace physgen::fem {

/// The layout that the schema gives an object type in a space.
template <class Array>
using LayoutOf = typename Array::View::Layout;

/// An array in another space, with the same objects.
template <class Array, class From>
[[nodiscard]] Array moved_to(const From& from) {
  Array array(from.size());
  copy(array, from);
  synchronize();
  return array;
}

/// Bytes of arrays, padding included.
template <class... Arrays>
[[nodiscard]] index_t bytes_of(const Arrays&... arrays) {
  return (index_t{0} + ... + arrays.bytes());
}

}  // namespace physgen::fem
