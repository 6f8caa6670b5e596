// Reductions on the CPU.
#include <physgen/executor.h>
#include <physgen/parallel_reduce.h>
#include <physgen/threads.h>

#include "reduce_checks.h"

namespace physgen::test {
namespace {

template <class L>
class HostReduce : public testing::Test {};
using ReducedLayouts = testing::Types<Aos, Soa, Aosoa<16>>;
TYPED_TEST_SUITE(HostReduce, ReducedLayouts, LayoutName);

TYPED_TEST(HostReduce, sums_have_the_bits_of_the_stated_order) {
  check_sums<Host, float, TypeParam>();
  check_sums<Host, double, TypeParam>();
}
TYPED_TEST(HostReduce, extrema_and_conditions_are_those_of_the_range) {
  check_extrema_and_conditions<Host, float, TypeParam>();
}
TYPED_TEST(HostReduce, folds_several_terms_in_one_pass_of_a_kernel_that_stores) {
  check_several_terms_and_stores<Host, float, TypeParam>();
}

TEST(Reduce, sums_more_blocks_than_strands_in_the_stated_order) { check_a_sum_of_many_blocks<Host>(); }
TEST(Reduce, gives_nan_where_a_term_is_one) {
  check_nan<Host, float>();
  check_nan<Host, double>();
}

// Packs of all widths that this CPU has, on 1, 2 and 3 threads.
template <class Real, int... kWidths>
void check_widths() {
  std::mt19937 random(seed());
  for (const index_t n : {70, 50021}) {
    Vectors<Real, Host, Soa> vectors(n, random);
    const auto view = vectors.array.view();
    const Product<decltype(view)> product{view};
    const auto values = vectors.values(double_of);
    for (const auto& [begin, end] : ranges_of(n, random)) {
      const double wanted = by_order(values, begin, end, 0.0, plus);
      for (const int threads : {1, 2, 3}) {
        set_threads(threads);
        const auto check = [&, b = begin, e = end]<int kWidth>(std::integral_constant<int, kWidth>) {
          if constexpr (kWidth == 1 || !std::is_void_v<typename xsimd::make_sized_batch<Real, kWidth>::type>) {
            expect_same(parallel_reduce(Host{}, b, e, lanes<kWidth>(product), Sum{}), wanted,
                        std::to_string(kWidth) + " lanes, " + std::to_string(threads) + " threads");
          }
        };
        (check(std::integral_constant<int, kWidths>()), ...);
      }
    }
  }
  set_threads(0);
}
TEST(Reduce, has_the_same_bits_for_all_threads_and_lanes) {
  check_widths<float, 1, 4, 8, 16>();
  check_widths<double, 1, 2, 4, 8>();
}

TEST(Reduce, short_forms_take_lambdas_ranges_and_integers) {
  const index_t n = 10007;
  const auto number = over<float>([](auto i) { return numbers(i); });
  EXPECT_EQ(sum(Host{}, n, number), n * (n - 1) / 2);
  EXPECT_EQ(sum(Host{}, 5, 9, number), 5 + 6 + 7 + 8);
  EXPECT_EQ(max(Host{}, 5, 9, number), 8);
  EXPECT_EQ(min(Host{}, 5, 9, number), 5);
  EXPECT_EQ(max(Host{}, 0, number), std::numeric_limits<std::int32_t>::lowest());
  EXPECT_EQ(argmax(Host{}, 100, n, over<float>([](auto i) { return numbers(i) / 1000; })).index, 10000);
  const auto is_even = over<float>([](auto i) { return numbers(i) / 2 * 2 == numbers(i); });
  EXPECT_EQ(count(Host{}, n, is_even), (n + 1) / 2);
  EXPECT_TRUE(any(Host{}, 4, 5, is_even));
  EXPECT_FALSE(all(Host{}, n, is_even));
  EXPECT_TRUE(all(Host{}, 0, is_even));
}

TEST(Reduce, part_by_part_has_the_bits_of_one_reduction_and_numbers_of_all_objects) {
  std::mt19937 random(seed());
  HostExecutor on;
  for (const index_t n : {0, 1, 2048, 5000, 50021}) {
    const Vectors<float, Host, Soa> vectors(n, random);
    const auto view = vectors.array.const_view();
    const Product<std::remove_const_t<decltype(view)>> product{view};
    const double sum_of_all = parallel_reduce(Host{}, n, product, Sum{});
    const auto first_of_all = parallel_reduce(Host{}, n, product, Argmax{});
    for (const index_t most : {2048, 3 * 2048, 1 << 16}) {
      int calls = 0;
      for (index_t first = 0; first == 0 || first < n; first += most) {
        const PartOfReduction part{first, std::min(most, n - first), n};
        const auto of_part = [&](auto i) { return product(numbers(i) + static_cast<std::int32_t>(first)); };
        on.reduce_part(part, over<float>(of_part), Sum{}, [&](double value) {
          ++calls;
          expect_same(value, sum_of_all, std::to_string(n) + " objects by " + std::to_string(most));
        });
      }
      EXPECT_EQ(calls, 1);
      for (index_t first = 0; first == 0 || first < n; first += most) {
        const auto of_part = [&](auto i) { return product(numbers(i) + static_cast<std::int32_t>(first)); };
        on.reduce_part({first, std::min(most, n - first), n}, over<float>(of_part), Argmax{},
                       [&](const auto& value) { EXPECT_EQ(value.index, first_of_all.index) << n << " objects"; });
      }
    }
  }
}
TEST(Reduce, refuses_parts_that_do_not_have_whole_blocks) {
  HostExecutor on;
  const auto one = over<float>([](auto i) { return numbers(i); });
  for (const PartOfReduction part : {PartOfReduction{1024, 2048, 8192}, {0, 1024, 8192}, {4096, 8192, 8192}}) {
    EXPECT_EQ(message_of([&] { on.reduce_part(part, one, Sum{}, [](index_t) {}); }),
              "physgen: a reduction of 8192 objects has a part from object " + std::to_string(part.first) +
                  " to before " + std::to_string(part.first + part.count) +
                  "; let parts begin and end at multiples of 2048, and the last at the end");
  }
}

/// A fold of one's own: the largest absolute value.
struct Largest {
  template <class Number>
  using Value = Number;
  template <class Number>
  static constexpr Number identity() {
    return 0;
  }
  template <class Number>
  static Number value(Number term, index_t /*i*/) {
    return std::abs(term);
  }
  template <class Number>
  static Number join(Number a, Number b) {
    return a > b ? a : b;
  }
};
TEST(Reduce, takes_a_fold_of_ones_own) {
  const auto kernel =
      over<double>([](auto i) { return math::to_real<lanes_t<double, decltype(i)>>(numbers(i) - 9000); });
  EXPECT_EQ(parallel_reduce(Host{}, 10007, kernel, Largest{}), 9000.0);
}

TEST(Reduce, passes_on_what_a_kernel_throws_after_all_other_calls) {
  std::vector<int> called(20000, 0);
  const auto kernel = [&](index_t i) {
    called[static_cast<std::size_t>(i)] = 1;
    if (i == 12345) throw Error("object 12345 is bad");
    return 1.0;
  };
  EXPECT_EQ(message_of([&] { parallel_reduce(Host{}, 20000, lanes<1>(kernel), Sum{}); }),
            "physgen: object 12345 is bad");
  EXPECT_EQ(std::count(called.begin(), called.end(), 1), 20000);
}

TEST(Reduce, a_workspace_says_what_it_needs) {
  EXPECT_THROW((void)ReduceWorkspace::bytes_for(-1, 8), Error);
  EXPECT_THROW((void)ReduceWorkspace::bytes_for(std::numeric_limits<index_t>::max(), index_t{1} << 60), Error);
  EXPECT_LE(ReduceWorkspace::bytes_for(index_t{1} << 40, 8), index_t{1} << 33);
}

}  // namespace
}  // namespace physgen::test
