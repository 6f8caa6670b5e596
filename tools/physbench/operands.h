// Where kernels find their data: which arrays a kernel reads and writes, and these arrays in one layout, storage and
// space.
#pragma once

#include <physgen/array.h>

#include <tuple>
#include <utility>

#include "coalescing.h"
#include "dataset.h"
#include "row.h"

namespace physgen::bench {

/// Input or output that is streamed in order: its layout is what is measured.
template <class Object_, Domain kDomain>
struct Streamed {
  using Object = Object_;
  static constexpr Domain domain = kDomain;
  template <class Measured>
  using Layout = Measured;
};

/// Input or output that is gathered by index or follows nodes: it keeps the layout that suits that.
template <class Object_, Domain kDomain, class Kept = AosPadded>
struct Fixed {
  using Object = Object_;
  static constexpr Domain domain = kDomain;
  template <class Measured>
  using Layout = std::conditional_t<is_traced<Measured>, Traced<Kept>, Kept>;
};

/// The inputs of a kernel, in the order in which it takes them. Each has `of(Dataset&)`, which gives its values.
template <class... Source>
struct Inputs {};

/// The storage formats of the schema. Others are named in schemes.h.
struct SchemaFormats {
  template <class Object, class Space>
  using Formats = FormatsOf<Object, Space>;
};

namespace detail {

template <class Kernel, class Real, class Space, class Layout, class Scheme, class List>
class OperandsOf;

template <class Kernel, class Real, class Space, class Layout, class Scheme, class... Source>
class OperandsOf<Kernel, Real, Space, Layout, Scheme, Inputs<Source...>> {
  template <class Operand>
  using ArrayOf = Array<typename Operand::Object, Real, Space, typename Operand::template Layout<Layout>,
                        typename Scheme::template Formats<typename Operand::Object, Space>>;

 public:
  using Output = ArrayOf<typename Kernel::Output>;

  explicit OperandsOf(Dataset& data)
      : inputs_(load<ArrayOf<Source>>(Source::of(data), data.count(Source::domain, Kernel::Output::domain))...),
        output_(data.count(Kernel::Output::domain, Kernel::Output::domain)) {
    if constexpr (!host_accessible(Space::kind)) synchronize();
  }
  [[nodiscard]] auto kernel() {
    return std::apply(
        [this](const auto&... input) { return Kernel::template make<Real>(input.view()..., output_.view()); }, inputs_);
  }
  [[nodiscard]] Output& output() { return output_; }

 private:
  template <class To, class From>
  static To load(const From& from, index_t count) {
    To to(count);
    copy_first(to.storage(), from.storage(), count);
    return to;
  }

  std::tuple<ArrayOf<Source>...> inputs_;
  Output output_;
};

}  // namespace detail

/// The arrays of one row. Kernel is one of kernels.h, which are all of this form:
///
///   struct DpFromDf {
///     static constexpr const char* name = "dp_from_df";
///     using Reads = Inputs<...>;
///     using Output = Streamed<...>;                               or Fixed; its domain is the kernel's
///     static double bytes(const MeshSizes&, double real);         that it must move, with numbers of `real` bytes
///     template <class Real, class... View> static auto make(const View&... view);  over inputs and output
///   };
template <class Kernel, class Real, class Space, class Layout, class Scheme = SchemaFormats>
using Operands = detail::OperandsOf<Kernel, Real, Space, Layout, Scheme, typename Kernel::Reads>;

/// A kernel's output as it is compared with the reference.
template <class Kernel, class Real>
using Result = Array<typename Kernel::Output::Object, Real, Host, Aosoa<16>>;

/// Bytes that a kernel must read and write, each input read once, whatever the layout.
template <class Kernel, class Real>
double bytes_moved(const Dataset& data) {
  return Kernel::bytes(data.sizes(Kernel::Output::domain), sizeof(Real));
}

/// The part of a row that its kernel and storage decide.
template <class Kernel, class Real>
Row describe(const char* layout, SpaceKind space, const Dataset& data) {
  Row row;
  row.kernel = Kernel::name;
  row.layout = layout;
  row.storage = sizeof(Real) == sizeof(float) ? "float" : "double";
  row.space = name(space);
  row.objects = data.count(Kernel::Output::domain, Kernel::Output::domain);
  row.bytes_per_object = bytes_moved<Kernel, Real>(data) / static_cast<double>(row.objects);
  return row;
}

}  // namespace physgen::bench
