// Random numbers: the published vectors of Philox4x32-10, the distributions, and that sequences are told apart.
#include <physgen/parallel_for.h>
#include <physgen/threads.h>

#include "random_checks.h"

namespace physgen::test {
namespace {

using Words = std::array<std::uint32_t, 4>;

TEST(RandomNumbers, are_the_published_ones_of_philox) {  // kat_vectors of Random123
  EXPECT_EQ(philox4x32({0, 0, 0, 0}, {0, 0}), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  constexpr std::uint32_t ones = 0xffffffff;
  EXPECT_EQ(philox4x32({ones, ones, ones, ones}, {ones, ones}),
            (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox4x32({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(RandomNumbers, take_the_counter_from_draw_use_and_object_and_the_key_from_the_seed) {
  RandomNumbers numbers(0x299f31d0a4093822, index_t{0x0370734413198a2e}, 0x85a308d3);
  for (std::uint32_t draw = 0; draw < 3; ++draw) {
    for (const std::uint32_t word : philox4x32({draw, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0})) {
      ASSERT_EQ(numbers.bits(), word) << draw;
    }
  }
}

TEST(RandomNumbers, of_float_are_the_upper_24_bits_and_of_double_the_upper_53_of_two_words) {
  RandomNumbers words(0, 0), floats(0, 0), doubles(0, 0);  // the words are those of zeros, above
  EXPECT_EQ(floats.uniform<float>(), static_cast<float>(0x6627e8) / 16777216.0F);
  EXPECT_EQ(floats.uniform<float>(), static_cast<float>(0xe169c5) / 16777216.0F);
  EXPECT_EQ(doubles.uniform<double>(), static_cast<double>(0x6627e8d5e169c58d >> 11) / 9007199254740992.0);
}

template <class Real>
void expect_moments() {
  double sum = 0, squares = 0, normal_sum = 0, normal_squares = 0;
  constexpr int count = 100000;
  for (int i = 0; i < count; ++i) {
    RandomNumbers numbers(7, i);
    const Real uniform = numbers.uniform<Real>(), normal = numbers.normal<Real>();
    ASSERT_TRUE(uniform >= 0 && uniform < 1) << i;
    sum += double{uniform};
    squares += double{uniform} * double{uniform};
    normal_sum += double{normal};
    normal_squares += double{normal} * double{normal};
  }
  // Five standard deviations of each mean.
  EXPECT_NEAR(sum / count, 0.5, 0.0046);
  EXPECT_NEAR(squares / count, 1.0 / 3, 0.0048);
  EXPECT_NEAR(normal_sum / count, 0, 0.016);
  EXPECT_NEAR(normal_squares / count, 1, 0.023);
}

TEST(RandomNumbers, have_the_moments_of_their_distributions) {
  expect_moments<float>();
  expect_moments<double>();
}

TEST(RandomNumbers, of_a_kernel_are_those_of_its_objects_on_any_number_of_threads) {
  const auto run = [](index_t begin, index_t end, const auto& kernel) {
    parallel_for(Host{}, begin, end, lanes<1>(kernel));
  };
  for (const int count : {1, 2, 16}) {
    set_threads(count);
    check_random_numbers<float, Host>(run);
    check_random_numbers<double, Host>(run);
  }
  set_threads(0);
}

}  // namespace
}  // namespace physgen::test
