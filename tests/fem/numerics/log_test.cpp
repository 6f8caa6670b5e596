// The logarithm in two parts, against quadruple precision: its digits everywhere, next to 1, and of what its argument's
// tail brings; and that packs and numbers compute the same.
#include <fem/numerics/log.h>
#include <fem/reference/distribution.h>
#include <fem/reference/quad.h>
#include <gtest/gtest.h>
#include <physgen/simd/simd.h>

#include <cstdio>

#include "reference.h"
#include "replay.h"

namespace physgen::fem {
namespace {

using reference::ErrorDistribution, reference::Quad, reference::Random;

// Errors of log_two_part in units of what log.h allows: 1/4 eps |ln x| + 2 eps |x_tail / x|.
template <class Real>
class LogTwoPart : public testing::Test {
 protected:
  static constexpr double eps = std::numeric_limits<Real>::epsilon();

  void add(Real x, Real x_tail) {
    const TwoPart<Real> got = log_two_part(x, x_tail);
    const Quad difference = Quad(got.head) + Quad(got.tail) - reference::log(Quad(x) + Quad(x_tail));
    const Quad ratio = reference::abs(Quad(x_tail) / Quad(x));
    const Quad allowed = Quad(eps / 4) * reference::abs(reference::log(Quad(x))) + Quad(2 * eps) * ratio;
    const double error = difference == 0 ? 0 : double(reference::abs(difference) / allowed);
    errors_.add(error);
    worst_.add(std::isnan(error) ? std::numeric_limits<double>::infinity() : error, {double(x), double(x_tail)});
  }

  // Prints what was added, of which none may be above what is allowed.
  void check() {
    if (const auto given = replayed<2>(variable)) {
      errors_ = {}, worst_ = {};
      add(Real((*given)[0]), Real((*given)[1]));
    }
    const auto e = errors_.summary();
    std::printf("ln, of 1/4 eps |ln x| + 2 eps |x_tail / x|: p50 %.3f p99 %.3f p99.99 %.3f max %.3f at %s\n", e.p50,
                e.p99, e.p9999, e.max, worst_.replay(variable).c_str());
    EXPECT_LE(e.max, 1) << worst_.replay(variable);
  }

 private:
  static constexpr const char* variable = "PHYSGEN_TEST_LOG";
  ErrorDistribution errors_;
  WorstInput<2> worst_;
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(LogTwoPart, Reals);

TYPED_TEST(LogTwoPart, is_as_accurate_as_documented_over_the_whole_range) {
  Random random(11);
  const double range = std::numeric_limits<TypeParam>::max_exponent - 3;
  for (int k = 0; k < 20000; ++k) {
    this->add(TypeParam(std::exp2(random.uniform(-range, range))), 0);
    this->add(TypeParam(random.uniform(0.25, 4)), 0);
  }
  this->check();
}

TYPED_TEST(LogTwoPart, keeps_its_relative_accuracy_next_to_one) {
  Random random(12);
  EXPECT_EQ(log_two_part(TypeParam(1), TypeParam(0)).head, 0);
  EXPECT_EQ(log_two_part(TypeParam(1), TypeParam(0)).tail, 0);
  for (int ulps = 1; ulps <= 64; ++ulps) {
    this->add(TypeParam(1 + ulps * this->eps), 0);
    this->add(TypeParam(1 - ulps * this->eps / 2), 0);
  }
  double distance = 0.3;
  while (distance > 64 * this->eps) {
    distance *= 0.9;
    this->add(TypeParam(1 + distance * random.uniform(0.5, 1)), 0);
    this->add(TypeParam(1 - distance * random.uniform(0.5, 1)), 0);
  }
  this->check();
}

TYPED_TEST(LogTwoPart, includes_the_tail_of_its_argument) {
  Random random(13);
  for (int k = 0; k < 5000; ++k) {
    const double near = std::exp2(random.uniform(-20, -1)) * (k % 2 == 0 ? 1 : -1);
    const auto x = TypeParam(1 + near);
    this->add(x, TypeParam(random.uniform(-1, 1) * this->eps) * x);
    const auto y = TypeParam(random.uniform(0.01, 100));
    this->add(y, TypeParam(random.uniform(-1, 1) * this->eps) * y);
  }
  this->check();
}

TYPED_TEST(LogTwoPart, includes_a_tail_as_large_as_the_logarithm_itself) {
  const auto eps = TypeParam(this->eps), one = TypeParam(1);
  for (const TypeParam x : {one, one + eps, one - eps / 2, one + 2 * eps, one - eps}) {
    for (const TypeParam tail : {eps, eps / 2, eps / 4, TypeParam(1e-3) * eps}) {
      this->add(x, tail);
      this->add(x, -tail);
    }
  }
  this->check();
}

TYPED_TEST(LogTwoPart, gives_nan_for_nan_and_infinity) {
  const auto nan = std::numeric_limits<TypeParam>::quiet_NaN(), infinity = std::numeric_limits<TypeParam>::infinity();
  EXPECT_TRUE(std::isnan(log_two_part(nan, TypeParam(0)).head));
  EXPECT_TRUE(std::isnan(log_two_part(-nan, TypeParam(0)).head));
  EXPECT_TRUE(std::isnan(log_two_part(TypeParam(2), nan).head));
  EXPECT_FALSE(std::isfinite(log_two_part(infinity, TypeParam(0)).head));
}

TYPED_TEST(LogTwoPart, of_packs_is_that_of_numbers) {
  using B = Batch<TypeParam>;
  Random random(14);
  for (int k = 0; k < 1000; ++k) {
    const auto x = TypeParam(std::exp2(random.uniform(-100, 100))), tail = TypeParam(0.3 * this->eps) * x;
    const auto one = log_two_part(x, tail);
    const auto many = log_two_part(B(x), B(tail));
    EXPECT_EQ(one.head, many.head.get(0));
    EXPECT_EQ(one.tail, many.tail.get(0));
  }
}

}  // namespace
}  // namespace physgen::fem
