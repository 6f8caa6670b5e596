// Conversions between the types of numbers, and selection among vectors and matrices: lane by lane, entry by entry, for
// single objects, packs and CUDA threads. simd_lanes.h adds packs.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/kernels/math.h>
#include <physgen/kernels/matrix_value.h>

namespace physgen::math {

namespace detail {

/// From's numbers as numbers of type To, in as many lanes.
template <class To, class From>
struct Cast {
  static_assert(std::is_arithmetic_v<From>, "cast() and to_real() take numbers, packs, and Eigen matrices of them");
  using type = To;
  PHYSGEN_FUNCTION static To of(const From& x) { return static_cast<To>(x); }
};

/// The matrix of entry(0), entry(1), ..., in storage order.
template <class S, class Shape, class Entry>
PHYSGEN_FUNCTION inline auto matrix_of(const Entry& entry) {
  static_assert(Shape::SizeAtCompileTime > 0, "vectors and matrices of kernels have fixed sizes");
  MatrixValue<S, Shape::RowsAtCompileTime, Shape::ColsAtCompileTime> result;
  PHYSGEN_UNROLL
  for (int c = 0; c < Shape::ColsAtCompileTime; ++c) {
    PHYSGEN_UNROLL
    for (int r = 0; r < Shape::RowsAtCompileTime; ++r) result(r, c) = entry(r, c);
  }
  return result;
}

}  // namespace detail

/// `cast<double>(x)`: a float as a double, a pack of floats as one of as many doubles, and back, rounded to nearest;
/// of a vector or matrix, each entry. Packs have float and double in equal lane counts where the kernel's Scalar is
/// double.
template <std::floating_point To, Lanewise S>
PHYSGEN_FUNCTION inline auto cast(const S& x) {
  return detail::Cast<To, S>::of(x);
}
template <std::floating_point To, class Derived>
PHYSGEN_FUNCTION inline auto cast(const Eigen::MatrixBase<Derived>& x) {
  const auto& entries = x.derived();
  using S = typename detail::Cast<To, typename Derived::Scalar>::type;
  return detail::matrix_of<S, Derived>(
      [&](int r, int c) { return detail::Cast<To, typename Derived::Scalar>::of(entries(r, c)); });
}

/// `to_real<S>(n)`: integers, such as numbers(i) or a field of Index, as an S of as many lanes, rounded to nearest.
template <class S, class Integers>
PHYSGEN_FUNCTION inline S to_real(const Integers& n) {
  static_assert(!std::is_floating_point_v<Integers>, "to_real() takes integers; cast<double>() takes floats");
  return detail::Cast<typename ScalarTraits<S>::Real, Integers>::of(n);
}

/// `to_index(floor(x / h))`: floating numbers as 32-bit indices of as many lanes; digits behind the point are cut.
/// @pre -2^31 <= x < 2^31, not NaN
template <Lanewise S>
PHYSGEN_FUNCTION inline auto to_index(const S& x) {
  static_assert(!detail::holds_integers<S>, "to_index() takes floating numbers; integers are indices already");
  return detail::Cast<std::int32_t, S>::of(x);
}

/// `condition ? a : b` for vectors and matrices, whose entries all have the condition of their lane.
template <class Condition, class A, class B>
PHYSGEN_FUNCTION inline auto select(const Condition& condition, const Eigen::MatrixBase<A>& a,
                                    const Eigen::MatrixBase<B>& b) {
  EIGEN_STATIC_ASSERT_SAME_MATRIX_SIZE(A, B)
  const auto& x = a.derived();
  const auto& y = b.derived();
  using S = typename A::Scalar;
  return detail::matrix_of<S, A>([&](int r, int c) { return select(condition, S(x(r, c)), S(y(r, c))); });
}

}  // namespace physgen::math

#pragma pop_macro("I")
