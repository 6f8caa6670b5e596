// Scalar functions of kernels, for single numbers and packs of all widths.
#include <gtest/gtest.h>
#include <physgen/simd/simd_access.h>

#include <random>

#include "test_objects.h"

namespace physgen::test {
namespace {

using math::ScalarTraits;

// The numbers in an S.
template <class S>
double lane(const S& x, int l) {
  if constexpr (std::is_floating_point_v<S>) {
    return static_cast<double>(x);
  } else {
    return static_cast<double>(x.get(static_cast<std::size_t>(l)));
  }
}

template <class S>
class MathOf : public testing::Test {
 protected:
  using Real = typename ScalarTraits<S>::Real;
  static constexpr double eps = std::numeric_limits<Real>::epsilon();
  std::mt19937_64 generator{seed()};
  Real random() { return std::uniform_real_distribution<Real>(Real(0.5), Real(4))(generator); }
  /// A positive number of any magnitude whose root and inverse are normal.
  Real of_any_size() {
    constexpr int most = std::numeric_limits<Real>::max_exponent - 6;
    return std::ldexp(random(), std::uniform_int_distribution<int>(-most, most)(generator));
  }
};
using Scalars = testing::Types<float, double, Batch<float>, Batch<double>, batch_t<float, 4>, batch_t<float, 8>,
                               batch_t<double, 2>, batch_t<double, 4>>;
TYPED_TEST_SUITE(MathOf, Scalars);

#ifdef __FMA__  // else packs multiply, then add
TYPED_TEST(MathOf, fma_rounds_once) {
  using Real = typename TestFixture::Real;
  using math::fma;
  for (int k = 0; k < 1000; ++k) {
    const Real x = this->random(), y = this->random();
    const TypeParam product = TypeParam(x) * TypeParam(y);
    const TypeParam rest = fma(TypeParam(x), TypeParam(y), -product);
    for (int l = 0; l < ScalarTraits<TypeParam>::width; ++l) {
      ASSERT_EQ(lane(rest, l), static_cast<double>(std::fma(x, y, -(x * y)))) << x << " * " << y;
    }
  }
}

#endif

TYPED_TEST(MathOf, inverse_roots_are_exact_to_two_eps_and_rough_ones_to_eleven_bits) {
  using Real = typename TestFixture::Real;
  const double rough = sizeof(Real) == 4 ? 0x1p-11 : 4 * TestFixture::eps;
  for (int k = 0; k < 10000; ++k) {
    const Real x = this->of_any_size();
    const long double root = 1 / std::sqrt(static_cast<long double>(x)), inverse = 1 / static_cast<long double>(x);
    const auto error = [](const TypeParam& got, long double exact) {
      return static_cast<double>(std::abs(static_cast<long double>(lane(got, 0)) - exact) / exact);
    };
    ASSERT_LE(error(ScalarTraits<TypeParam>::inverse_sqrt(TypeParam(x)), root), 2 * TestFixture::eps) << x;
    ASSERT_LE(error(ScalarTraits<TypeParam>::rough_inverse_sqrt(TypeParam(x)), root), rough) << x;
    ASSERT_LE(error(ScalarTraits<TypeParam>::rough_inverse(TypeParam(x)), inverse), rough) << x;
  }
}

TYPED_TEST(MathOf, normalising_scale_is_a_power_of_two_that_brings_numbers_to_4_to_8) {
  using Real = typename TestFixture::Real;
  for (int k = 0; k < 10000; ++k) {
    const Real x = this->of_any_size();
    const auto power = ScalarTraits<TypeParam>::normalising_scale(TypeParam(x));
    const double scale = lane(power.scale, 0), inverse = lane(power.inverse, 0);
    ASSERT_EQ(scale * inverse, 1);
    int exponent = 0;
    ASSERT_EQ(std::frexp(scale, &exponent), 0.5);
    // The largest scale is the one whose inverse is normal.
    if (x >= 16 * std::numeric_limits<Real>::min()) {
      ASSERT_GE(static_cast<double>(x) * scale, 4) << x;
    }
    ASSERT_LT(static_cast<double>(x) * scale, 8) << x;
  }
  for (const Real x : {Real(0), std::numeric_limits<Real>::denorm_min()}) {
    const auto power = ScalarTraits<TypeParam>::normalising_scale(TypeParam(x));
    EXPECT_TRUE(std::isnormal(static_cast<Real>(lane(power.scale, 0))));
    EXPECT_TRUE(std::isnormal(static_cast<Real>(lane(power.inverse, 0))));
  }
}

TYPED_TEST(MathOf, split_gives_the_number_back_with_a_mantissa_next_to_1) {
  using Real = typename TestFixture::Real;
  for (int k = 0; k < 10000; ++k) {
    const Real x = this->of_any_size();
    const auto parts = ScalarTraits<TypeParam>::split(TypeParam(x));
    for (int l = 0; l < ScalarTraits<TypeParam>::width; ++l) {
      const double mantissa = lane(parts.mantissa, l), exponent = lane(parts.exponent, l);
      ASSERT_GE(mantissa * mantissa, 0.5 - 1e-6);
      ASSERT_LE(mantissa * mantissa, 2 + 1e-6);
      ASSERT_EQ(exponent, std::nearbyint(exponent));
      ASSERT_EQ(std::ldexp(mantissa, static_cast<int>(exponent)), static_cast<double>(x));
    }
  }
}

TYPED_TEST(MathOf, negative_zero_is_what_minus_makes_of_zero) {
  using S = TypeParam;
  using Real = typename ScalarTraits<S>::Real;
  const S negative = -S(Real(0)), one = S(Real(1)) / negative;
  for (int l = 0; l < ScalarTraits<S>::width; ++l) {
    EXPECT_TRUE(std::signbit(lane(negative, l)));
    EXPECT_EQ(lane(one, l), -INFINITY);
    EXPECT_FALSE(std::signbit(lane(S(-negative), l)));
  }
}

// A plain number beside integers is one that they can hold.
template <class A, class B>
concept HaveMax = requires(const A& a, const B& b) { math::max(a, b); };
template <class A, class B>
concept AreSelected = requires(const A& a, const B& b) { math::select(true, a, b); };
static_assert(HaveMax<std::int32_t, short> && HaveMax<xsimd::batch<std::int32_t>, int> && HaveMax<float, unsigned>);
static_assert(!HaveMax<std::int32_t, unsigned> && !HaveMax<xsimd::batch<std::int32_t>, unsigned> &&
              !HaveMax<std::int32_t, std::int64_t> && !AreSelected<std::int32_t, unsigned>);

}  // namespace
}  // namespace physgen::test
