// The arrays of a kernel of variants.h: inputs or outputs in one layout, precision and space.
#pragma once

#include <physgen/array.h>

#include <tuple>
#include <utility>

#include "variants.h"

namespace physgen::bench {

namespace detail {
template <class List, class Real, class Space, class Layout>
struct ArraysOf;
template <class... Object, class Real, class Space, class Layout>
struct ArraysOf<Objects<Object...>, Real, Space, Layout> {
  using type = std::tuple<Array<Object, Real, Space, Layout>...>;
};
}  // namespace detail

/// A tuple with an array for each of Objects<...>.
template <class List, class Real, class Space, class Layout>
using Arrays = typename detail::ArraysOf<List, Real, Space, Layout>::type;

/// The form in which inputs are made and outputs are checked.
template <class List, class Real>
using HostArrays = Arrays<List, Real, Host, Aosoa<16>>;

/// Calls visit for each of a tuple's arrays.
template <class Tuple, class Visit>
void for_each_array(Tuple& arrays, const Visit& visit) {
  std::apply([&visit](auto&... array) { (visit(array), ...); }, arrays);
}

template <class Tuple>
Tuple make_arrays(index_t size) {
  Tuple arrays;
  for_each_array(arrays, [size](auto& array) { array.resize(size); });
  return arrays;
}

/// The first `count` objects, between any layouts and spaces. Waits.
template <class To, class From>
void copy_arrays(To& to, const From& from, index_t count) {
  [&]<std::size_t... k>(std::index_sequence<k...> /*which*/) {
    (copy_first(std::get<k>(to).storage(), std::get<k>(from).storage(), count), ...);
  }(std::make_index_sequence<std::tuple_size_v<To>>());
  synchronize();
}

/// The kernel over its arrays.
template <class Variant, class Real, class Inputs, class Outputs>
auto kernel_over(const Inputs& inputs, Outputs& outputs) {
  return std::apply(
      [&](const auto&... input) {
        return std::apply(
            [&](auto&... output) { return Variant::template make<Real>(input.view()..., output.view()...); }, outputs);
      },
      inputs);
}

/// Bytes that a kernel must move for `objects` objects.
template <class Variant, class Real>
double bytes_moved(index_t objects) {
  return static_cast<double>(objects) * Variant::numbers * sizeof(Real);
}

}  // namespace physgen::bench
