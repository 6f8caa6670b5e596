// The kinds of index a kernel is called with, and the type that one element has under each: a plain index reads one
// object, a Pack or PartialPack reads W consecutive objects at once. (A SIMD batch of int32 gathers W objects; see
// simd_access.h.)
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/config.h>
#include <physgen/detail/deleted.h>

#include <concepts>
#include <type_traits>
#include <utility>

namespace physgen {

/// W consecutive objects, starting at a multiple of W. All of them are objects of the kernel's range.
template <int W>
struct Pack {
  static constexpr int width = W;
  index_t begin;
};

/// The first or the last pack of a range: lanes first .. last-1 are objects of the range, the others are not. Those
/// load what a lane of the range loads, and their stores leave memory alone, so a kernel sees neither the padding of an
/// array nor the neighbours of a range. Its numbers have the same bits as in a whole pack.
template <int W>
struct PartialPack {
  static constexpr int width = W;
  index_t begin;  ///< of lane 0; a multiple of W
  int first, last;

  /// The lane whose object lane l reads.
  [[nodiscard]] constexpr int lane(int l) const { return l < first ? first : l < last ? l : last - 1; }
};

/// The index that the kernels of a fused kernel are called with (fuse.h): one of the others, and where the locals of
/// its objects lie. Views and all words that ask an index take it as the one that it holds.
template <class I, class Frame>
struct Own {
  I index;
  Frame* frame;
};

namespace detail {

template <class I>
inline constexpr bool is_own = false;
template <class I, class Frame>
inline constexpr bool is_own<Own<I, Frame>> = true;

/// In the place of locals where an index stands for objects of a part (object_of_part()): they have none.
struct FrameOfPart {
  template <class Local>
  static constexpr bool has = false;
};
template <class I>
inline constexpr bool is_of_part = false;
template <class I>
inline constexpr bool is_of_part<Own<I, FrameOfPart>> = true;

/// The index that says which objects are meant: an Own's, which may hold another one.
template <class I>
[[nodiscard]] PHYSGEN_FUNCTION constexpr decltype(auto) bare(const I& i) {
  if constexpr (is_own<I>) {
    return bare(i.index);
  } else {
    return (i);
  }
}
template <class I>
using Bare = std::remove_cvref_t<decltype(bare(std::declval<const I&>()))>;

template <class I>
concept AnyPack = std::same_as<I, Pack<I::width>> || std::same_as<I, PartialPack<I::width>>;

/// The index of kernels that are checked in place of packs (check_numbers.h): an integer, as of single objects, of a
/// type that no program counts objects with.
using CheckedIndex = char16_t;

/// In the place of the locals of a kernel that is not fused.
struct NoFrame {};
/// In the place of index_t where a kernel is looked at and not run (probe.h): its type tells it from other numbers.
using OwnObject = Own<index_t, NoFrame>;

/// Indices that stand for one object or for a pack, whether an Own holds them or not.
template <class I>
concept OfOneObject = std::integral<Bare<I>>;
template <class I>
concept OfPack = AnyPack<Bare<I>>;

struct a_pack_is_no_number_so_name_neighbours_by_numbers_of_i_plus_one {};

}  // namespace detail

/// The index of a kernel that takes single objects alone: `template <SingleObject I> void operator()(I i) const`. It is
/// index_t wherever the kernel runs. As a template the kernel tells its own object, view[i], from those that it finds
/// by numbers, so that physgen knows what it reads of others; object_number(i) is the number to calculate with.
template <class I>
concept SingleObject =
    (std::integral<I> && !std::same_as<I, detail::CheckedIndex>) || std::same_as<I, detail::OwnObject>;

// The pack at i + 1 would not begin at a multiple of its width: `view[numbers(i) + 1]` gathers the neighbours.
template <class I, std::integral Number>
  requires(detail::AnyPack<I> || detail::is_own<I>)
detail::a_pack_is_no_number_so_name_neighbours_by_numbers_of_i_plus_one operator+(const I&, Number)
    PHYSGEN_DELETED(a_pack_is_no_number_so_name_neighbours_by_numbers_of_i_plus_one);
template <class I, std::integral Number>
  requires(detail::AnyPack<I> || detail::is_own<I>)
detail::a_pack_is_no_number_so_name_neighbours_by_numbers_of_i_plus_one operator-(const I&, Number)
    PHYSGEN_DELETED(a_pack_is_no_number_so_name_neighbours_by_numbers_of_i_plus_one);

/// Lanes first .. last-1 of a pack.
struct LaneRange {
  int first, last;
};

/// The number of objects that an index stands for.
template <class I>
[[nodiscard]] PHYSGEN_FUNCTION constexpr int index_width(const I& /*i*/) {
  if constexpr (std::is_integral_v<detail::Bare<I>>) {
    return 1;
  } else {
    return detail::Bare<I>::width;
  }
}

/// The lanes of an index that are objects of the kernel's range.
template <class I>
[[nodiscard]] PHYSGEN_FUNCTION constexpr LaneRange lane_range(const I& i) {
  static_assert(detail::OfOneObject<I> || detail::OfPack<I>,
                "a gathered index does not know its range: give the kernel's own index");
  if constexpr (requires { detail::bare(i).first; }) {
    return {detail::bare(i).first, detail::bare(i).last};
  } else {
    return {0, index_width(i)};
  }
}

/// The pack that begins at `at`, as far as it lies in begin .. end-1.
/// @pre `at` is a multiple of W, and the pack holds at least one object of the range
template <int W>
[[nodiscard]] constexpr PartialPack<W> partial_pack(index_t at, index_t begin, index_t end) {
  return {at, static_cast<int>(begin > at ? begin - at : 0), static_cast<int>(end < at + W ? end - at : W)};
}

/// The type of an element of type T under an index of type I: T itself, or a SIMD batch. simd_cursor.h specialises it.
template <class T, class I>
struct Lanes {
  static_assert(std::is_integral_v<I>, "SIMD access on the CPU needs <physgen/simd/simd_access.h>");
  using type = T;
};
template <class T, class I, class Frame>
struct Lanes<T, Own<I, Frame>> : Lanes<T, I> {};
template <class T, class I>
using lanes_t = typename Lanes<T, I>::type;

/// The type with as many lanes as S has, but lanes of type T: float, int32_t -> int32_t. simd_cursor.h specialises it.
template <class S, class T>
struct SameLanes {
  using type = T;
};
template <class S, class T>
using same_lanes_t = typename SameLanes<S, T>::type;

/// The type of one lane of an S: S itself, or that of a batch's or mask's lanes. simd_cursor.h specialises it.
template <class S>
struct LaneOf {
  using type = S;
};
template <class S>
using lane_of_t = typename LaneOf<S>::type;

/// `value` in each lane of an S; in generated code, where S is not known to be a number or a SIMD batch.
template <class S>
[[nodiscard]] PHYSGEN_FUNCTION constexpr S all_lanes(double value) {
  if constexpr (std::is_arithmetic_v<S>) {
    return static_cast<S>(value);
  } else {
    return S(static_cast<typename S::value_type>(value));
  }
}

}  // namespace physgen

#pragma pop_macro("I")
