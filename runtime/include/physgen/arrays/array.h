// The object array: objects of one generated type in one layout and one memory space, with an object count and a pitch.
#pragma once

#include <physgen/arrays/array_losses.h>
#include <physgen/arrays/array_memory.h>
#include <physgen/arrays/copy.h>
#include <physgen/arrays/initial_values.h>
#include <physgen/arrays/object_iterator.h>
#include <physgen/arrays/single_elements.h>
#include <physgen/arrays/view.h>
#include <physgen/detail/copy_fields.h>
#include <physgen/detail/declared_array.h>
#include <physgen/device.h>
#include <physgen/fields/record.h>
#include <physgen/memory/buffer.h>

#include <algorithm>

namespace physgen {

/// @tparam Object_ a generated tag such as elasticity::StressDerivativeObject
/// @tparam Real float or double: the precision of the scene
/// @tparam Space_ Host, PinnedHost or Cuda
/// @tparam Layout_ Aos, AosPadded, Soa or Aosoa<W>
/// @tparam Formats_ how the fields are stored: what the schema says for the space, or a struct derived from it that
/// redeclares some: `struct Compact : DeformationSvdFormats<Cuda> { using U = format::Quaternion<>; };`
template <class Object_, class Real, class Space_, class Layout_, class Formats_>
class Array : private detail::ArrayMemory {
 public:
  using Object = Object_;
  using Precision = Real;
  using Space = Space_;
  using Layout = Layout_;
  using Formats = Formats_;
  using View = physgen::View<Object, Real, Layout, Formats, Space>;
  using ConstView = physgen::View<Object, const Real, Layout, Formats, Space>;
  /// The value of one object.
  using Value = typename Object::template Value<Real>;
  static constexpr int record_bytes = View::record_bytes;
  /// Elements of one object, as code sees them.
  static constexpr int elements = element_count(Object::template fields<Real, Formats>);

  Array() = default;
  /// `size` objects with their fields' initial values (zero where the schema states none; a Rotation is the identity).
  /// Where the schema states none and Formats of a program's own have a range without zero, which a schema is refused
  /// for, new objects hold the end of the range that is nearest to it.
  /// @throw Error when size is negative, the memory cannot be had, or a format cannot hold the initial value of its
  /// field
  explicit Array(index_t size) { resize(size); }
  /// On CUDA and in pinned memory this works in the default stream. @pre work on `other` in other streams is done (see
  /// synchronize())
  Array(const Array& other) : ArrayMemory() { copy_of(kind, other); }
  Array(Array&& other) noexcept { swap(other); }
  Array& operator=(Array other) noexcept {
    swap(other);
    return *this;
  }
  ~Array() = default;

  [[nodiscard]] index_t size() const { return size_; }
  /// Objects for which there is memory without a change of it: size() or more.
  [[nodiscard]] index_t capacity() const { return capacity_; }
  [[nodiscard]] index_t pitch() const { return Layout::pitch(capacity_); }
  /// Bytes of memory held, padding included.
  [[nodiscard]] index_t bytes() const { return buffer_.bytes(); }

  /// The view that kernels are given. Valid until the array is resized, moved from or destroyed.
  [[nodiscard]] View view() { return {buffer_.data(), size_, pitch(), losses()}; }
  [[nodiscard]] ConstView view() const { return {buffer_.data(), size_, pitch(), losses()}; }
  [[nodiscard]] ConstView const_view() const { return view(); }

  /// The object at index i, or those under a SIMD index, as a view gives it; on the host. A loop takes references by
  /// value: `for (auto object : array) object.pressure() = 0;`. Kernels hold a view.
  template <class Index>
  [[nodiscard]] auto operator[](Index&& i) {
    return host_view()[std::forward<Index>(i)];
  }
  template <class Index>
  [[nodiscard]] auto operator[](Index&& i) const {
    return host_view()[std::forward<Index>(i)];
  }
  [[nodiscard]] auto begin() { return ObjectIterator(host_view(), 0); }
  [[nodiscard]] auto end() { return ObjectIterator(host_view(), size_); }
  [[nodiscard]] auto begin() const { return ObjectIterator(host_view(), 0); }
  [[nodiscard]] auto end() const { return ObjectIterator(host_view(), size_); }

  /// The array without its types, for copy().
  [[nodiscard]] UntypedArray untyped() const { return ArrayMemory::untyped(kind); }

  /// Counts of the values that formats could not hold when kernels stored here, since this was last called; all zero in
  /// builds that are not checked. On CUDA it waits for the device. See throw_if_falsified().
  [[nodiscard]] Losses take_losses() {
    return checked_build && size_ > 0 ? physgen::take_losses(*losses(), size_, Space::kind) : Losses();
  }

  /// Changes the number of objects. The first min(old, new) keep their values, new ones get initial values. Up to
  /// capacity() objects the memory stays, and fewer objects keep it all; more get memory for as many as asked for.
  /// On CUDA and in pinned memory this works in the default stream. @pre work on this array in other streams is done
  /// (see synchronize())
  /// @throw Error as the constructor does; the array is then unchanged
  void resize(index_t size) { ArrayMemory::resize(kind, size); }

  /// Gets memory for `capacity` objects or more, so that the array has as many before it needs other memory.
  /// @throw Error as the constructor does; the array is then unchanged
  void reserve(index_t capacity) {
    if (capacity > capacity_) replace(kind, capacity, size_);
  }
  /// Gives back the memory that no object needs.
  void shrink_to_fit() {
    if (capacity_ > size_) replace(kind, size_, size_);
  }

  /// Adds one object at the end, on the host; in pinned memory it waits for the default stream. Where there is no
  /// memory for it, the array gets memory for half as many objects again and moves there, so that n calls move fewer
  /// than 3 n objects. It ends the array's views.
  /// @pre work on this array in other streams is done (see synchronize())
  /// @throw Error as the constructor does; the array is then unchanged
  void push_back(const Value& value) {
    detail::wait_for_host_work(Space::kind);
    if (size_ == capacity_) reserve(std::max(size_ + size_ / 2, padding_objects));
    const index_t end = Layout::padded(size_ + 1);
    if (end > used_) {
      used_ = end;
    } else if (end > Layout::padded(size_)) {
      reset(untyped(), size_, end);
    }
    set_size(kind, size_ + 1);
    host_view().put(size_ - 1, value);
  }

  /// In checked builds, takes the counts of an array whose place this one will take, and leaves that one's as they are.
  void inherit_losses(const Array& old) { ArrayMemory::inherit_losses(kind, old); }

  /// Element k (in the order of the fields) of object i, through one interface for all types and spaces: for setting
  /// up, looking and testing; kernels use views. On CUDA each call is a transfer.
  /// @throw Error when i or k is out of range
  [[nodiscard]] double getdata(index_t i, int k) const { return physgen::getdata(untyped(), i, k); }
  void putdata(index_t i, int k, double value) { physgen::putdata(untyped(), i, k, value); }

  void swap(Array& other) noexcept { ArrayMemory::swap(other); }

 private:
  static constexpr detail::MemoryKind kind{Space::kind,    record_bytes, &Layout::padded,
                                           &Layout::pitch, Object::name, Object::template fields<Real, Formats>};

  [[nodiscard]] Losses* losses() const { return ArrayMemory::losses(kind); }

  template <class Self>
  [[nodiscard]] static auto host_view_of(Self& self) {
    static_assert(host_accessible(Space::kind),
                  "an array in Cuda memory is not reached on the host: copy it to an array in Host, or give its view() "
                  "to a kernel");
    return self.view();
  }
  [[nodiscard]] auto host_view() { return host_view_of(*this); }
  [[nodiscard]] auto host_view() const { return host_view_of(*this); }
};

namespace detail {

/// The size of an array that holds no object of its own. @throw Error when it is negative
inline index_t checked_size(std::string_view object, index_t size) {
  if (size >= 0) return size;
  throw Error(std::string(object) + ": an array of " + std::to_string(size) +
              " objects cannot exist; it has 0 or more of them");
}

}  // namespace detail

/// Bytes of memory that arrays hold, padding included.
template <class... Arrays>
[[nodiscard]] index_t bytes_of(const Arrays&... arrays) {
  return (index_t{0} + ... + arrays.bytes());
}

/// Copies all objects between any two arrays of one object type: layouts, storage formats, precisions and spaces may
/// differ. Fields that `to` prunes are left out; where `from` does not store a field that `to` has, or `to` stores
/// nothing of one without pruning it (format/nothing.h), this does not compile.
/// What is written comes first; a const array is read alone, and so is a read-only view, copy(to, from.const_view()),
/// which makes a swapped call an error of the compiler.
/// See copy(const UntypedArray&, const UntypedArray&, Stream) for order and errors.
template <class Object, class RealTo, class SpaceTo, class LayoutTo, class FormatsTo, class RealFrom, class SpaceFrom,
          class LayoutFrom, class FormatsFrom>
void copy(Array<Object, RealTo, SpaceTo, LayoutTo, FormatsTo>& to,
          const Array<Object, RealFrom, SpaceFrom, LayoutFrom, FormatsFrom>& from, Stream stream = nullptr) {
  detail::require_copied_fields<Object, FormatsTo, FormatsFrom>();
  copy(to.untyped(), from.untyped(), stream);
}
template <class Object, class RealTo, class SpaceTo, class LayoutTo, class FormatsTo, class RealFrom, class SpaceFrom,
          class LayoutFrom, class FormatsFrom>
void copy(Array<Object, RealTo, SpaceTo, LayoutTo, FormatsTo>& to,
          const View<Object, const RealFrom, LayoutFrom, FormatsFrom, SpaceFrom>& from, Stream stream = nullptr) {
  detail::require_copied_fields<Object, FormatsTo, FormatsFrom>();
  copy(to.untyped(), from.untyped(), stream);
}

// To what is read only they do not compile.
template <class To, class From>
  requires(!std::is_lvalue_reference_v<To> || std::is_const_v<std::remove_reference_t<To>>) &&
          requires { typename std::remove_cvref_t<To>::ConstView; }
void copy(To&& /*to*/, const From& /*from*/, Stream /*stream*/ = nullptr) {
  static_assert(std::is_void_v<From>,
                "copy(to, from): the array that is written comes first, and this one is const or a temporary");
}
template <class Object, class RealTo, class SpaceTo, class LayoutTo, class FormatsTo, class From>
void copy(const View<Object, RealTo, LayoutTo, FormatsTo, SpaceTo>& /*to*/, const From& /*from*/,
          Stream /*stream*/ = nullptr) {
  static_assert(std::is_void_v<From>, "copy(to, from): what is written comes first, and it is an array, not a view");
}

}  // namespace physgen
