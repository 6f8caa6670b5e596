// Folds the terms that a kernel returns for each object into one value: sums, extrema, conditions and counts, and the
// order in which they are formed, which is the same everywhere. parallel_reduce.h runs them on the CPU,
// cuda/parallel_reduce.h on a device.
#pragma once

#include <physgen/detail/folds.h>
#include <physgen/detail/reduction.h>
#include <physgen/error.h>

#include <string>
#include <type_traits>

namespace physgen {

// The order. Objects 2048 b .. 2048 b + 2047 of the array are block b, wherever the range begins. In a block, each
// object of the range joins lane i % 32, in ascending i, from the fold's identity on; then lane l joins lane l + 16 for
// l < 16, lane l + 8 for l < 8, and so on to lane 0. The range's blocks, numbered from 0 at its first, join strands
// b % 1024, in ascending b; then strand s joins strand s + 512 for s < 512, where there are so many, s + 256 for
// s < 256, and so on to strand 0. So the value has the same bits for any number of threads, lanes of packs, and on host
// and device, where the kernel's terms have.

/// Some of the objects of a reduction that runs part by part: its objects first .. first + count - 1. Parts follow each
/// other in ascending order and without gaps, and each but the last has whole blocks. Their value has the bits that one
/// reduction of all objects has; `then` is called once, behind the last part.
struct PartOfReduction {
  index_t first, count;
  index_t of;  ///< objects of all parts

  [[nodiscard]] constexpr bool is_last() const { return first + count == of; }
  [[nodiscard]] constexpr index_t first_block() const { return first / detail::reduce_block; }
  [[nodiscard]] constexpr index_t blocks() const { return (of + detail::reduce_block - 1) / detail::reduce_block; }
  /// @throw Error when it begins inside of a block, ends inside of one without being the last, or is not among `of`
  void check() const {
    if (first >= 0 && count >= 0 && count <= of - first && first % detail::reduce_block == 0 &&
        (is_last() || count % detail::reduce_block == 0)) {
      return;
    }
    throw Error("a reduction of " + std::to_string(of) + " objects has a part from object " + std::to_string(first) +
                " to before " + std::to_string(first + count) + "; let parts begin and end at multiples of " +
                std::to_string(detail::reduce_block) + ", and the last at the end");
  }
};

// A fold is a type with these members, of which a fold of your own has all, too; Number is the type of one object's
// term: float, double, std::int32_t or bool. Folds of several terms (std::array, Eigen vectors and matrices) fold each.
//   template <class Number> using Value         the type of the result: trivially copyable, up to 64 bytes
//   template <class Number> identity()          the Value of no objects
//   template <class Number> value(term, i)      the Value of object i alone
//   join(a, b)                                  of two Values; the order above is all that is known of a and b

/// The sum: floats and doubles are added in double, integers in 64 bits. 0 without terms; NaN where a term is NaN.
struct Sum {
  template <class Number>
  using Value = std::conditional_t<std::is_floating_point_v<Number>, double, index_t>;
  template <class Number>
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr Value<Number> identity() {
    return 0;
  }
  template <class Number>
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr Value<Number> value(Number term, index_t /*i*/) {
    return static_cast<Value<Number>>(term);
  }
  template <class V>
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr V join(const V& a, const V& b) {
    return a + b;
  }
};

/// The largest term; without terms -infinity, of integers the lowest. NaN where a term is NaN.
struct Max : detail::Extremum<true> {};
/// The smallest term; without terms infinity, of integers the largest. NaN where a term is NaN.
struct Min : detail::Extremum<false> {};
/// Whether a condition holds for all objects; true without objects.
struct All : detail::Condition<true> {};
/// Whether a condition holds for any object; false without objects.
struct Any : detail::Condition<false> {};

/// A term and the number of its object.
template <class Number>
struct Indexed {
  index_t index;
  Number value;
};

/// The first of the objects with the largest term; a NaN counts as larger than all numbers. Without terms index -1, and
/// the value of Max.
struct Argmax {
  template <class Number>
  using Value = Indexed<Number>;
  template <class Number>
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr Indexed<Number> identity() {
    return {-1, Max::identity<Number>()};
  }
  template <class Number>
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr Indexed<Number> value(Number term, index_t i) {
    return {i, term};
  }
  template <class Number>
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr Indexed<Number> join(const Indexed<Number>& a,
                                                                       const Indexed<Number>& b) {
    if (a.index < 0 || b.index < 0) return a.index < 0 ? b : a;
    if (above(a.value, b.value)) return a;
    if (above(b.value, a.value)) return b;
    return a.index < b.index ? a : b;
  }

 private:
  template <class Number>
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr bool above(Number a, Number b) {
    return a > b || (a != a && b == b);
  }
};

/// The number of objects for which a condition holds.
struct Count : Sum {
  template <std::same_as<bool> Condition>
  [[nodiscard]] PHYSGEN_FUNCTION static constexpr index_t value(Condition condition, index_t /*i*/) {
    return condition ? 1 : 0;
  }
};

// Short forms: `sum(Host{}, view.size(), kernel)` is parallel_reduce(Host{}, view.size(), kernel, Sum{}). Arguments
// behind the kernel are those that parallel_reduce() has behind the fold. PHYSGEN_SHORT_FORM is undefined below.
#define PHYSGEN_SHORT_FORM(name, Fold)                                                       \
  template <class Space, class Kernel, class... Rest>                                        \
    requires(!std::is_integral_v<Kernel> && requires { Space::kind; })                       \
  auto name(Space space, index_t size, const Kernel& kernel, Rest&&... rest) {               \
    return parallel_reduce(space, 0, size, kernel, Fold{}, std::forward<Rest>(rest)...);     \
  }                                                                                          \
  template <class Space, class Kernel, class... Rest>                                        \
    requires(!std::is_integral_v<Kernel> && requires { Space::kind; })                       \
  auto name(Space space, index_t begin, index_t end, const Kernel& kernel, Rest&&... rest) { \
    return parallel_reduce(space, begin, end, kernel, Fold{}, std::forward<Rest>(rest)...);  \
  }
PHYSGEN_SHORT_FORM(sum, Sum)
PHYSGEN_SHORT_FORM(max, Max)
PHYSGEN_SHORT_FORM(min, Min)
PHYSGEN_SHORT_FORM(argmax, Argmax)
PHYSGEN_SHORT_FORM(all, All)
PHYSGEN_SHORT_FORM(any, Any)
PHYSGEN_SHORT_FORM(count, Count)
#undef PHYSGEN_SHORT_FORM

}  // namespace physgen
