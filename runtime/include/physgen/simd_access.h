// SIMD access on the CPU: cursors that stand on the W objects of a Pack, or on W objects gathered by an index batch,
// and hand out xsimd batches. Included by host translation units only.
#pragma once

#include <physgen/cursor.h>
#include <physgen/simd.h>

#include <array>
#include <cstring>

namespace physgen {

namespace detail {

template <class T, int W>
struct SizedBatch {
  using type = typename xsimd::make_sized_batch<T, static_cast<std::size_t>(W)>::type;
  static_assert(
      !std::is_void_v<type>,
      "this CPU has no SIMD register of W lanes of T (a double field in a float pack?): give parallel_for fewer "
      "lanes, parallel_for<W / 2>(...), or parallel_for<1>(...)");
};

}  // namespace detail

/// The SIMD batch of W lanes of T.
template <class T, int W>
using batch_t = typename detail::SizedBatch<std::remove_cv_t<T>, W>::type;

/// Lanes of the widest SIMD register for T.
template <class T>
inline constexpr int native_lanes = static_cast<int>(xsimd::batch<T>::size);

template <class T, int W>
struct Lanes<T, Pack<W>> {
  using type = batch_t<T, W>;
};
template <class T, class U, class A>
struct Lanes<T, xsimd::batch<U, A>> {
  using type = batch_t<T, static_cast<int>(xsimd::batch<U, A>::size)>;
};
template <class S, class A, class T>
struct SameLanes<xsimd::batch<S, A>, T> {
  using type = batch_t<T, static_cast<int>(xsimd::batch<S, A>::size)>;
};

/// Stand-in for one element of W objects: converts to a batch and takes one by assignment.
template <class T, class Cursor>
class ElementRef {
 public:
  using Batch = typename Cursor::template Lanes<T>;
  ElementRef(const Cursor& at, int offset) : at_(at), offset_(offset) {}
  ElementRef(const ElementRef&) = default;
  ~ElementRef() = default;

  [[nodiscard]] Batch get() const { return at_.template load<T>(offset_); }
  operator Batch() const { return get(); }  // NOLINT: implicit as a reference's conversion is
  const ElementRef& operator=(const Batch& value) const {
    at_.template store<T>(offset_, value);
    return *this;
  }
  const ElementRef& operator=(const ElementRef& other) const { return *this = other.get(); }

 private:
  Cursor at_;
  int offset_;
};

namespace detail {

/// What the SIMD cursors share: references to fields and nested cursors, from load and store of the derived cursor.
template <class Derived, int W>
class SimdCursor {
 public:
  template <class T>
  using Lanes = batch_t<T, W>;

  template <class Shape, class T>
  [[nodiscard]] decltype(auto) field(int offset) const {
    if constexpr (Shape::is_scalar) {
      return element<T>(offset);
    } else {
      return FieldRef<Shape, T, Derived>(self().nested(offset));
    }
  }
  template <class T>
  [[nodiscard]] ElementRef<T, Derived> element(int offset, int k = 0) const {
    return ElementRef<T, Derived>(self(), offset + k * static_cast<int>(sizeof(T)));
  }

 private:
  [[nodiscard]] const Derived& self() const { return static_cast<const Derived&>(*this); }
};

}  // namespace detail

/// On the W objects of a pack.
template <class Byte, class Layout, int kRecordBytes, int kLaneBytes, int W>
class Cursor<Byte, Layout, kRecordBytes, kLaneBytes, Pack<W>>
    : public detail::SimdCursor<Cursor<Byte, Layout, kRecordBytes, kLaneBytes, Pack<W>>, W> {
  using Pitch = typename Layout::Pitch;

 public:
  Cursor(Byte* base, Pitch pitch, Pack<W> pack)
      : tile_(base + pitch.tile(pack.begin) * pitch.value() * kRecordBytes),
        lane_(pitch.lane(pack.begin)),
        pitch_(pitch) {}

  template <class T>
  [[nodiscard]] batch_t<T, W> load(int offset) const {
    if constexpr (Layout::contiguous(W)) {
      prefetch<T>(offset);
      return batch_t<T, W>::load_unaligned(address<T>(offset, 0));
    } else {
      alignas(64) std::array<T, W> lanes;
      PHYSGEN_UNROLL
      for (int l = 0; l < W; ++l) lanes[static_cast<std::size_t>(l)] = *address<T>(offset, l);
      return batch_t<T, W>::load_aligned(lanes.data());
    }
  }
  template <class T>
  void store(int offset, const batch_t<T, W>& value) const {
    static_assert(!std::is_const_v<Byte>, "this array is read-only here");
    if constexpr (Layout::contiguous(W)) {
      value.store_unaligned(address<T>(offset, 0));
    } else {
      alignas(64) std::array<T, W> lanes;
      value.store_aligned(lanes.data());
      PHYSGEN_UNROLL
      for (int l = 0; l < W; ++l) *address<T>(offset, l) = lanes[static_cast<std::size_t>(l)];
    }
  }
  [[nodiscard]] Cursor nested(int offset) const {
    Cursor inner = *this;
    inner.tile_ += offset * pitch_.value();
    return inner;
  }

 private:
  // Kernels stream, but over more arrays, with more skipped channels, than hardware prefetchers follow: the line that a
  // later pack will load is asked for now. Measured: dP from dF over Aosoa<16> 8.2 ms instead of 11.7, over
  // Aosoa<32> 9.2 instead of 17.5; one, three or four packs ahead are slower. The line may lie behind the array:
  // prefetches do not fault.
  template <class T>
  void prefetch(int offset) const {
    constexpr index_t packs_ahead = 2;
    constexpr index_t pack_bytes = index_t{W} * (Layout::contiguous(1 << 20) ? int{sizeof(T)} : kRecordBytes);
    __builtin_prefetch(reinterpret_cast<const std::byte*>(address<T>(offset, 0)) + packs_ahead * pack_bytes);
  }

  // A pack never crosses the end of a tile that holds it whole; in narrower tiles lane l lies some tiles further on.
  template <class T>
  [[nodiscard]] auto* address(int offset, int l) const {
    using Element = std::conditional_t<std::is_const_v<Byte>, const T, T>;
    if constexpr (Layout::contiguous(W)) {
      return reinterpret_cast<Element*>(tile_ + offset * pitch_.value()) + lane_ + l;
    } else {
      Byte* tile = tile_ + pitch_.tile(l) * pitch_.value() * kRecordBytes;
      return reinterpret_cast<Element*>(tile + offset * pitch_.value()) + pitch_.lane(l);
    }
  }

  Byte* tile_;
  index_t lane_;
  Pitch pitch_;
};

/// On W objects gathered by index.
template <class Byte, class Layout, int kRecordBytes, int kLaneBytes, class U, class A>
class Cursor<Byte, Layout, kRecordBytes, kLaneBytes, xsimd::batch<U, A>>
    : public detail::SimdCursor<Cursor<Byte, Layout, kRecordBytes, kLaneBytes, xsimd::batch<U, A>>,
                                static_cast<int>(xsimd::batch<U, A>::size)> {
  using Pitch = typename Layout::Pitch;
  static constexpr int W = static_cast<int>(xsimd::batch<U, A>::size);

 public:
  Cursor(Byte* base, Pitch pitch, const xsimd::batch<U, A>& index) : base_(base), pitch_(pitch) {
    index.store_aligned(index_.data());
  }

  template <class T>
  [[nodiscard]] batch_t<T, W> load(int offset) const {
    alignas(64) std::array<T, W> lanes;
    PHYSGEN_UNROLL
    for (int l = 0; l < W; ++l) lanes[static_cast<std::size_t>(l)] = *address<T>(offset, l);
    return batch_t<T, W>::load_aligned(lanes.data());
  }
  /// Lane by lane in order: of equal indices the last lane wins.
  template <class T>
  void store(int offset, const batch_t<T, W>& value) const {
    static_assert(!std::is_const_v<Byte>, "this array is read-only here");
    alignas(64) std::array<T, W> lanes;
    value.store_aligned(lanes.data());
    for (int l = 0; l < W; ++l) *address<T>(offset, l) = lanes[static_cast<std::size_t>(l)];
  }
  [[nodiscard]] Cursor nested(int offset) const {
    Cursor inner = *this;
    inner.base_ += offset * pitch_.value();
    return inner;
  }

 private:
  template <class T>
  [[nodiscard]] auto* address(int offset, int l) const {
    using Element = std::conditional_t<std::is_const_v<Byte>, const T, T>;
    const index_t i = index_[static_cast<std::size_t>(l)];
    Byte* tile = base_ + pitch_.tile(i) * pitch_.value() * kRecordBytes;
    return reinterpret_cast<Element*>(tile + offset * pitch_.value()) + pitch_.lane(i);
  }

  Byte* base_;
  Pitch pitch_;
  alignas(64) std::array<U, W> index_;
};

}  // namespace physgen
