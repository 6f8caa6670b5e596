// SIMD packs (xsimd batches) as scalars of kernels and of Eigen matrices on the CPU. Never included by CUDA translation
// units. sqrt, abs, log1p, select and the rest come from namespace xsimd by argument-dependent lookup.
#pragma once

#ifdef __CUDACC__
#error "physgen/simd.h is for host translation units only; kernels take float or double on CUDA"
#endif

#include <physgen/math.h>

#include <Eigen/Core>
#include <type_traits>
#include <xsimd/xsimd.hpp>

namespace physgen {

/// The widest batch of the target architecture.
template <class Real>
using Batch = xsimd::batch<Real>;

namespace math {

template <class T, class A>
struct ScalarTraits<xsimd::batch<T, A>> {
  using S = xsimd::batch<T, A>;
  using Real = T;
  static constexpr int width = static_cast<int>(S::size);

  static S inverse_sqrt(const S& x) { return S(T(1)) / xsimd::sqrt(x); }

  static PowerOfTwo<S> normalising_scale(const S& x) {
    using Int = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
    using Bits = xsimd::batch<Int, A>;
    constexpr int mantissa = std::numeric_limits<T>::digits - 1;
    constexpr Int bias = std::numeric_limits<T>::max_exponent - 1;
    const Bits exponent = xsimd::bitwise_cast<Bits>(x) >> mantissa;
    const Bits scale = xsimd::min(Bits(2 * bias + 2) - exponent, Bits(2 * bias - 1));
    return {xsimd::bitwise_cast<S>(scale << mantissa), xsimd::bitwise_cast<S>((Bits(2 * bias) - scale) << mantissa)};
  }
};

}  // namespace math
}  // namespace physgen

namespace Eigen {

// ReadCost and friends of 1 keep Eigen on lazy, fully unrolled products of small fixed-size matrices.
template <class T, class A>
struct NumTraits<xsimd::batch<T, A>> : GenericNumTraits<T> {
  using Real = xsimd::batch<T, A>;
  using NonInteger = xsimd::batch<T, A>;
  using Nested = xsimd::batch<T, A>;
  using Literal = T;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
  static Real epsilon() { return Real(std::numeric_limits<T>::epsilon()); }
  static Real dummy_precision() { return Real(NumTraits<T>::dummy_precision()); }
  static Real highest() { return Real(std::numeric_limits<T>::max()); }
  static Real lowest() { return Real(std::numeric_limits<T>::lowest()); }
};

// Lets a matrix of packs be scaled by one number: `Matrix<Batch<float>, 3, 3>{} * 0.5f`.
template <class T, class A, class BinaryOp>
struct ScalarBinaryOpTraits<xsimd::batch<T, A>, T, BinaryOp> {
  using ReturnType = xsimd::batch<T, A>;
};
template <class T, class A, class BinaryOp>
struct ScalarBinaryOpTraits<T, xsimd::batch<T, A>, BinaryOp> {
  using ReturnType = xsimd::batch<T, A>;
};

}  // namespace Eigen
