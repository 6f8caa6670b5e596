// Arrays for programs whose reads and writes are looked for: they have no objects in memory.
#pragma once

#include <physgen/arrays/view.h>
#include <physgen/probe/access_format.h>
#include <physgen/rows.h>

namespace physgen {

/// Has the members of an Array that programs give to kernels.
/// @tparam Formats_ XProbe<ArrayTag, Base> of the generated code, or a struct derived from it
template <class Object_, class Real, class Layout, class Formats_, class Space = Host>
class ProbeArray {
  static_assert(format::are_probes<Formats_>, "a ProbeArray has the formats XProbe<ArrayTag, Base> of its object");

 public:
  using Object = Object_;
  using Formats = Formats_;
  using View = physgen::View<Object, Real, Layout, Formats, Space>;
  using ConstView = physgen::View<Object, const Real, Layout, Formats, Space>;
  using Value = typename Object::template Value<Real>;

  /// @param size returned by size()
  explicit ProbeArray(index_t size = 1) : size_(size) {}

  [[nodiscard]] index_t size() const { return size_; }
  [[nodiscard]] View view() {
    give();
    return {nullptr, size_, Layout::pitch(size_)};
  }
  [[nodiscard]] ConstView view() const { return const_view(); }
  [[nodiscard]] ConstView const_view() const {
    give();
    return {nullptr, size_, Layout::pitch(size_)};
  }

 private:
  // To kernels that the compiler of the host may not see.
  static void give() {
#if defined(__NVCC__) && !defined(__CUDA_ARCH__)
    if constexpr (Space::kind == SpaceKind::cuda) (void)&probe::detail::DeviceArray<typename Formats::array_>::array;
#endif
  }

  index_t size_;
};

namespace detail {

template <class Of, class Formats>
struct ArrayStoredAs;  // detail/array_stored_as.h

template <class Object, class Real, class Layout, class Formats, class Space, class Others>
struct ArrayStoredAs<ProbeArray<Object, Real, Layout, Formats, Space>, Others> {
  using type = ProbeArray<Object, Real, Layout, Formats, Space>;
};

}  // namespace detail

/// The probe that stands for an Array: of the same object type, precision, layout, space and formats.
template <class Array, class ArrayTag>
using ProbeOf =
    ProbeArray<typename Array::Object, typename Array::Precision, typename Array::Layout,
               typename Array::Object::template Probe<ArrayTag, typename Array::Formats>, typename Array::Space>;

/// Has the members of RowArrays that programs give to kernels.
/// @tparam Ranges a ProbeArray of objects with `Index begin, end`
/// @tparam Entries a ProbeArray of any objects
template <class Ranges, class Entries>
class ProbeRows {
 public:
  using View = Rows<typename Ranges::ConstView, typename Entries::View>;
  using ConstView = Rows<typename Ranges::ConstView, typename Entries::ConstView>;

  /// @param targets how many objects the entries may name
  explicit ProbeRows(index_t size = 1, index_t targets = 1) : ranges_(size), targets_(targets) {}

  [[nodiscard]] index_t size() const { return ranges_.size(); }
  [[nodiscard]] const Ranges& ranges() const { return ranges_; }
  [[nodiscard]] const Entries& entries() const { return entries_; }
  [[nodiscard]] View view() { return {ranges_.const_view(), entries_.view(), targets_}; }
  [[nodiscard]] ConstView view() const { return const_view(); }
  [[nodiscard]] ConstView const_view() const { return {ranges_.const_view(), entries_.const_view(), targets_}; }

 private:
  Ranges ranges_;
  Entries entries_;
  index_t targets_;
};

}  // namespace physgen
