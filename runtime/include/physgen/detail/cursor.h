// A cursor stands on one object of an array (or on the objects of a SIMD pack) and turns byte offsets of the record
// into addresses by the law (layout/address.h); generated accessors and kernels only use it.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/detail/add_atomically.h>
#include <physgen/detail/count_losses.h>
#include <physgen/fields/field_ref.h>
#include <physgen/kernels/pack.h>
#include <physgen/layout/address.h>

#include <bit>
#include <type_traits>

#ifdef __CUDACC__
#include <cuda_runtime_api.h>
#endif

namespace physgen {

/// Counts, in checked builds, the values that a cursor's stores could not hold, with the object that it stands on and
/// the place in the record. Empty in other builds.
class LossSink {
 public:
  LossSink() = default;
#ifdef PHYSGEN_CHECKED
  PHYSGEN_FUNCTION LossSink(Losses* losses, index_t object) : losses_(losses), object_(object) {}
  PHYSGEN_FUNCTION void advance(int offset) { offset_ += offset; }
  /// @param further how many objects after the one it was made for
  template <class Format, class T>
  PHYSGEN_FUNCTION void count(int offset, const T& value, typename Format::template Stored<T> stored,
                              index_t further = 0) const {
    if constexpr (!format::is_probe<Format>) {  // counting would read one
      constexpr ElementType type = Format::template type<T>;
      if (losses_ == nullptr || object_ + further >= losses_->objects) return;
      detail::count_loss(*losses_, type, Format::scale, static_cast<double>(value),
                         static_cast<double>(Format::template decode<T>(stored)), object_ + further, offset_ + offset);
    }
  }
  [[nodiscard]] PHYSGEN_FUNCTION const Losses* losses() const { return losses_; }
  [[nodiscard]] PHYSGEN_FUNCTION index_t object() const { return object_; }
  [[nodiscard]] PHYSGEN_FUNCTION int offset() const { return offset_; }
  template <class Matrix>
  PHYSGEN_FUNCTION void count_rotation(const Matrix& R, index_t further = 0) const {
    if (losses_ == nullptr || object_ + further >= losses_->objects) return;
    detail::count_deviation(*losses_, detail::rotation_deviation(R), object_ + further, offset_);
  }

 private:
  Losses* losses_ = nullptr;
  index_t object_ = 0;
  int offset_ = 0;
#else
  PHYSGEN_FUNCTION LossSink(Losses* /*losses*/, index_t /*object*/) {}
  PHYSGEN_FUNCTION void advance(int /*offset*/) {}
  template <class Format, class T>
  PHYSGEN_FUNCTION void count(int /*offset*/, const T& /*value*/, typename Format::template Stored<T> /*stored*/,
                              index_t /*further*/ = 0) const {}
  template <class Matrix>
  PHYSGEN_FUNCTION void count_rotation(const Matrix& /*R*/, index_t /*further*/ = 0) const {}
#endif
};

/// The sizes of an array's records that a cursor knows [bytes].
struct RecordSize {
  int content;  ///< the object's own, before the layout pads it
  int stored;   ///< in an array of this layout
  int lane;     ///< of the elements that most fields of the object have
};

namespace detail {

/// Whether records are made of 16-byte words, so that fields of kCount elements of type T may be read and written by
/// whole words: one request for a padded vector instead of three.
template <class Layout, RecordSize kRecord, class T, int kCount>
inline constexpr bool made_of_words = std::is_same_v<typename Layout::Pitch, StaticPitch<1>> &&
                                      kRecord.stored % 16 == 0 && kCount > 1 && kCount * sizeof(T) <= 64 &&
                                      (sizeof(T) == 4 || sizeof(T) == 8);

/// Whether the words of a field of `bytes`, `offset` bytes into its record, may be read; and whether they may be
/// written, since they hold nothing else but padding. Known when compiled, but for entries of fixed arrays.
template <RecordSize kRecord>
[[nodiscard]] PHYSGEN_FUNCTION constexpr bool may_read_words(int offset, int bytes) {
  return offset % 16 == 0 && offset + align_up(bytes, 16) <= kRecord.stored;
}
template <RecordSize kRecord>
[[nodiscard]] PHYSGEN_FUNCTION constexpr bool may_write_words(int offset, int bytes) {
  return offset % 16 == 0 && (bytes % 16 == 0 || offset + bytes == kRecord.content);
}

}  // namespace detail

/// @tparam Byte std::byte, or const std::byte for a read-only array
/// @tparam Layout Aos, AosPadded, Soa or Aosoa<W>
/// @tparam kRecord sizes of the records
/// @tparam I the kind of index; integral here, SIMD packs in simd_access.h
template <class Byte, class Layout, RecordSize kRecord, class I>
class Cursor : private LossSink {
  static_assert(std::is_integral_v<I>, "SIMD access on the CPU needs <physgen/simd/simd_access.h>");
  using Pitch = typename Layout::Pitch;

 public:
  template <class T>
  using Lanes = T;
  /// Whether two lanes may stand on one object.
  static constexpr bool gathered = false;
  static constexpr bool gives_stored = true;
  /// Whether it stands on a local of a fused kernel.
  static constexpr bool of_a_local = requires { Layout::of_locals; };

  /// Stands on object i of the array at `base`.
  PHYSGEN_FUNCTION Cursor(Byte* base, Pitch pitch, I i, Losses* losses)
      : LossSink(losses, static_cast<index_t>(i)),
        lane_(pitch.lane(static_cast<index_t>(i))),
        object_(base +
                law::tile_begin(pitch.tile(static_cast<index_t>(i)), law::tile_bytes(pitch.value(), kRecord.stored)) +
                law::lane_begin(lane_, kRecord.lane)),
        pitch_(pitch) {}

  /// A reference to the field that begins at byte `offset` of the record: of one element, as element() gives it; else a
  /// FieldRef.
  template <class Shape, class Format, class T>
  [[nodiscard]] PHYSGEN_FUNCTION decltype(auto) field(int offset) const {
    if constexpr (Shape::is_scalar) {
      return element<Format, T>(offset);
    } else {
      return FieldRef<Shape, Format, T, Cursor>(nested(offset));
    }
  }

  /// Element k of those that follow each other from byte `offset` of the record on: T& (const T& in a read-only array)
  /// where memory holds T, else an ElementRef. A local, which refuses masked stores and sums, always has that.
  template <class Format, class T>
  [[nodiscard]] PHYSGEN_FUNCTION decltype(auto) element(int offset, int k = 0) const {
    if constexpr (format::is_plain<Format, T> && !of_a_local) {
      return static_cast<Element<T>&>(address<T>(offset)[law::channel_begin(k, pitch_.value())]);
    } else {
      return ElementRef<Format, T, Cursor>(*this, offset, k);
    }
  }

  /// Reads and writes an element where memory does not hold T itself.
  template <class Format, class T>
  [[nodiscard]] PHYSGEN_FUNCTION T load(int offset, int k) const {
    using Stored = typename Format::template Stored<T>;
    return Format::template decode<T>(address<Stored>(offset)[law::channel_begin(k, pitch_.value())]);
  }
  template <class Format, class T>
  PHYSGEN_FUNCTION void store(int offset, int k, const T& value) const {
    refuse_read_only();
    if constexpr (!format::StoresNothing<Format>) {
      using Stored = typename Format::template Stored<T>;
      const Stored stored = Format::template encode<T>(value);
      this->template count<Format, T>(offset + k * int{sizeof(Stored)}, value, stored);
      address<Stored>(offset)[law::channel_begin(k, pitch_.value())] = stored;
    }
  }
  /// Reads and writes what memory holds of an element.
  template <class Format, class T>
  [[nodiscard]] PHYSGEN_FUNCTION typename Format::template Stored<T> load_stored(int offset, int k) const {
    return address<typename Format::template Stored<T>>(offset)[law::channel_begin(k, pitch_.value())];
  }
  template <class Format, class T>
  PHYSGEN_FUNCTION void store_stored(int offset, int k, const typename Format::template Stored<T>& stored) const {
    refuse_read_only();
    address<typename Format::template Stored<T>>(offset)[law::channel_begin(k, pitch_.value())] = stored;
  }
  /// Adds to kCount elements, from the k-th on, to which other threads may add at the same time.
  template <class Format, class T, int kCount>
  PHYSGEN_FUNCTION void add(LaneRange /*range*/, int offset, int k, const T* values) const {
    static_assert(!std::is_const_v<Byte>, "this array is read-only here");
    if constexpr (format::StoresNothing<Format>) (void)Format::template decode<T>({});  // adding reads
    static_assert(format::is_plain<Format, T> || format::StoresNothing<Format>,
                  "add() needs a field that is stored as it is computed: give it the format Native");
#if defined(__CUDA_ARCH__) && __CUDA_ARCH__ >= 900
    // All elements of a padded vector are added at once, and zeros to the padding behind them.
    if constexpr (sizeof(T) == 4 && std::is_floating_point_v<T> && (kCount == 3 || kCount == 4) &&
                  joins_words<T, kCount>) {
      if (may_write_words<T, kCount>()) {
        asm volatile("red.global.add.v4.f32 [%0], {%1, %2, %3, %4};"
                     :
                     : "l"(address<T>(0)), "f"(values[0]), "f"(values[1]), "f"(values[2]),
                       "f"(kCount == 4 ? values[kCount - 1] : 0.0F)
                     : "memory");
        return;
      }
    }
#endif
    PHYSGEN_UNROLL
    for (int e = 0; e < kCount; ++e)
      detail::add_atomically(address<T>(offset)[law::channel_begin(k + e, pitch_.value())], values[e]);
  }
  /// @return the address of an element whose format is a probe: T*, or const T* in a read-only array
  template <class Format, class T>
  [[nodiscard]] PHYSGEN_FUNCTION auto address_of(int offset, int k) const {
    return Format::template address<T>(address<typename Format::template Stored<T>>(offset) +
                                       law::channel_begin(k, pitch_.value()));
  }
  /// In checked builds, counts a matrix that is not a rotation.
  template <class T>
  PHYSGEN_FUNCTION void check_rotation(const Eigen::Matrix<T, 3, 3>& R) const {
    this->count_rotation(R);
  }

  /// The cursor of an object nested at byte `offset` of this one.
  [[nodiscard]] PHYSGEN_FUNCTION Cursor nested(int offset) const {
    Cursor inner = *this;
    inner.object_ += law::channel_begin(offset, pitch_.value());
    inner.advance(offset);
    inner.offset_ += offset;
    return inner;
  }

  /// Whether fields of kCount elements of type T are read and written by 16-byte words, where their place allows it.
  template <class T, int kCount>
  static constexpr bool joins_words =
#ifdef __CUDA_ARCH__
      detail::made_of_words<Layout, kRecord, T, kCount>;
#else
      false;
#endif
  template <class T, int kCount>
  [[nodiscard]] PHYSGEN_FUNCTION bool may_read_words() const {
    return detail::may_read_words<kRecord>(offset_, kCount * int{sizeof(T)});
  }
  template <class T, int kCount>
  [[nodiscard]] PHYSGEN_FUNCTION bool may_write_words() const {
    return detail::may_write_words<kRecord>(offset_, kCount * int{sizeof(T)});
  }
#ifdef __CUDA_ARCH__
  /// @param elements room for whole words
  template <class T, int kCount>
  __device__ void load_words(T* elements) const {
    using Word = std::conditional_t<sizeof(T) == 4, uint4, ulonglong2>;
    PHYSGEN_UNROLL
    for (int k = 0; k < kCount; k += 16 / int{sizeof(T)}) {
      const Word word = *reinterpret_cast<const Word*>(address<T>(0) + k);
      elements[k] = std::bit_cast<T>(word.x);
      elements[k + 1] = std::bit_cast<T>(word.y);
      if constexpr (sizeof(T) == 4) {
        elements[k + 2] = std::bit_cast<T>(word.z);
        elements[k + 3] = std::bit_cast<T>(word.w);
      }
    }
  }
  template <class T, int kCount>
  __device__ void store_words(const T* elements) const {
    static_assert(!std::is_const_v<Byte>, "this array is read-only here");
    PHYSGEN_UNROLL
    for (int k = 0; k < kCount; k += 16 / int{sizeof(T)}) {
      if constexpr (sizeof(T) == 4) {
        const auto bits = [&](int j) { return std::bit_cast<unsigned>(elements[k + j]); };
        *reinterpret_cast<uint4*>(address<T>(0) + k) = {bits(0), bits(1), bits(2), bits(3)};
      } else {
        const auto bits = [&](int j) { return std::bit_cast<unsigned long long>(elements[k + j]); };
        *reinterpret_cast<ulonglong2*>(address<T>(0) + k) = {bits(0), bits(1)};
      }
    }
  }
#endif

 private:
  PHYSGEN_FUNCTION static constexpr void refuse_read_only() {
    static_assert(!std::is_const_v<Byte>, "this array is read-only here");
  }
  /// A T as code sees it: const in a read-only array.
  template <class T>
  using Element = std::conditional_t<std::is_const_v<Byte>, const T, T>;

  /// Address of the T at byte `offset` of the record.
  template <class T>
  [[nodiscard]] PHYSGEN_FUNCTION Element<T>* address(int offset) const {
    constexpr index_t correction = index_t{sizeof(T)} - kRecord.lane;
    // law::channel_begin() + law::lane_begin(), written out: any call here keeps nvcc from sharing the address of an
    // object among branches, which gathers of corner forces pay for with a tenth of their time.
    return reinterpret_cast<Element<T>*>(object_ + offset * pitch_.value() + lane_ * correction);
  }

  // All fields of an object share object_; computed per field, compilers would not find what is common. It is the
  // address of an element at offset 0 with kRecord.lane bytes; address() adds what elements of another size need.
  index_t lane_;
  Byte* object_;
  Pitch pitch_;
  int offset_ = 0;  // of the object or field it stands on in its record; a constant, once inlined
};

}  // namespace physgen

#pragma pop_macro("I")
