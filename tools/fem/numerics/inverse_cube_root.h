// x^(-1/3) and x^(-2/3) to more digits than the scalar type has: the isochoric parts of an energy are scaled with them.
#pragma once

#include <fem/numerics/two_part.h>

#include <cmath>
#include <type_traits>

namespace physgen::fem {

namespace detail {

/// An estimate of x^(-1/3), x > 0, to a few eps: the platform's own, which differ in the last digit.
template <class S>
PHYSGEN_FUNCTION inline S estimated_inverse_cube_root(const S& x) {
  if constexpr (std::is_floating_point_v<S>) {
#ifdef __CUDA_ARCH__
    return ::rcbrt(x);
#else
    return S(1) / std::cbrt(x);
#endif
  } else {
    return S(RealOf<S>(1)) / cbrt(x);  // of packs, by argument-dependent lookup
  }
}

}  // namespace detail

/// x^(-1/3) in two parts, to a few eps^2: one Newton step from the estimate y, y (1 - x y^3) / 3, whose remainder is
/// found without cancellation. So the estimate's error, and its differences between platforms, are gone.
/// @param x in two parts, > 0 and normal
template <class S>
PHYSGEN_FUNCTION inline TwoPart<S> inverse_cube_root(const TwoPart<S>& x) {
  using Real = RealOf<S>;
  const S y = detail::estimated_inverse_cube_root(x.head);
  const TwoPart<S> square = two_product(y, y), product = two_product(x.head, y);
  const S product_tail = fma(x.tail, y, product.tail);
  const S remainder =
      fma(-product.head, square.head, S(Real(1))) - fma(product_tail, square.head, product.head * square.tail);
  return {y, y * (remainder * S(Real(1) / Real(3)))};
}

/// x^(-2/3) in two parts, to a few eps^2. @param x in two parts, > 0 and normal
template <class S>
PHYSGEN_FUNCTION inline TwoPart<S> inverse_cube_root_squared(const TwoPart<S>& x) {
  const TwoPart<S> y = inverse_cube_root(x);
  const TwoPart<S> square = two_product(y.head, y.head);
  return fast_two_sum<S>(square.head, fma(y.head + y.head, y.tail, square.tail));
}

/// x^(2/3) of x >= 0, error about 1 eps.
template <class S>
PHYSGEN_FUNCTION inline S cube_root_squared(const S& x) {
  const S zero(RealOf<S>(0));
  const TwoPart<S> y = inverse_cube_root(TwoPart<S>{x, zero});
  return select(x == zero, zero, x * (y.head + y.tail));
}

}  // namespace physgen::fem
