// The terms of a reduction, entry by entry, and the sizes on which its order (reduce.h) depends.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/kernels/lanes.h>
#include <physgen/kernels/matrix_value.h>

#include <array>
#include <type_traits>

namespace physgen::detail {

inline constexpr int reduce_block = 2048, reduce_lanes = 32, reduce_strands = 1024;

/// Splits the term that a kernel returned into entries, and makes the result from those of its entries.
template <class Term>
struct Terms {
  static constexpr int count = 1;
  using Entry = Term;
  template <class Value>
  using Result = Value;
  [[nodiscard]] PHYSGEN_FUNCTION static const Term& entry(const Term& term, int /*k*/) { return term; }
  template <class Value>
  [[nodiscard]] PHYSGEN_FUNCTION static Value result(const Value* values) {
    return values[0];
  }
};
template <class T, std::size_t kCount>
struct Terms<std::array<T, kCount>> {
  static constexpr int count = static_cast<int>(kCount);
  using Entry = T;
  template <class Value>
  using Result = std::array<Value, kCount>;
  [[nodiscard]] PHYSGEN_FUNCTION static const T& entry(const std::array<T, kCount>& term, int k) {
    return term[static_cast<std::size_t>(k)];
  }
  template <class Value>
  [[nodiscard]] PHYSGEN_FUNCTION static Result<Value> result(const Value* values) {
    Result<Value> result{};
    for (std::size_t k = 0; k < kCount; ++k) result[k] = values[k];
    return result;
  }
};
template <class T, int kRows, int kCols, int kOptions, int kMaxRows, int kMaxCols>
struct Terms<Eigen::Matrix<T, kRows, kCols, kOptions, kMaxRows, kMaxCols>> {
  static_assert(kRows > 0 && kCols > 0, "a kernel of parallel_reduce() returns matrices of fixed size");
  static constexpr int count = kRows * kCols;
  using Entry = T;
  template <class Value>
  using Result = MatrixValue<Value, kRows, kCols>;
  template <class Matrix>
  [[nodiscard]] PHYSGEN_FUNCTION static const T& entry(const Matrix& term, int k) {
    return term.data()[k];
  }
  template <class Value>
  [[nodiscard]] PHYSGEN_FUNCTION static Result<Value> result(const Value* values) {
    Eigen::Matrix<Value, kRows, kCols, kOptions, kMaxRows, kMaxCols> result;
    for (int k = 0; k < count; ++k) result.data()[k] = values[k];
    return result;
  }
};
template <class T, int kRows, int kCols>
struct Terms<MatrixValue<T, kRows, kCols>> : Terms<Eigen::Matrix<T, kRows, kCols>> {};

/// All types of a reduction. @tparam I an index that the kernel is called with
template <class Kernel, class Fold, class I>
struct Reduction {
  using Term = std::remove_cvref_t<std::invoke_result_t<const Kernel&, const I&>>;
  using Entries = Terms<Term>;
  using Number = lane_of_t<typename Entries::Entry>;
  static_assert(std::is_arithmetic_v<Number>,
                "a kernel of parallel_reduce() returns its term by value: a number or condition (in packs a batch or a "
                "mask), a std::array of them, or an Eigen vector or matrix of them. For a field's element write "
                "`-> lanes_t<Scalar, I>` as the type that the kernel returns, in a lambda `return view[i].m().get()`; "
                "for an expression of Eigen its Matrix type");
  using Value = typename Fold::template Value<Number>;
  using Result = typename Entries::template Result<Value>;
  static constexpr int count = Entries::count;
  static_assert(std::is_trivially_copyable_v<Value> && sizeof(Value) <= 64);
};

/// The number of blocks in which the objects begin .. end-1 lie.
[[nodiscard]] constexpr index_t blocks_of(index_t begin, index_t end) {
  return begin < end ? (end - 1) / reduce_block - begin / reduce_block + 1 : 0;
}

}  // namespace physgen::detail

#pragma pop_macro("I")
