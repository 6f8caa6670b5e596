// Conditions and choices mean the same in packs as for one object, of integers beside floats and doubles, with NaN and
// the ends of what 32 bits hold. Compiled with optimization, because that is where a compiler was seen to invert
// choices: g++ 12 for AVX-512, see simd_repairs.h.
#include <physgen/kernel.h>
#include <physgen/parallel_for.h>

#include "in_packs.h"
#include "test_objects.h"

namespace physgen::test {
namespace {

using elasticity::EdgeArray;
using elasticity::StressDerivativeArray;

constexpr std::array<std::int32_t, 16> integers{
    0, 1, -1, 2, -7, 7, 100, -100, 16777217, 33554435, -16777219, 2147483647, -2147483647, 46341, 3, 1000003};

template <class Real>
std::array<Real, 16> reals() {
  using Limits = std::numeric_limits<Real>;
  return {0,
          Real(-0.0),
          1,
          -1,
          Real(0.5),
          Real(-0.5),
          Real(2.5),
          Real(-2.5),
          1e9,
          Real(-2e9),
          Real(3.75),
          Real(-3.75),
          3,
          Limits::quiet_NaN(),
          Limits::infinity(),
          -Limits::infinity()};
}

template <class Real, class Expression>
struct Apply {
  using Scalar = Real;
  typename EdgeArray<Real>::View edges, edges_out;
  typename StressDerivativeArray<Real>::View numbers_in, numbers_out;
  Expression expression;

  template <class I>
  void operator()(const I& i) const {
    using S = lanes_t<Real, I>;
    using N = lanes_t<std::int32_t, I>;
    const auto ends = edges[i].nodes();
    const N a = ends[0], b = ends[1];
    const S m = numbers_in[i].x1111(), u = numbers_in[i].x2211();
    N chosen = a;
    S number = m;
    for (int round = 0; round < 3; ++round) expression(chosen, number, b, u);
    edges_out[i].nodes()[0] = chosen;
    numbers_out[i].x1111() = number;
  }
};

/// Runs expression(chosen integer, number, other integer, other number) for all pairs of inputs, thrice each.
template <class Real, class Expression>
void expect_the_same(const char* what, const Expression& expression) {
  constexpr index_t n = 16 * 16 - 5;  // the last pack is partial
  EdgeArray<Real> edges(n), packs(n), ones(n);
  StressDerivativeArray<Real> in(n), of_packs(n), of_ones(n);
  const auto values = reals<Real>();
  for (index_t k = 0; k < n; ++k) {
    const auto first = static_cast<std::size_t>(k % 16), second = static_cast<std::size_t>(k / 16);
    edges.view()[k].nodes()[0] = integers[first];
    edges.view()[k].nodes()[1] = integers[second];
    in.view()[k].x1111() = values[first];
    in.view()[k].x2211() = values[second];
  }
  const Apply<Real, Expression> kernel{edges.view(), packs.view(), in.view(), of_packs.view(), expression};
  const Apply<Real, Expression> single{edges.view(), ones.view(), in.view(), of_ones.view(), expression};
  parallel_for(Host{}, n, in_packs(kernel));
  parallel_for(Host{}, n, lanes<1>(single));
  for (index_t k = 0; k < n; ++k) {
    ASSERT_EQ(int(packs.view()[k].nodes()[0]), int(ones.view()[k].nodes()[0])) << what << ", object " << k;
    const Real pack = of_packs.view()[k].x1111(), one = of_ones.view()[k].x1111();
    ASSERT_TRUE(pack == one || (pack != pack && one != one)) << what << ", object " << k << ": " << pack << ", " << one;
  }
}
// PHYSGEN_SAME is undefined below: its expression stores to `c` or `x`, from these, `b` and `u`.
#define PHYSGEN_SAME(statement)                                                          \
  expect_the_same<Real>(#statement, [](auto& c, auto& x, const auto& b, const auto& u) { \
    using namespace math;                                                                \
    (void)c, (void)x, (void)b, (void)u;                                                  \
    statement;                                                                           \
  })

template <class Real>
void check_conditions() {
  PHYSGEN_SAME(c = select(c != b, c, b));
  PHYSGEN_SAME(c = select(!(c > b), c / 2, b));
  PHYSGEN_SAME(c = select(c == b, c, b));
  PHYSGEN_SAME(c = select(c <= b, b, c));
  PHYSGEN_SAME(c = select(!(c == b), c, 3));
  PHYSGEN_SAME(c = select(x != u, c, b));
  PHYSGEN_SAME(c = select(!(x < u), c, b));
  PHYSGEN_SAME(c = select(x < u && c != b, c, b));
  PHYSGEN_SAME(c = select(c != b || x < u, c, b));
  PHYSGEN_SAME(c = select(isnan(x), c, b));
  PHYSGEN_SAME(c = select(!isfinite(x) || isinf(u), c / 3, b));
  PHYSGEN_SAME(c = select(x > u, c / 2 + 1, c));
  PHYSGEN_SAME(c = min(c, b));
  PHYSGEN_SAME(c = max(c, b));
  PHYSGEN_SAME(c = clamp(c, -5, 5));
  PHYSGEN_SAME(x = clamp(x, -1, 2.5));  // NaN stays NaN
  PHYSGEN_SAME(x = select(x != x, u, x));
  PHYSGEN_SAME(x = select(x != u, x, u));
  PHYSGEN_SAME(x = select(!(x < u), x / 2, u));
  PHYSGEN_SAME(x = select(c != b, x / 2, u));
  PHYSGEN_SAME(x = select(!(c > b), x, u));
  PHYSGEN_SAME(x = select(c >= b && x < u, x, u));
  PHYSGEN_SAME(x = select(x < u, x, u); c = select(x != u, c / 2, b));
}
#undef PHYSGEN_SAME

TEST(Conditions, mean_the_same_in_packs_of_floats_as_for_one_object) { check_conditions<float>(); }
TEST(Conditions, mean_the_same_in_packs_of_doubles_as_for_one_object) { check_conditions<double>(); }

}  // namespace
}  // namespace physgen::test
