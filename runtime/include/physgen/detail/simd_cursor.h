// The common base of the cursors of packs and of gathered objects: batches in place of numbers, formats, loads and
// stores by lane. Host translation units alone include it.
#pragma once

#include <physgen/detail/cursor.h>
#include <physgen/detail/running_lanes.h>
#include <physgen/detail/simd_formats.h>
#include <physgen/detail/transposed.h>
#include <physgen/simd/simd.h>

#include <array>

#ifdef PHYSGEN_CHECKED
#include <physgen/detail/fused_accesses.h>
#endif

namespace physgen {

namespace detail {

template <class T, int W>
struct SizedBatch {
  static_assert(!std::is_same_v<T, bool>,
                "packs hold no field of bool: run the kernel that reads it on single objects, lanes<1>(kernel)");
  using Number = std::conditional_t<std::is_same_v<T, bool>, std::int8_t, T>;
  using type = typename xsimd::make_sized_batch<Number, static_cast<std::size_t>(W)>::type;
  static_assert(
      !std::is_void_v<type> || std::is_same_v<T, bool>,
      "this CPU has no SIMD register of W lanes of T. Packs are as wide as the kernel's `using Scalar` makes them: let "
      "that be the widest number that the kernel reads, `using Scalar = typename View::Precision;`, or run the kernel "
      "on single objects, lanes<1>(kernel)");
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
template <class T, class A>
struct LaneOf<xsimd::batch<T, A>> {
  using type = T;
};
template <class T, class A>
struct LaneOf<xsimd::batch_bool<T, A>> {
  using type = bool;
};

namespace detail {

/// What memory holds of an element of W objects.
template <class Stored, int W>
struct alignas(64) StoredLanes {
  std::array<Stored, W> lanes;
};

/// Makes references to fields and elements, and applies their formats, by read and write of the derived cursor.
template <class Derived, int W>
class SimdCursor : protected LossSink {
 public:
  template <class T>
  using Lanes = batch_t<T, W>;
  static constexpr bool gives_stored = true;
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
    note_read(at);
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
    note_write<Format, T>(offset, k, all_lanes);
    if constexpr (format::is_plain<Format, T>) {
      self().template write<T>(offset + k * int{sizeof(T)}, value);
    } else if constexpr (format::StoresNothing<Format>) {
      store_nothing<Format, T>();
    } else {
      store_encoded<Format, T>(offset, k, value, self().written(), std::bool_constant<Derived::whole>());
    }
  }
  /// Reads and writes what memory holds of an element.
  template <class Format, class T>
  [[nodiscard]] auto load_stored(int offset, int k) const {
    using Stored = typename Format::template Stored<T>;
    const int at = offset + k * int{sizeof(Stored)};
    note_read(at);
    StoredLanes<Stored, W> stored;
    self().read_lanes(at, stored.lanes);
    return stored;
  }
  template <class Format, class T, class Stored>
  void store_stored(int offset, int k, const StoredLanes<Stored, W>& stored) const {
    note_write<Format, T>(offset, k, all_lanes);
    const int at = offset + k * int{sizeof(Stored)};
    if constexpr (Derived::whole) {
      self().write_lanes(at, stored.lanes);
    } else {
      self().write_some_lanes(at, stored.lanes, self().written());
    }
  }
  /// Stores the lanes whose bits are set in `lanes`.
  template <class Format, class T>
  void store_where(int offset, int k, const batch_t<T, W>& value, std::uint64_t lanes) const {
    note_write<Format, T>(offset, k, lanes);
    if constexpr (format::is_plain<Format, T>) {
      alignas(64) std::array<T, W> values;
      value.store_aligned(values.data());
      self().write_some_lanes(offset + k * int{sizeof(T)}, values, lanes & self().written());
    } else if constexpr (format::StoresNothing<Format>) {
      store_nothing<Format, T>();
    } else {
      store_encoded<Format, T>(offset, k, value, lanes & self().written(), std::false_type());
    }
  }

  /// Adds lanes of `range` to kCount elements, from the k-th on, one after the other: equal objects get all of them.
  template <class Format, class T, int kCount>
  void add(LaneRange range, int offset, int k, const batch_t<T, W>* values) const {
    if constexpr (format::StoresNothing<Format>) (void)Format::template decode<T>({});  // adding reads
    static_assert(format::is_plain<Format, T> || format::StoresNothing<Format>,
                  "add() needs a field that is stored as it is computed: give it the format Native");
    for (int e = 0; e < kCount; ++e) {
      alignas(64) std::array<T, W> lanes;
      values[e].store_aligned(lanes.data());
      note_sum(range, offset + (k + e) * int{sizeof(T)}, lanes);
      for (int l = range.first; l < range.last; ++l) {
        auto* to = self().template address<T>(offset + (k + e) * int{sizeof(T)}, l);
        static_assert(!std::is_const_v<std::remove_pointer_t<decltype(to)>>, "this array is read-only here");
        add_atomically(*to, lanes[static_cast<std::size_t>(l)]);
      }
    }
  }
  /// Their place always allows it: see load_words_at().
  template <class T, int kCount>
  [[nodiscard]] static constexpr bool may_read_words() {
    return true;
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

 protected:
  /// Whether fields of kCount elements of type T are read by words of 16 bytes: of records that lie in one piece, into
  /// registers of whole words.
  template <class Layout, RecordSize kRecord, class T, int kCount>
  static constexpr bool joins_words_of =
      std::is_same_v<typename Layout::Pitch, StaticPitch<1>> && kCount > 1 && kRecord.stored >= 16 &&
      (sizeof(T) == 4 || sizeof(T) == 8) && W* int{sizeof(T)} >= 16;
  /// Reads such a field. @param at of its first element in the record [bytes]. @param elements room for whole words
  template <RecordSize kRecord, class T, int kCount>
  void load_words_at(int at, batch_t<T, W>* elements) const {
    constexpr int E = word_elements<T>, size = int{sizeof(T)};
    PHYSGEN_UNROLL
    for (int k = 0; k < kCount; k += E) {
      // No word reaches behind its record, where no memory might be: one that would begins earlier.
      const int behind = at + k * size + 16 - kRecord.stored, shift = behind > 0 ? behind / size : 0;
      register_t<T, W> words[E];
      load_transposed<T, W>([&](int l) { return self().template address<T>((k - shift) * size, l); }, words);
      for (int e = shift; e < E; ++e) {
        if (k + e - shift < kCount) elements[k + e - shift] = std::bit_cast<batch_t<T, W>>(words[e]);
      }
    }
    for (int k = 0; k < kCount; ++k) note_read(k * size);
  }
  // Lane by lane, by way of memory; the cursor of whole packs has read() and write() of its own.
  template <class T>
  [[nodiscard]] batch_t<T, W> read(int offset) const {
    alignas(64) std::array<T, W> lanes;
    self().read_lanes(offset, lanes);
    return batch_t<T, W>::load_aligned(lanes.data());
  }
  template <class T>
  void write(int offset, const batch_t<T, W>& value) const {
    alignas(64) std::array<T, W> lanes;
    value.store_aligned(lanes.data());
    self().write_some_lanes(offset, lanes, self().written());
  }

 private:
  // For races in fused kernels, which checked builds find.
#ifdef PHYSGEN_CHECKED
  void note(FusedAccess access, int offset, std::uint64_t lanes) const {
    note_lanes<W>(access, this->losses(), this->offset() + offset, lanes,
                  [&](int l) { return this->object() + self().further(l); });
  }
  void note_read(int offset) const { note(FusedAccess::read, offset, running_step.used); }
  template <class Format, class T>
  void note_write(int offset, int k, std::uint64_t lanes) const {
    if constexpr (!format::StoresNothing<Format>)
      note(FusedAccess::write, offset + k * int{sizeof(typename Format::template Stored<T>)}, lanes);
  }
  // A lane that is not used adds zeros, which change nothing.
  template <class T>
  void note_sum(LaneRange range, int offset, const std::array<T, W>& values) const {
    std::uint64_t lanes = 0;
    for (int l = range.first; l < range.last; ++l)
      if ((running_step.used >> l & 1) != 0 || values[static_cast<std::size_t>(l)] != T(0))
        lanes |= std::uint64_t{1} << l;
    note(FusedAccess::add, offset, lanes);
  }
#else
  void note_read(int /*offset*/) const {}
  template <class Format, class T>
  void note_write(int /*offset*/, int /*k*/, std::uint64_t /*lanes*/) const {}
  template <class T>
  void note_sum(LaneRange /*range*/, int /*offset*/, const std::array<T, W>& /*values*/) const {}
#endif

  template <class Format, class T>
  void store_nothing() const {
    using To = decltype(self().template address<typename Format::template Stored<T>>(0, 0));
    static_assert(!std::is_const_v<std::remove_pointer_t<To>>, "this array is read-only here");
  }
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

}  // namespace detail

}  // namespace physgen
