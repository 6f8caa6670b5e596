// Fused kernels in packs and for single objects: see fuse_checks.h.
#include <physgen/executor.h>

#include "fuse_checks.h"

namespace physgen::test {
namespace {

template <int kLanes>
constexpr auto on_host =
    [](index_t begin, index_t end, const auto& kernel) { parallel_for(Host{}, begin, end, lanes<kLanes>(kernel)); };

TEST(Fuse, has_the_bits_of_separate_kernels_in_packs) {
  check_fused<float, Host, Soa>(on_host<0>);
  check_fused<double, Host, Aosoa<16>>(on_host<0>);
  check_fused<float, Host, Aos>(on_host<4>);
}

TEST(Fuse, has_the_bits_of_separate_kernels_for_single_objects) {
  check_fused<float, Host, Soa>(on_host<1>);
  check_fused<double, Host, Aos>(on_host<1>);
}

TEST(Fuse, runs_on_executors_and_folds_what_the_last_step_returns) {
  HostExecutor on;
  check_fused_on<Host>(on);
}

// ---- Lanes of steps ----

/// Computes what single objects and packs may round differently, and tells how many objects it is called with at once.
template <class From, class To>
struct Spread {
  using Scalar = typename To::Precision;
  From from;
  To to;
  template <class I>
  void operator()(I i) const {
    using namespace math;
    using S = lanes_t<Scalar, I>;
    const auto x = from[i].f().get();
    to[i].f()[0] = sin(S(x.dot(x))) + x[2];
    to[i].f()[1] = S(x.squaredNorm() * x[1]);
    to[i].f()[2] = x[2] + S(Scalar(index_width(i)));
  }
};
template <class... Views>
Spread(Views...) -> Spread<Views...>;

/// The same, as a term.
template <class From>
struct SpreadTerm {
  using Scalar = typename From::Precision;
  From from;
  template <class I>
  auto operator()(I i) const {
    using namespace math;
    using S = lanes_t<Scalar, I>;
    const auto x = from[i].f().get();
    return Eigen::Matrix<S, 2, 1>(sin(S(x.dot(x))), x[2] + S(Scalar(index_width(i))));
  }
};
template <class... Views>
SpreadTerm(Views...) -> SpreadTerm<Views...>;

template <class Real>
class FusedLanes : public ::testing::Test {
 protected:
  template <class Layout>
  using Vectors = Array<Numbers, Real, Host, Layout>;
  static constexpr index_t size = 61, begin = 3;  // neither the first nor the last pack is whole

  FusedLanes() {
    std::mt19937 random(seed());
    std::uniform_real_distribution<Real> value(-2, 2);
    for (index_t i = 0; i < size; ++i)
      in.view()[i].f() = Eigen::Matrix<Real, 3, 1>(value(random), value(random), value(random));
  }
  template <class First, class Second>
  void expect_same(First& first, Second& second) const {
    for (index_t i = begin; i < size; ++i) {
      const Eigen::Matrix<Real, 3, 1> a = first.view()[i].f().get(), b = second.view()[i].f().get();
      ASSERT_EQ(std::memcmp(a.data(), b.data(), 3 * sizeof(Real)), 0) << i << ": " << a << ", " << b;
    }
  }

  Vectors<Aos> in{size}, a{size}, c{size}, apart{size}, joined{size};
  Vectors<Soa> b{size};
  static constexpr auto local_a = local<Numbers, Real, FormatsOfSpace, struct LocalA, Aos>();
  static constexpr auto local_b = local<Numbers, Real, FormatsOfSpace, struct LocalB, Soa>();
  static constexpr auto local_c = local<Numbers, Real, FormatsOfSpace, struct LocalC, Aos>();
};
using Reals = ::testing::Types<float, double>;
TYPED_TEST_SUITE(FusedLanes, Reals);

TYPED_TEST(FusedLanes, are_those_of_each_step_by_itself) {
  const auto from = this->in.const_view();
  const auto run = [](const auto&... kernels) {
    (parallel_for(Host{}, TestFixture::begin, TestFixture::size, kernels), ...);
  };
  run(Spread{from, this->a.view()}, Spread{this->a.const_view(), this->b.view()},
      Spread{this->b.const_view(), this->c.view()}, Spread{this->c.const_view(), this->apart.view()});
  const auto [a, b, c] = std::tuple(this->local_a, this->local_b, this->local_c);
  const auto to = this->joined.view();
  run(fuse(locals(a, b, c), Spread{from, a}, Spread{a, b}, Spread{b, c}, Spread{c, to}));
  this->expect_same(this->apart, this->joined);
  run(fuse(locals(a), Spread{from, a}, fuse(locals(b, c), Spread{a, b}, Spread{b, c}, Spread{c, to})));
  this->expect_same(this->apart, this->joined);
  // All of them suit single objects.
  run(Spread{from, this->a.view()}, Spread{this->a.const_view(), this->apart.view()});
  run(fuse(locals(a), Spread{from, a}, Spread{a, to}));
  this->expect_same(this->apart, this->joined);
}

TYPED_TEST(FusedLanes, are_those_of_each_step_where_the_last_returns_a_term) {
  const auto from = this->in.const_view();
  const auto [a, b, c] = std::tuple(this->local_a, this->local_b, this->local_c);
  const auto total = [](const auto& kernel) { return sum(Host{}, TestFixture::begin, TestFixture::size, kernel); };
  parallel_for(Host{}, this->begin, this->size, Spread{from, this->b.view()});
  parallel_for(Host{}, this->begin, this->size, Spread{this->b.const_view(), this->c.view()});
  const auto in_packs = total(SpreadTerm{this->b.const_view()}), one_by_one = total(SpreadTerm{this->c.const_view()});
  EXPECT_EQ(total(fuse(locals(b), Spread{from, b}, SpreadTerm{b})), in_packs);
  EXPECT_EQ(total(fuse(locals(b, c), Spread{from, b}, Spread{b, c}, SpreadTerm{c})), one_by_one);
}

TYPED_TEST(FusedLanes, are_those_that_are_stated_for_all_steps) {
  const auto from = this->in.const_view();
  const auto [a, b] = std::tuple(this->local_a, this->local_b);
  const auto expect = [&]<int W>(std::integral_constant<int, W>) {
    const auto run = [](const auto&... kernels) {
      (parallel_for(Host{}, TestFixture::begin, TestFixture::size, lanes<W>(kernels)), ...);
    };
    run(Spread{from, this->a.view()}, Spread{this->a.const_view(), this->b.view()},
        Spread{this->b.const_view(), this->apart.view()});
    run(fuse(locals(a), Spread{from, a}, fuse(locals(b), Spread{a, b}, Spread{b, this->joined.view()})));
    this->expect_same(this->apart, this->joined);
  };
  expect(std::integral_constant<int, 0>());  // the library's choice for each
  expect(std::integral_constant<int, 1>());
  expect(std::integral_constant<int, detail::pack_lanes<TypeParam>()>());
}

struct Halves : elasticity::NodeForceFormats<Host> {
  using f = format::Half<>;
};

TEST(Fuse, rounds_through_the_formats_of_a_local) {
  elasticity::NodeForceArray<float> in(33), out(33);
  for (index_t i = 0; i < 33; ++i) in.view()[i].f() = Eigen::Vector3f::Constant(1 + static_cast<float>(i) * 0x1p-12F);
  const auto rounded = local<Numbers, float, Halves>();
  const auto from = in.const_view();
  const auto to = out.view();
  parallel_for(Host{}, 33,
               fuse(locals(rounded), over<float>([=](auto i) { rounded[i].f() = from[i].f().get(); }),
                    over<float>([=](auto i) { to[i].f() = rounded[i].f().get(); })));
  for (index_t i = 0; i < 33; ++i) {
    const float given = from[i].f()[0], half = format::Half<>::decode<float>(format::Half<>::encode<float>(given));
    EXPECT_EQ(to[i].f()[0], half);
    EXPECT_EQ(given == half, i % 4 == 0) << i;
  }
}

TEST(Fuse, takes_the_packs_of_the_widest_number) {
  const auto narrow = over<float>([](auto /*i*/) {});
  const auto wide = over<double>([](auto /*i*/) {});
  EXPECT_TRUE((std::is_same_v<decltype(fuse(locals(), narrow, wide))::Scalar, double>));
  EXPECT_TRUE((std::is_same_v<decltype(fuse(locals(), wide, narrow))::Scalar, double>));
  std::vector<int> seen(11, 0);
  const auto count = over<float>([&seen](auto i) {
    const LaneRange lanes = lane_range(i);
    for (int l = lanes.first; l < lanes.last; ++l) {
      ++seen[static_cast<std::size_t>(detail::bare(i).begin + l)];
    }
    EXPECT_EQ(index_width(i), native_lanes<double>);
  });
  if constexpr (detail::pack_lanes<double>() > 1) {
    parallel_for(Host{}, 11, fuse(locals(), narrow, wide, count));
    EXPECT_EQ(seen, std::vector<int>(11, 1));
  }
}

TEST(Fuse, costs_a_kernel_nothing_for_its_locals) {
  const auto a = local<Numbers, float>();
  EXPECT_TRUE(std::is_empty_v<decltype(a)>);
  const elasticity::NodeForceArray<float>::View view;
  const auto step = Turn{view, local<Frames, float>()};
  EXPECT_TRUE((std::is_trivially_copyable_v<decltype(fuse(locals(a), step, step))>));
}

}  // namespace
}  // namespace physgen::test
