// SIMD packs (xsimd batches) as scalars of kernels and of Eigen matrices on the CPU. Never included by CUDA translation
// units. sqrt, abs, log1p, select and the rest come from namespace xsimd by argument-dependent lookup.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#ifdef __CUDACC__
#error \
    "physgen/simd/simd.h and parallel_for.h are for host translation units (.cpp); .cu: <physgen/cuda/parallel_for.h>, float, double"
#endif

#include <physgen/detail/simd_functions.h>
#include <physgen/detail/simd_masks.h>
#include <physgen/detail/simd_numbers.h>
#include <physgen/detail/simd_repairs.h>
#include <physgen/detail/simd_roots.h>
#include <physgen/detail/simd_std.h>
#include <physgen/kernels/math.h>

#include <Eigen/Core>
#include <type_traits>
#include <xsimd/xsimd.hpp>

namespace physgen {

static_assert(
    !std::is_constructible_v<bool, xsimd::batch_bool<float>> &&
        !std::is_constructible_v<bool, xsimd::batch_bool<std::int32_t>> &&
        !std::is_constructible_v<xsimd::batch<float>, xsimd::batch<std::int32_t>>,
    "masks convert to bool with this xsimd, so that `if (mask)` would mean any lane, or packs to packs of other "
    "numbers: see simd_masks.h and simd_registers.h, which must be included before <xsimd/xsimd.hpp>");

/// The widest batch of the target architecture.
template <class Real>
using Batch = xsimd::batch<Real>;

namespace math {

template <class T, class A>
struct ScalarTraits<xsimd::batch<T, A>> {
  using S = xsimd::batch<T, A>;
  using Real = T;
  static constexpr int width = static_cast<int>(S::size);

  static S inverse_sqrt(const S& x) { return detail::inverse_sqrt(x); }
  static S rough_inverse_sqrt(const S& x) { return detail::rough_inverse_sqrt(x); }
  static S rough_inverse(const S& x) { return detail::rough_inverse(x); }

  static PowerOfTwo<S> normalising_scale(const S& x) {
    using Int = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
    using Bits = xsimd::batch<Int, A>;
    constexpr int mantissa = std::numeric_limits<T>::digits - 1;
    constexpr Int bias = std::numeric_limits<T>::max_exponent - 1;
    const Bits exponent = xsimd::bitwise_cast<Bits>(x) >> mantissa;
    const Bits scale = xsimd::min(Bits(2 * bias + 2) - exponent, Bits(2 * bias - 1));
    return {xsimd::bitwise_cast<S>(scale << mantissa), xsimd::bitwise_cast<S>((Bits(2 * bias) - scale) << mantissa)};
  }

  static MantissaExponent<S> split(const S& x) {
    using Int = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
    using Bits = xsimd::batch<Int, A>;
    constexpr int mantissa = std::numeric_limits<T>::digits - 1;
    constexpr Int bias = std::numeric_limits<T>::max_exponent - 1;
    constexpr Int least = std::bit_cast<Int>(T(0.70710678118654752440L));
    // An integer below 2^mantissa, put into the low bits of this number, is added to it: the conversion to S.
    constexpr T holder = static_cast<T>(Int(1) << mantissa);
    const Bits raised = xsimd::bitwise_cast<Bits>(x) + Bits((bias << mantissa) - least);
    const Bits low = raised & Bits((Int(1) << mantissa) - 1);
    const Bits held = (raised >> mantissa) + Bits(std::bit_cast<Int>(holder));
    return {xsimd::bitwise_cast<S>(low + Bits(least)), xsimd::bitwise_cast<S>(held) - S(holder + T(bias))};
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

#pragma pop_macro("I")
