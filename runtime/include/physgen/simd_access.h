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

namespace detail {

/// Whether the processor's own conversion of halves is that of the format: of a power of two, or another factor.
template <class Format, class T>
inline constexpr bool is_half_of_floats =
    format::FromLibrary<Format> && Format::template type<T> == ElementType::half && Format::centre == 0 &&
    std::is_same_v<T, float>;

/// W numbers as they lie in memory, to W numbers to compute with, and back. Loops that compilers turn into packs; where
/// an instruction converts a whole pack, it is named (with a mask of all lanes: of the others' operand g++ warns).
template <class Format, class T, int W>
void decode_lanes(const typename Format::template Stored<T>* stored, T* values) {
#if defined(__F16C__) && defined(__AVX512F__)
  if constexpr (is_half_of_floats<Format, T> && W == 16) {
    const __m512 wide = _mm512_maskz_cvtph_ps(0xffff, _mm256_load_si256(reinterpret_cast<const __m256i*>(stored)));
    return _mm512_store_ps(values, _mm512_mul_ps(wide, _mm512_set1_ps(float(Format::scale))));
  }
#endif
#if defined(__F16C__)
  if constexpr (is_half_of_floats<Format, T> && W == 8) {
    const __m256 wide = _mm256_cvtph_ps(_mm_load_si128(reinterpret_cast<const __m128i*>(stored)));
    return _mm256_store_ps(values, _mm256_mul_ps(wide, _mm256_set1_ps(float(Format::scale))));
  }
#endif
  for (int l = 0; l < W; ++l) values[l] = Format::template decode<T>(stored[l]);
}
template <class Format, class T, int W>
void encode_lanes(const T* values, typename Format::template Stored<T>* stored) {
#if defined(__F16C__) && defined(__AVX512F__)
  if constexpr (is_half_of_floats<Format, T> && W == 16) {
    const __m512 scaled = _mm512_mul_ps(_mm512_load_ps(values), _mm512_set1_ps(float(1 / Format::scale)));
    return _mm256_store_si256(reinterpret_cast<__m256i*>(stored),
                              _mm512_maskz_cvtps_ph(0xffff, scaled, _MM_FROUND_TO_NEAREST_INT));
  }
#endif
#if defined(__F16C__)
  if constexpr (is_half_of_floats<Format, T> && W == 8) {
    const __m256 scaled = _mm256_mul_ps(_mm256_load_ps(values), _mm256_set1_ps(float(1 / Format::scale)));
    return _mm_store_si128(reinterpret_cast<__m128i*>(stored), _mm256_cvtps_ph(scaled, _MM_FROUND_TO_NEAREST_INT));
  }
#endif
  for (int l = 0; l < W; ++l) stored[l] = Format::template encode<T>(values[l]);
}

/// What the SIMD cursors share: references to fields and elements, and formats, from read and write of the derived
/// cursor.
template <class Derived, int W>
class SimdCursor : protected LossSink {
 public:
  template <class T>
  using Lanes = batch_t<T, W>;
  template <class T, int kCount>
  static constexpr bool joins_words = false;

  using LossSink::LossSink;

  template <class Shape, class Format, class T>
  [[nodiscard]] decltype(auto) field(int offset) const {
    if constexpr (Shape::is_scalar) {
      return element<Format, T>(offset);
    } else {
      return FieldRef<Shape, Format, T, Derived>(self().nested(offset));
    }
  }
  template <class Format, class T>
  [[nodiscard]] ElementRef<Format, T, Derived> element(int offset, int k = 0) const {
    return ElementRef<Format, T, Derived>(self(), offset, k);
  }

  template <class Format, class T>
  [[nodiscard]] batch_t<T, W> load(int offset, int k) const {
    using Stored = typename Format::template Stored<T>;
    const int at = offset + k * int{sizeof(Stored)};
    if constexpr (format::is_plain<Format, T>) {
      return self().template read<T>(at);
    } else {
      alignas(64) std::array<Stored, W> stored;
      alignas(64) std::array<T, W> values;
      self().read_lanes(at, stored);
      decode_lanes<Format, T, W>(stored.data(), values.data());
      return batch_t<T, W>::load_aligned(values.data());
    }
  }
  template <class Format, class T>
  void store(int offset, int k, const batch_t<T, W>& value) const {
    using Stored = typename Format::template Stored<T>;
    const int at = offset + k * int{sizeof(Stored)};
    if constexpr (format::is_plain<Format, T>) {
      self().template write<T>(at, value);
    } else {
      alignas(64) std::array<Stored, W> stored;
      alignas(64) std::array<T, W> values;
      value.store_aligned(values.data());
      encode_lanes<Format, T, W>(values.data(), stored.data());
#ifdef PHYSGEN_CHECKED
      for (int l = 0; l < W; ++l) {
        const auto lane = static_cast<std::size_t>(l);
        this->template count<Format, T>(at, values[lane], stored[lane], self().further(l));
      }
#endif
      self().write_lanes(at, stored);
    }
  }
  template <class S>
  void check_rotation([[maybe_unused]] const Eigen::Matrix<S, 3, 3>& R) const {
#ifdef PHYSGEN_CHECKED
    for (int l = 0; l < W; ++l) {
      Eigen::Matrix3d one;
      for (int k = 0; k < 9; ++k) {
        one(k % 3, k / 3) = static_cast<double>(R(k % 3, k / 3).get(static_cast<std::size_t>(l)));
      }
      this->count_rotation(one, self().further(l));
    }
#endif
  }

 private:
  [[nodiscard]] const Derived& self() const { return static_cast<const Derived&>(*this); }
};

}  // namespace detail

/// On the W objects of a pack.
template <class Byte, class Layout, RecordSize kRecord, int W>
class Cursor<Byte, Layout, kRecord, Pack<W>> : public detail::SimdCursor<Cursor<Byte, Layout, kRecord, Pack<W>>, W> {
  using Base = detail::SimdCursor<Cursor, W>;
  using Pitch = typename Layout::Pitch;

 public:
  Cursor(Byte* base, Pitch pitch, Pack<W> pack, Losses* losses)
      : Base(losses, pack.begin),
        tile_(base + pitch.tile(pack.begin) * pitch.value() * kRecord.stored),
        lane_(pitch.lane(pack.begin)),
        pitch_(pitch) {}

  [[nodiscard]] Cursor nested(int offset) const {
    Cursor inner = *this;
    inner.tile_ += offset * pitch_.value();
    inner.advance(offset);
    return inner;
  }

 private:
  friend Base;
  [[nodiscard]] static index_t further(int l) { return l; }

  // As a register.
  template <class T>
  [[nodiscard]] batch_t<T, W> read(int offset) const {
    if constexpr (Layout::contiguous(W)) {
      prefetch<T>(offset);
      return batch_t<T, W>::load_unaligned(address<T>(offset, 0));
    } else {
      alignas(64) std::array<T, W> lanes;
      read_lanes(offset, lanes);
      return batch_t<T, W>::load_aligned(lanes.data());
    }
  }
  template <class T>
  void write(int offset, const batch_t<T, W>& value) const {
    static_assert(!std::is_const_v<Byte>, "this array is read-only here");
    if constexpr (Layout::contiguous(W)) {
      value.store_unaligned(address<T>(offset, 0));
    } else {
      alignas(64) std::array<T, W> lanes;
      value.store_aligned(lanes.data());
      write_lanes(offset, lanes);
    }
  }

  // As memory.
  template <class T>
  void read_lanes(int offset, std::array<T, W>& lanes) const {
    if constexpr (Layout::contiguous(W)) {
      prefetch<T>(offset);
      std::memcpy(lanes.data(), address<T>(offset, 0), sizeof lanes);
    } else {
      PHYSGEN_UNROLL
      for (int l = 0; l < W; ++l) lanes[static_cast<std::size_t>(l)] = *address<T>(offset, l);
    }
  }
  template <class T>
  void write_lanes(int offset, const std::array<T, W>& lanes) const {
    static_assert(!std::is_const_v<Byte>, "this array is read-only here");
    if constexpr (Layout::contiguous(W)) {
      std::memcpy(address<T>(offset, 0), lanes.data(), sizeof lanes);
    } else {
      PHYSGEN_UNROLL
      for (int l = 0; l < W; ++l) *address<T>(offset, l) = lanes[static_cast<std::size_t>(l)];
    }
  }

  // Kernels stream, but over more arrays, with more skipped channels, than hardware prefetchers follow: the line that a
  // later pack will load is asked for now. Measured: dP from dF over Aosoa<16> 8.2 ms instead of 11.7, over
  // Aosoa<32> 9.2 instead of 17.5; one, three or four packs ahead are slower. The line may lie behind the array:
  // prefetches do not fault.
  template <class T>
  void prefetch(int offset) const {
    constexpr index_t packs_ahead = 2;
    constexpr index_t pack_bytes = index_t{W} * (Layout::contiguous(1 << 20) ? int{sizeof(T)} : kRecord.stored);
    __builtin_prefetch(reinterpret_cast<const std::byte*>(address<T>(offset, 0)) + packs_ahead * pack_bytes);
  }

  // A pack never crosses the end of a tile that holds it whole; in narrower tiles lane l lies some tiles further on.
  template <class T>
  [[nodiscard]] auto* address(int offset, int l) const {
    using Element = std::conditional_t<std::is_const_v<Byte>, const T, T>;
    if constexpr (Layout::contiguous(W)) {
      return reinterpret_cast<Element*>(tile_ + offset * pitch_.value()) + lane_ + l;
    } else {
      Byte* tile = tile_ + pitch_.tile(l) * pitch_.value() * kRecord.stored;
      return reinterpret_cast<Element*>(tile + offset * pitch_.value()) + pitch_.lane(l);
    }
  }

  Byte* tile_;
  index_t lane_;
  Pitch pitch_;
};

/// On W objects gathered by index.
template <class Byte, class Layout, RecordSize kRecord, class U, class A>
class Cursor<Byte, Layout, kRecord, xsimd::batch<U, A>>
    : public detail::SimdCursor<Cursor<Byte, Layout, kRecord, xsimd::batch<U, A>>,
                                static_cast<int>(xsimd::batch<U, A>::size)> {
  static constexpr int W = static_cast<int>(xsimd::batch<U, A>::size);
  using Base = detail::SimdCursor<Cursor, W>;
  using Pitch = typename Layout::Pitch;

 public:
  Cursor(Byte* base, Pitch pitch, const xsimd::batch<U, A>& index, Losses* losses)
      : Base(losses, 0), base_(base), pitch_(pitch) {
    index.store_aligned(index_.data());
  }

  [[nodiscard]] Cursor nested(int offset) const {
    Cursor inner = *this;
    inner.base_ += offset * pitch_.value();
    inner.advance(offset);
    return inner;
  }

 private:
  friend Base;
  [[nodiscard]] index_t further(int l) const { return index_[static_cast<std::size_t>(l)]; }

  template <class T>
  [[nodiscard]] batch_t<T, W> read(int offset) const {
    alignas(64) std::array<T, W> lanes;
    read_lanes(offset, lanes);
    return batch_t<T, W>::load_aligned(lanes.data());
  }
  template <class T>
  void write(int offset, const batch_t<T, W>& value) const {
    alignas(64) std::array<T, W> lanes;
    value.store_aligned(lanes.data());
    write_lanes(offset, lanes);
  }
  template <class T>
  void read_lanes(int offset, std::array<T, W>& lanes) const {
    PHYSGEN_UNROLL
    for (int l = 0; l < W; ++l) lanes[static_cast<std::size_t>(l)] = *address<T>(offset, l);
  }
  // Lane by lane in order: of equal indices the last lane wins.
  template <class T>
  void write_lanes(int offset, const std::array<T, W>& lanes) const {
    static_assert(!std::is_const_v<Byte>, "this array is read-only here");
    for (int l = 0; l < W; ++l) *address<T>(offset, l) = lanes[static_cast<std::size_t>(l)];
  }

  template <class T>
  [[nodiscard]] auto* address(int offset, int l) const {
    using Element = std::conditional_t<std::is_const_v<Byte>, const T, T>;
    const index_t i = index_[static_cast<std::size_t>(l)];
    Byte* tile = base_ + pitch_.tile(i) * pitch_.value() * kRecord.stored;
    return reinterpret_cast<Element*>(tile + offset * pitch_.value()) + pitch_.lane(i);
  }

  Byte* base_;
  Pitch pitch_;
  alignas(64) std::array<U, W> index_;
};

}  // namespace physgen
