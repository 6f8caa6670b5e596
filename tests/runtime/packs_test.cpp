// Packs: the first and the last of a range see the objects of the range only, whatever lies in the padding and beside
// it; sums through gathered indices lose nothing; packs of double beside integers work on every processor.
#include <physgen/kernel.h>
#include <physgen/parallel_for.h>

#include <limits>

#include "in_packs.h"
#include "test_objects.h"

namespace physgen::test {
namespace {

using elasticity::EdgeArray;
using elasticity::NodeForceArray;
using elasticity::StressDerivativeArray;
using elasticity::TetArray;

template <class TetView, class ForceView>
struct AddToCorners {
  using Scalar = typename ForceView::Precision;
  TetView tets;
  ForceView forces;

  template <class I>
  void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    using Node = lanes_t<std::int32_t, I>;
    const auto nodes = tets[i].nodes();
    for (int c = 0; c < 4; ++c) {
      const Node node = nodes[c];
      add(i, forces[node].f(), Eigen::Matrix<S, 3, 1>(S(Scalar(1)), S(Scalar(c + 1)), S(Scalar(8))));
      add(i, forces[node].f()[2], S(Scalar(-7)));
    }
  }
};

template <class Real, class Layout>
void check_sums(index_t tets_count, index_t begin, index_t end, int nodes_count) {
  TetArray<Real> tets(tets_count);
  NodeForceArray<Real, Host, Layout> forces(nodes_count);
  std::mt19937 random(seed());
  std::vector<std::array<int, 3>> expected(static_cast<std::size_t>(nodes_count));
  for (index_t t = 0; t < tets_count; ++t) {
    for (int c = 0; c < 4; ++c) {
      const auto node = static_cast<std::int32_t>(random() % static_cast<unsigned>(nodes_count));
      tets.view()[t].nodes()[c] = node;
      if (t < begin || t >= end) continue;
      auto& sum = expected[static_cast<std::size_t>(node)];
      sum[0] += 1;
      sum[1] += c + 1;
      sum[2] += 1;
    }
  }
  parallel_for(Host{}, begin, end,
               AddToCorners<typename TetArray<Real>::View, typename NodeForceArray<Real, Host, Layout>::View>{
                   tets.view(), forces.view()});
  for (index_t n = 0; n < nodes_count; ++n) {
    for (int k = 0; k < 3; ++k) {
      ASSERT_EQ(forces.view()[n].f()[k], static_cast<Real>(expected[static_cast<std::size_t>(n)][std::size_t(k)]))
          << "node " << n << ", tets " << begin << " to " << end << " of " << tets_count;
    }
  }
}

TEST(Add, sums_lanes_that_name_one_object_and_leaves_out_what_is_no_object) {
  for (const index_t n : {1, 3, 15, 16, 17, 70}) {
    check_sums<float, AosPadded>(n, 0, n, 1);
    check_sums<double, Soa>(n, n / 3, n, 3);
    check_sums<float, Aosoa<8>>(n, n / 2, n / 2 + 1, 5);
  }
}

TEST(Add, wraps_around_where_integers_end) {
  std::int32_t sum = std::numeric_limits<std::int32_t>::max();
  std::int16_t narrow = std::numeric_limits<std::int16_t>::max();
  detail::add_atomically(sum, 2);
  detail::add_atomically(narrow, std::int16_t{2});
  EXPECT_EQ(sum, std::numeric_limits<std::int32_t>::min() + 1);
  EXPECT_EQ(narrow, std::numeric_limits<std::int16_t>::min() + 1);
}
TEST(Add, sums_what_several_threads_add) { check_sums<float, AosPadded>(200'000, 5, 199'990, 7); }

/// A link to "no neighbour" in every object that is none: the initial value of an index field.
TEST(PartialPacks, never_gather_by_indices_that_lie_in_padding) {
  EdgeArray<float> edges(5);
  const UntypedArray array = edges.untyped();
  const std::int32_t beyond = std::numeric_limits<std::int32_t>::max();
  for (index_t at = 0; at < array.bytes(); at += 4) std::memcpy(array.base + at, &beyond, 4);
  for (index_t e = 0; e < 5; ++e) {
    for (int k = 0; k < 2; ++k) edges.view()[e].nodes()[k] = static_cast<std::int32_t>(e) + k;
  }
  NodeForceArray<float> nodes(6);
  StressDerivativeArray<float> out(5);
  for (index_t n = 0; n < 6; ++n) nodes.view()[n].f() = Eigen::Vector3f::Constant(static_cast<float>(n));
  const auto read = edges.const_view();
  const auto from = nodes.const_view();
  const auto to = out.view();
  parallel_for(Host{}, 5, over<float>([=](auto i) {
                 using Node = lanes_t<std::int32_t, decltype(i)>;
                 const auto ends = read[i].nodes();
                 const Node m = ends[0], n = ends[1];
                 to[i].x1111() = from[m].f()[0] + from[n].f()[1];
               }));
  for (index_t e = 0; e < 5; ++e) EXPECT_EQ(out.view()[e].x1111(), static_cast<float>(2 * e + 1));
}

template <class Layout>
class PartialPacksOver : public ::testing::Test {};
TYPED_TEST_SUITE(PartialPacksOver, AllLayouts, LayoutName);

TYPED_TEST(PartialPacksOver, change_objects_of_the_range_only_and_give_the_bits_of_whole_packs) {
  std::mt19937 random(seed());
  using Array = StressDerivativeArray<float, Host, TypeParam>;
  const auto kernel = [](const auto& from, const auto& to) {
    return over<float>([=](auto i) {
      using S = lanes_t<float, decltype(i)>;
      const S x = from[i].x1111();
      to[i].x2211() = sqrt(x) / S(3.0F);
      store_where(x > S(1.0F), to[i].x3311(), x);
    });
  };
  for (index_t n = 1; n <= 70; ++n) {
    Array from(n), whole(n), part(n);
    poison(from), poison(part);
    for (index_t i = 0; i < n; ++i) from.view()[i].x1111() = 0.5F + static_cast<float>(random() % 1000) / 300.0F;
    // Whole packs over a larger array whose first objects are the same.
    Array larger(128), larger_out(128);
    for (index_t i = 0; i < n; ++i) larger.view()[i].x1111() = from.view()[i].x1111();
    parallel_for(Host{}, 128, in_packs(kernel(larger.const_view(), larger_out.view())));
    const index_t begin = static_cast<index_t>(random()) % n;
    const index_t end = begin + 1 + static_cast<index_t>(random()) % (n - begin);
    std::vector<std::byte> before(static_cast<std::size_t>(part.bytes()));
    std::memcpy(before.data(), part.untyped().base, before.size());
    parallel_for(Host{}, begin, end, in_packs(kernel(from.const_view(), part.view())));
    for (index_t i = begin; i < end; ++i) {
      const float expected = larger_out.view()[i].x2211();
      ASSERT_EQ(part.view()[i].x2211(), expected) << "object " << i << " of " << begin << " to " << end;
      if (from.view()[i].x1111() > 1.0F) {
        ASSERT_EQ(part.view()[i].x3311(), from.view()[i].x1111());
      }
    }
    // With the elements of the range put back, every byte is as it was.
    const auto restored = part.view();
    Array old(n);
    std::memcpy(old.untyped().base, before.data(), before.size());
    for (index_t i = begin; i < end; ++i) {
      restored[i].x2211() = old.const_view()[i].x2211();
      restored[i].x3311() = old.const_view()[i].x3311();
    }
    ASSERT_EQ(std::memcmp(part.untyped().base, before.data(), before.size()), 0)
        << begin << " to " << end << " of " << n;
  }
}

/// Before, lanes outside the range, which name an object inside, wrote over it what they had made of nothing.
TEST(PartialPacks, store_through_gathered_indices_for_the_objects_of_the_range_only) {
  for (const index_t n : {1, 5, 13, 16, 27}) {
    EdgeArray<float> edges(n);
    StressDerivativeArray<float> out(n);
    for (index_t e = 0; e < n; ++e) edges.view()[e].nodes()[0] = static_cast<std::int32_t>(n - 1 - e);
    const auto from = edges.const_view();
    const auto to = out.view();
    parallel_for(Host{}, n, over<float>([=](auto i) {
                   using namespace math;
                   using S = lanes_t<float, decltype(i)>;
                   const auto ends = from[i].nodes();
                   const lanes_t<std::int32_t, decltype(i)> j = ends[0];
                   to[j].x1111() = select(wanted<float>(i), S(5.0F), S(-1.0F));
                   store_where(wanted<float>(i) || S(0.0F) < S(1.0F), to[j].x2211(),
                               select(wanted<float>(i), S(7.0F), S(-1.0F)));
                 }));
    for (index_t e = 0; e < n; ++e) {
      ASSERT_EQ(out.view()[e].x1111(), 5.0F) << e << " of " << n;
      ASSERT_EQ(out.view()[e].x2211(), 7.0F) << e << " of " << n;
    }
  }
}

TEST(ParallelFor, refuses_ranges_that_begin_before_the_first_object) {
  EXPECT_NE(message_of([] { parallel_for(Host{}, -3, 10, over<float>([](auto) {})); }).find("-3"), std::string::npos);
}

TEST(Numbers, are_those_of_the_objects_and_refuse_what_is_no_32_bit_number) {
  std::vector<std::int32_t> seen(50, -1);
  parallel_for(Host{}, 3, 43, over<float>([&](auto i) {
                 const auto number = numbers(i);
                 const auto own = wanted<std::int32_t>(i);
                 if constexpr (std::is_same_v<decltype(i), index_t>) {
                   seen[static_cast<std::size_t>(number)] = own ? number : -1;
                 } else {
                   for (std::size_t l = 0; l < decltype(number)::size; ++l) {
                     ASSERT_TRUE(number.get(l) >= 3 && number.get(l) < 43);
                     if (own.get(l)) seen[static_cast<std::size_t>(number.get(l))] = number.get(l);
                   }
                 }
               }));
  for (int n = 0; n < 50; ++n) EXPECT_EQ(seen[static_cast<std::size_t>(n)], n >= 3 && n < 43 ? n : -1);
  const index_t beyond = index_t{1} << 31;
  constexpr int W = native_lanes<float>;
  EXPECT_NO_THROW((void)numbers(Pack<W>{beyond - W}));
  EXPECT_NE(message_of([&] { (void)numbers(Pack<W>{beyond}); }).find("32-bit"), std::string::npos);
  EXPECT_NE(message_of([&] { (void)numbers(beyond); }).find("2147483648"), std::string::npos);
  EXPECT_NO_THROW((void)numbers(PartialPack<W>{beyond - W, 0, W - 1}));
}

/// Before, a kernel of doubles over objects with indices did not compile for processors without AVX2.
TEST(ParallelFor, takes_kernels_of_double_over_objects_with_indices) {
  EdgeArray<double> edges(21);
  StressDerivativeArray<double> out(21);
  for (index_t e = 0; e < 21; ++e) edges.view()[e].nodes()[1] = static_cast<std::int32_t>(e);
  const auto from = edges.const_view();
  const auto to = out.view();
  parallel_for(Host{}, 21, over<double>([=](auto i) {
                 using Node = lanes_t<std::int32_t, decltype(i)>;
                 const auto nodes = from[i].nodes();
                 const Node node = nodes[1];
                 to[i].x1111() = to[node].x1111() + 2.0;
               }));
  for (index_t e = 0; e < 21; ++e) ASSERT_EQ(out.view()[e].x1111(), 2.0);
}

template <class Real>
void check_neighbours_and_cells() {
  for (const index_t n : {1, 15, 16, 37}) {
    StressDerivativeArray<Real> in(n), out(n);
    for (index_t k = 0; k < n; ++k) in.view()[k].x1111() = Real(0.75) * static_cast<Real>(n - 1 - k);
    const auto from = in.const_view();
    const auto to = out.view();
    const auto last = static_cast<std::int32_t>(n - 1);
    parallel_for(Host{}, n, over<Real>([=](auto i) {
                   using namespace math;
                   const lanes_t<Real, decltype(i)> x = from[i].x1111();
                   to[i].x1111() = from[min(numbers(i) + 1, last)].x1111();
                   to[i].x2211() = from[to_index(floor(x))].x1111();
                 }));
    for (index_t k = 0; k < n; ++k) {
      const Real x = from[k].x1111();
      EXPECT_EQ(Real(to[k].x1111()), Real(from[std::min(k + 1, n - 1)].x1111())) << k << " of " << n;
      EXPECT_EQ(Real(to[k].x2211()), Real(from[static_cast<index_t>(std::floor(x))].x1111())) << k << " of " << n;
    }
  }
}

TEST(Packs, name_neighbours_by_numbers_and_cells_by_the_floor_of_a_position) {
  check_neighbours_and_cells<float>();
  check_neighbours_and_cells<double>();
}

template <class Real>
void check_exponentials_near_their_end(std::initializer_list<Real> arguments) {
  using S = batch_t<Real, native_lanes<Real>>;
  for (const Real x : arguments) {
    EXPECT_NEAR(exp(S(x)).get(0) / std::exp(x), 1, 4 * std::numeric_limits<Real>::epsilon()) << x;
    EXPECT_NEAR(expm1(S(x)).get(0) / std::expm1(x), 1, 4 * std::numeric_limits<Real>::epsilon()) << x;
  }
}

TEST(Functions, of_packs_have_exponentials_as_long_as_they_are_finite) {
  check_exponentials_near_their_end<float>({88.0F, 88.35F, 88.5F, 88.72F});
  check_exponentials_near_their_end<double>({709.0, 709.5, 709.78});
}

}  // namespace
}  // namespace physgen::test
