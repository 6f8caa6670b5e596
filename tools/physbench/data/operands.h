// The names of a kernel's arrays, and these arrays in one layout, storage and space.
#pragma once

#include <physgen/arrays/array.h>

#include <concepts>
#include <tuple>
#include <utility>

#include "data/scene.h"

namespace physgen::bench {

/// The layout of an array that is not measured, in a row that measures another one. (coalescing/trace.h traces both.)
template <class Measured, class Kept>
struct KeptBeside {
  using type = Kept;
};

/// An array that is streamed in order: its layout is what is measured.
template <class Source_>
struct Streamed {
  using Source = Source_;
  template <class Measured, class Space>
  using Layout = Measured;
};
/// An array that is gathered by index or follows nodes: it keeps the layout that suits that.
template <class Source_, class Kept = AosPadded>
struct Gathered {
  using Source = Source_;
  template <class Measured, class Space>
  using Layout = typename KeptBeside<Measured, Kept>::type;
};
/// An array that keeps tiles as wide as a pack or a warp, beside others that are measured.
template <class Source_>
struct Tiled {
  using Source = Source_;
  template <class Measured, class Space>
  using Layout = typename KeptBeside<Measured, PerSpace<Space, Aosoa<16>, Aosoa<32>>>::type;
};

/// The inputs, or the outputs, of a kernel in the order in which it takes them.
template <class... Operand>
struct Operands {};

/// The source of an input that another kernel writes. Its values are that kernel's reference in double.
template <class Kernel>
struct OutputOf {
  using Object = typename Kernel::Output;
  static constexpr Domain domain = Kernel::domain;
  static const Master<Object>& of(Scene& scene);  ///< measure/scene_errors.h
};

/// The members of a kernel's description; see README.md for all of it.
template <class Kernel>
concept IsKernel = requires {
  { Kernel::name } -> std::convertible_to<const char*>;
  { Kernel::place } -> std::convertible_to<int>;      // in the table
  { Kernel::domain } -> std::convertible_to<Domain>;  // that it runs over
  typename Kernel::Reads;
  typename Kernel::Writes;
};

/// Ends a kernel's file: its description, and where its rows get data from, OnScene or OnSet or both. CMake reads this
/// line and writes the files that compile the rows.
#define PHYSGEN_BENCH_ROWS(Kernel, providers) static_assert(IsKernel<Kernel>)

/// A kernel whose description has its own naive form. Some have none: their problem's reference is another kernel's.
template <class Kernel>
concept HasReference =
    requires(const typename Kernel::Output::template Value<float>& value) { Kernel::template observe<double>(value); };

/// The storage formats of the schema. Others are named in groups/schemes.h.
struct SchemaFormats {
  template <class Object, class Space>
  using Formats = FormatsOf<Object, Space>;
};

namespace detail {

template <class List, class Real, class Space, class Layout, class Scheme>
struct ListOf;
template <class... Operand, class Real, class Space, class Layout, class Scheme>
struct ListOf<Operands<Operand...>, Real, Space, Layout, Scheme> {
  template <class Source, class ArrayLayout>
  using One = Array<typename Source::Object, Real, Space, ArrayLayout,
                    typename Scheme::template Formats<typename Source::Object, Space>>;
  using type = std::tuple<One<typename Operand::Source, typename Operand::template Layout<Layout, Space>>...>;
  using host = std::tuple<Array<typename Operand::Source::Object, Real, Host, Aosoa<16>>...>;
  using masters = std::tuple<const Master<typename Operand::Source::Object>&...>;
  static constexpr Domain domains[] = {Operand::Source::domain...};
};

}  // namespace detail

/// A tuple of the arrays of Operands<...>.
template <class List, class Real, class Space, class Layout, class Scheme = SchemaFormats>
using ArraysOf = typename detail::ListOf<List, Real, Space, Layout, Scheme>::type;
/// The same, in the form in which inputs are made and outputs are checked.
template <class List, class Real>
using HostArrays = typename detail::ListOf<List, Real, Host, Aosoa<16>, SchemaFormats>::host;
/// The scene's arrays of Operands<...>.
template <class List>
using Masters = typename detail::ListOf<List, double, Host, Aosoa<16>, SchemaFormats>::masters;
/// The domain of the k-th of them.
template <class List>
constexpr Domain domain_of(std::size_t k) {
  return detail::ListOf<List, double, Host, Aosoa<16>, SchemaFormats>::domains[k];
}

/// Calls visit(array, k) for each array of a tuple, k being a constant.
template <class Tuple, class Visit>
void for_each_array(Tuple& arrays, const Visit& visit) {
  [&]<std::size_t... k>(std::index_sequence<k...> /*which*/) {
    (visit(std::get<k>(arrays), std::integral_constant<std::size_t, k>()), ...);
  }(std::make_index_sequence<std::tuple_size_v<Tuple>>());
}

/// A tuple of arrays, each of size(k) objects.
template <class Tuple, class Size>
Tuple make_arrays(const Size& size) {
  Tuple arrays;
  for_each_array(arrays, [&size](auto& array, std::size_t k) { array.resize(size(k)); });
  return arrays;
}

/// The first objects of each, as many as fit `to`, between any layouts and spaces. Waits.
template <class To, class From>
void copy_arrays(To& to, const From& from) {
  [&]<std::size_t... k>(std::index_sequence<k...> /*which*/) {
    (copy_range(std::get<k>(to).untyped(), std::get<k>(from).untyped(), 0, std::get<k>(to).size()), ...);
  }(std::make_index_sequence<std::tuple_size_v<To>>());
  synchronize();
}

/// The kernel over its arrays, as the row runs it.
template <class Kernel, class Real, class Inputs, class Outputs>
auto kernel_over(const Inputs& inputs, Outputs& outputs) {
  return std::apply(
      [&](const auto&... input) {
        return std::apply(
            [&](auto&... output) { return Kernel::template run<Real>(input.view()..., output.view()...); }, outputs);
      },
      inputs);
}

}  // namespace physgen::bench
