// SIMD access on the CPU: cursors that stand on the W objects of a Pack or PartialPack, or on W objects gathered by an
// index batch, and hand out xsimd batches. Included by host translation units only.
#pragma once

#include <physgen/cursor.h>
#include <physgen/error.h>
#include <physgen/simd.h>

#include <array>
#include <cstring>
#include <string>

namespace physgen {

namespace detail {

template <class T, int W>
struct SizedBatch {
  using type = typename xsimd::make_sized_batch<T, static_cast<std::size_t>(W)>::type;
  static_assert(
      !std::is_void_v<type>,
      "this CPU has no SIMD register of W lanes of T. Packs are as wide as the kernel's `using Scalar` makes them: let "
      "that be the widest number that the kernel reads, `using Scalar = typename View::Precision;`, or run the kernel "
      "on single objects, parallel_for<1>(...)");
};

}  // namespace detail

/// The SIMD batch of W lanes of T.
template <class T, int W>
using batch_t = typename detail::SizedBatch<std::remove_cv_t<T>, W>::type;

/// Lanes of the widest SIMD register for T.
template <class T>
inline constexpr int native_lanes = static_cast<int>(xsimd::batch<T>::size);

template <class T, int W>
struct Lanes<T, PartialPack<W>> {
  using type = batch_t<T, W>;
};
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

/// The lanes, of an index as wide as W, that the kernel which runs on this thread was called for: gathered indices do
/// not know them, and stores through these leave the others alone. All, outside of kernels and in whole packs of builds
/// that are not checked.
struct RunningLanes {
  LaneRange range;
  int width;

  [[nodiscard]] LaneRange of(int W) const { return W == width ? range : LaneRange{0, W}; }
};
inline thread_local RunningLanes running_lanes{{0, 0}, 0};

/// Sets them until it goes out of scope.
class RunLanes {
 public:
  explicit RunLanes(const RunningLanes& lanes) : before_(running_lanes) { running_lanes = lanes; }
  RunLanes(const RunLanes&) = delete;
  RunLanes& operator=(const RunLanes&) = delete;
  ~RunLanes() { running_lanes = before_; }

 private:
  RunningLanes before_;
};

/// What the SIMD cursors share: references to fields and elements, and formats, from read and write of the derived
/// cursor.
template <class Derived, int W>
class SimdCursor : protected LossSink {
 public:
  template <class T>
  using Lanes = batch_t<T, W>;
  template <class T, int kCount>
  static constexpr bool joins_words = false;
  /// Bits of all W lanes.
  static constexpr std::uint64_t all_lanes = ~std::uint64_t{0} >> (64 - W);

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
    if constexpr (format::is_plain<Format, T>) {
      self().template write<T>(offset + k * int{sizeof(T)}, value);
    } else {
      store_encoded<Format, T>(offset, k, value, self().written(), std::bool_constant<Derived::whole>());
    }
  }
  /// Stores the lanes whose bits are set in `lanes`.
  template <class Format, class T>
  void store_where(int offset, int k, const batch_t<T, W>& value, std::uint64_t lanes) const {
    lanes &= self().written();
    if constexpr (format::is_plain<Format, T>) {
      alignas(64) std::array<T, W> values;
      value.store_aligned(values.data());
      self().write_some_lanes(offset + k * int{sizeof(T)}, values, lanes);
    } else {
      store_encoded<Format, T>(offset, k, value, lanes, std::false_type());
    }
  }

  /// Adds lanes of `range` to kCount elements, from the k-th on, one after the other: equal objects get all of them.
  template <class Format, class T, int kCount>
  void add(LaneRange range, int offset, int k, const batch_t<T, W>* values) const {
    static_assert(format::is_plain<Format, T>,
                  "add() needs a field that is stored as it is computed: give it the format Native");
    for (int e = 0; e < kCount; ++e) {
      alignas(64) std::array<T, W> lanes;
      values[e].store_aligned(lanes.data());
      for (int l = range.first; l < range.last; ++l) {
        auto* to = self().template address<T>(offset + (k + e) * int{sizeof(T)}, l);
        static_assert(!std::is_const_v<std::remove_pointer_t<decltype(to)>>, "this array is read-only here");
        add_atomically(*to, lanes[static_cast<std::size_t>(l)]);
      }
    }
  }
  template <class S>
  void check_rotation([[maybe_unused]] const Eigen::Matrix<S, 3, 3>& R,
                      [[maybe_unused]] std::uint64_t lanes = all_lanes) const {
#ifdef PHYSGEN_CHECKED
    for (int l = 0; l < W; ++l) {
      if (((self().written() & lanes) >> l & 1) == 0) continue;
      Eigen::Matrix3d one;
      for (int k = 0; k < 9; ++k) {
        one(k % 3, k / 3) = static_cast<double>(R(k % 3, k / 3).get(static_cast<std::size_t>(l)));
      }
      this->count_rotation(one, self().further(l));
    }
#endif
  }

 private:
  template <class Format, class T, bool kWhole>
  void store_encoded(int offset, int k, const batch_t<T, W>& value, std::uint64_t lanes,
                     [[maybe_unused]] std::bool_constant<kWhole> whole) const {
    using Stored = typename Format::template Stored<T>;
    const int at = offset + k * int{sizeof(Stored)};
    alignas(64) std::array<Stored, W> stored;
    alignas(64) std::array<T, W> values;
    value.store_aligned(values.data());
    encode_lanes<Format, T, W>(values.data(), stored.data());
#ifdef PHYSGEN_CHECKED
    for (int l = 0; l < W; ++l) {
      if ((lanes >> l & 1) == 0) continue;
      const auto lane = static_cast<std::size_t>(l);
      this->template count<Format, T>(at, values[lane], stored[lane], self().further(l));
    }
#endif
    if constexpr (kWhole) {
      self().write_lanes(at, stored);
    } else {
      self().write_some_lanes(at, stored, lanes);
    }
  }

  [[nodiscard]] const Derived& self() const { return static_cast<const Derived&>(*this); }
};

/// On W consecutive objects: what the cursors of whole and of partial packs share.
template <class Derived, class Byte, class Layout, RecordSize kRecord, int W>
class ConsecutiveCursor : public SimdCursor<Derived, W> {
 protected:
  using Base = SimdCursor<Derived, W>;
  using Pitch = typename Layout::Pitch;

  ConsecutiveCursor(Byte* base, Pitch pitch, index_t begin, Losses* losses)
      : Base(losses, begin),
        tile_(base + pitch.tile(begin) * pitch.value() * kRecord.stored),
        lane_(pitch.lane(begin)),
        pitch_(pitch) {}

 public:
  [[nodiscard]] Derived nested(int offset) const {
    Derived inner = static_cast<const Derived&>(*this);
    inner.tile_ += offset * pitch_.value();
    inner.advance(offset);
    return inner;
  }

 protected:
  friend Base;
  [[nodiscard]] static index_t further(int l) { return l; }

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
  // A loop that stays one, and is not inlined: its code would stand at every store of a kernel, and runs seldom.
  template <class T>
  [[gnu::noinline]] void write_some_lanes(int offset, const std::array<T, W>& lanes, std::uint64_t which) const {
    static_assert(!std::is_const_v<Byte>, "this array is read-only here");
    for (int l = 0; l < W; ++l) {
      if (which >> l & 1) *address<T>(offset, l) = lanes[static_cast<std::size_t>(l)];
    }
  }

 private:
  Byte* tile_;
  index_t lane_;
  Pitch pitch_;
};

}  // namespace detail

/// On the W objects of a pack.
template <class Byte, class Layout, RecordSize kRecord, int W>
class Cursor<Byte, Layout, kRecord, Pack<W>>
    : public detail::ConsecutiveCursor<Cursor<Byte, Layout, kRecord, Pack<W>>, Byte, Layout, kRecord, W> {
  using Consecutive = detail::ConsecutiveCursor<Cursor, Byte, Layout, kRecord, W>;

 public:
  static constexpr bool gathered = false;
  /// Whether stores write all lanes.
  static constexpr bool whole = true;

  Cursor(Byte* base, typename Layout::Pitch pitch, Pack<W> pack, Losses* losses)
      : Consecutive(base, pitch, pack.begin, losses) {}

 private:
  friend Consecutive;
  friend typename Consecutive::Base;
  using Consecutive::address;
  [[nodiscard]] static constexpr std::uint64_t written() { return Consecutive::all_lanes; }

  // As a register.
  template <class T>
  [[nodiscard]] batch_t<T, W> read(int offset) const {
    if constexpr (Layout::contiguous(W)) {
      prefetch<T>(offset);
      return batch_t<T, W>::load_unaligned(this->template address<T>(offset, 0));
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
      value.store_unaligned(this->template address<T>(offset, 0));
    } else {
      alignas(64) std::array<T, W> lanes;
      value.store_aligned(lanes.data());
      this->write_lanes(offset, lanes);
    }
  }

  // As memory.
  template <class T>
  void read_lanes(int offset, std::array<T, W>& lanes) const {
    if constexpr (Layout::contiguous(W)) {
      prefetch<T>(offset);
      std::memcpy(lanes.data(), this->template address<T>(offset, 0), sizeof lanes);
    } else {
      PHYSGEN_UNROLL
      for (int l = 0; l < W; ++l) lanes[static_cast<std::size_t>(l)] = *this->template address<T>(offset, l);
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
    __builtin_prefetch(reinterpret_cast<const std::byte*>(this->template address<T>(offset, 0)) +
                       packs_ahead * pack_bytes);
  }
};

/// On the first or the last pack of a range.
template <class Byte, class Layout, RecordSize kRecord, int W>
class Cursor<Byte, Layout, kRecord, PartialPack<W>>
    : public detail::ConsecutiveCursor<Cursor<Byte, Layout, kRecord, PartialPack<W>>, Byte, Layout, kRecord, W> {
  using Consecutive = detail::ConsecutiveCursor<Cursor, Byte, Layout, kRecord, W>;

 public:
  static constexpr bool gathered = false;
  static constexpr bool whole = false;

  Cursor(Byte* base, typename Layout::Pitch pitch, const PartialPack<W>& pack, Losses* losses)
      : Consecutive(base, pitch, pack.begin, losses), pack_(pack) {}

 private:
  friend Consecutive;
  friend typename Consecutive::Base;
  [[nodiscard]] std::uint64_t written() const {
    return Consecutive::all_lanes >> (W - (pack_.last - pack_.first)) << pack_.first;
  }

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
    this->write_some_lanes(offset, lanes, written());
  }
  // A loop that stays one: this runs at most twice per range, and its code stands in every kernel.
  template <class T>
  [[gnu::noinline]] void read_lanes(int offset, std::array<T, W>& lanes) const {
    for (int l = 0; l < W; ++l) {
      lanes[static_cast<std::size_t>(l)] = *this->template address<T>(offset, pack_.lane(l));
    }
  }

  PartialPack<W> pack_;
};

/// On W objects gathered by index.
template <class Byte, class Layout, RecordSize kRecord, class U, class A>
class Cursor<Byte, Layout, kRecord, xsimd::batch<U, A>>
    : public detail::SimdCursor<Cursor<Byte, Layout, kRecord, xsimd::batch<U, A>>,
                                static_cast<int>(xsimd::batch<U, A>::size)> {
  static_assert(std::is_integral_v<U>, "objects are named by integers: convert the batch first");
  static constexpr int W = static_cast<int>(xsimd::batch<U, A>::size);
  using Base = detail::SimdCursor<Cursor, W>;
  using Pitch = typename Layout::Pitch;

 public:
  static constexpr bool gathered = true;
  static constexpr bool whole = false;

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
    write_some_lanes(offset, lanes, written());
  }
  template <class T>
  void read_lanes(int offset, std::array<T, W>& lanes) const {
    PHYSGEN_UNROLL
    for (int l = 0; l < W; ++l) lanes[static_cast<std::size_t>(l)] = *address<T>(offset, l);
  }
  [[nodiscard]] static std::uint64_t written() {
    const LaneRange range = detail::running_lanes.of(W);
    return Base::all_lanes >> (W - (range.last - range.first)) << range.first;
  }
  // Lane by lane in order: of equal indices the last lane wins. Checked builds refuse them.
  template <class T>
  void write_some_lanes(int offset, const std::array<T, W>& lanes, std::uint64_t which) const {
    static_assert(!std::is_const_v<Byte>, "this array is read-only here");
    if constexpr (checked_build) check_distinct(which);
    for (int l = 0; l < W; ++l) {
      if (which >> l & 1) *address<T>(offset, l) = lanes[static_cast<std::size_t>(l)];
    }
  }
  void check_distinct(std::uint64_t which) const {
    for (std::size_t l = 0; l < W; ++l) {
      for (std::size_t before = 0; before < l; ++before) {
        if ((which >> l & which >> before & 1) == 0 || index_[l] != index_[before]) continue;
        throw Error("a store through gathered indices: lanes " + std::to_string(before) + " and " + std::to_string(l) +
                    " of a pack both name object " + std::to_string(index_[l]) +
                    ", and only one of their values would stay; add(i, view[j].field(), value) adds both");
      }
    }
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
