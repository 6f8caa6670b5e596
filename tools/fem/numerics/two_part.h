// Numbers known to more digits than their scalar type holds, as unevaluated sums of two. Compensated sums and products
// give them; what is a small rest of a difference still has its digits then.
#pragma once

#include <fem/numerics/scalar.h>

namespace physgen::fem {

/// head + tail. From a function below, |tail| <= eps/2 |head|: head is then their sum, rounded.
template <class S>
struct TwoPart {
  S head, tail;
};

/// a + b without error; of a and b, |a| >= |b| or a = 0.
template <class S>
PHYSGEN_FUNCTION inline TwoPart<S> fast_two_sum(const S& a, const S& b) {
  const S sum = a + b;
  return {sum, b - (sum - a)};
}

/// a + b without error.
template <class S>
PHYSGEN_FUNCTION inline TwoPart<S> two_sum(const S& a, const S& b) {
  const S sum = a + b;
  const S of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

/// a b without error, where nothing underflows.
template <class S>
PHYSGEN_FUNCTION inline TwoPart<S> two_product(const S& a, const S& b) {
  const S product = a * b;
  return {product, fma(a, b, -product)};
}

}  // namespace physgen::fem
