// A view: what a kernel holds of an array. A trivially copyable value of two words and, for Soa, the pitch.
#pragma once

#include <physgen/cursor.h>
#include <physgen/error.h>
#include <physgen/layout.h>
#include <physgen/space.h>

#include <cassert>
#include <cstdio>
#include <string>

namespace physgen {

/// @tparam Object a generated tag such as elasticity::StressDerivativeObject
/// @tparam Real float or double; const for a read-only view
/// @tparam Layout_ Aos, AosPadded, Soa or Aosoa<W>
/// @tparam Formats_ how the fields are stored: the object's own Formats<Space>, or a struct derived from it
///
/// Objects 0 .. size()-1 are the array's; memory behind them is real up to the next multiple of padding_objects.
/// With PHYSGEN_CHECKED, an index out of range, a null view and a view used from a space that cannot reach its memory
/// are reported: an Error on the host, a message and a trap on the device; values that a storage format cannot hold are
/// counted (losses.h).
template <class Object, class Real, class Layout_, class Formats_>
class View : private Layout_::Pitch {  // a base, because nvcc lays [[no_unique_address]] members out unlike its host
  using Pitch = typename Layout_::Pitch;

 public:
  using Layout = Layout_;
  using Formats = Formats_;
  using Precision = std::remove_const_t<Real>;
  using Byte = std::conditional_t<std::is_const_v<Real>, const std::byte, std::byte>;
  using Record = typename Object::template Record<Precision, Formats>;
  static constexpr int record_bytes = Layout::record_bytes(Record::bytes, Record::alignment);
  static constexpr int lane_bytes =
      Record::alignment < int{sizeof(Precision)} ? Record::alignment : int{sizeof(Precision)};
  template <class I>
  using CursorAt = Cursor<Byte, Layout, RecordSize{Record::bytes, record_bytes, lane_bytes}, I>;
  /// The reference to object(s) under an index of type I, and its value type.
  template <class I>
  using Ref = typename Object::template Ref<Precision, Formats, CursorAt<I>>;
  template <class I>
  using Value = typename Object::template Value<lanes_t<Precision, I>>;

  View() : View(nullptr, 0, 0, SpaceKind::host) {}
  /// @pre base points to the memory of an array of `size` objects with this pitch, in `space`
  /// @param losses where checked builds count what formats could not hold; null elsewhere
  PHYSGEN_FUNCTION View(Byte* base, index_t size, index_t pitch, [[maybe_unused]] SpaceKind space,
                        [[maybe_unused]] Losses* losses = nullptr)
      : Pitch(pitch),
        base_(base),
        size_(size)
#ifdef PHYSGEN_CHECKED
        ,
        space_(space),
        losses_(losses)
#endif
  {
  }

  /// A read-only view of the same objects.
  template <class Mutable>
    requires(std::is_same_v<const Mutable, Real> && !std::is_const_v<Mutable>)
  PHYSGEN_FUNCTION View(const View<Object, Mutable, Layout, Formats>& other)  // NOLINT: implicit, as T* to const T*
      : View(other.data(), other.size(), other.pitch(), other.space()) {}

  [[nodiscard]] PHYSGEN_FUNCTION index_t size() const { return size_; }
  [[nodiscard]] PHYSGEN_FUNCTION Byte* data() const { return base_; }
  [[nodiscard]] PHYSGEN_FUNCTION index_t pitch() const { return Pitch::value(); }
  /// Where the objects lie; known in checked builds only, else host.
  [[nodiscard]] PHYSGEN_FUNCTION SpaceKind space() const {
#ifdef PHYSGEN_CHECKED
    return space_;
#else
    return SpaceKind::host;
#endif
  }

  /// The object at index i; for a Pack or a SIMD batch of indices, the objects at them.
  template <class I>
  [[nodiscard]] PHYSGEN_FUNCTION Ref<I> operator[](I i) const {
    check(i);
    return Ref<I>(CursorAt<I>(base_, *this, i, losses()));
  }
  /// All fields of object(s) i, by value.
  template <class I>
  [[nodiscard]] PHYSGEN_FUNCTION Value<I> get(I i) const {
    return (*this)[i].get();
  }
  /// Stores all fields of object(s) i.
  template <class I>
  PHYSGEN_FUNCTION void put(I i, const Value<I>& value) const {
    (*this)[i].put(value);
  }

 private:
  [[nodiscard]] PHYSGEN_FUNCTION Losses* losses() const {
#ifdef PHYSGEN_CHECKED
    return losses_;
#else
    return nullptr;
#endif
  }
#ifdef PHYSGEN_CHECKED
  template <int W>
  PHYSGEN_FUNCTION static constexpr index_t width_of(Pack<W> /*pack*/) {
    return W;
  }
  template <class I>
  PHYSGEN_FUNCTION void check(const I& i) const {
    if constexpr (std::is_integral_v<I>) {
      check_range(static_cast<index_t>(i), 1);
    } else if constexpr (requires { i.begin; }) {
      check_range(i.begin % width_of(i) == 0 ? i.begin : -1, 1);
    } else {
      for (std::size_t l = 0; l < I::size; ++l) check_range(static_cast<index_t>(i.get(l)), 1);
    }
  }
  PHYSGEN_FUNCTION void check_range(index_t i, index_t count) const {
#ifdef __CUDA_ARCH__
    if (!device_accessible(space_)) {
      printf("physgen: a view of host memory is used on the device; copy the array to Cuda first\n");
      __trap();
    }
    if (base_ == nullptr || i < 0 || i + count > size_) {
      printf("physgen: object %lld of an array of %lld on the device\n", static_cast<long long>(i),
             static_cast<long long>(size_));
      __trap();
    }
#else
    if (!host_accessible(space_)) {
      throw Error(std::string(Object::name) + ": a view of " + physgen::name(space_) +
                  " memory is used on the host; copy the array to Host first");
    }
    if (base_ == nullptr || i < 0 || i + count > size_) {
      throw Error(std::string(Object::name) + ": object " + std::to_string(i) + " of an array of " +
                  std::to_string(size_));
    }
#endif
  }
#else
  template <class I>
  PHYSGEN_FUNCTION void check(const I& /*i*/) const {}
#endif

  Byte* base_;
  index_t size_;
#ifdef PHYSGEN_CHECKED
  SpaceKind space_;
  Losses* losses_;
#endif
};

}  // namespace physgen
