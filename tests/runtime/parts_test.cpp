// Kernels that are called for the objects of a part, object_of_part(): in packs they mean the same objects as one by
// one.
#include <elasticity.physgen.h>
#include <gtest/gtest.h>
#include <physgen/kernel.h>
#include <physgen/parallel_for.h>

#include "test_objects.h"

namespace physgen::test {
namespace {

using elasticity::StressDerivativeArray;

TEST(Parts, are_read_in_packs_as_by_single_objects) {
  constexpr index_t first = 5;
  for (const index_t n : {6, 21, 40}) {
    StressDerivativeArray<float> in(n), out(n - first);
    for (index_t k = 0; k < n; ++k) in.view()[k].x1111() = static_cast<float>(k + 1);
    const auto from = in.const_view();
    const auto to = out.view();
    parallel_for(Host{}, n - first, over<float>([=](auto i) {
                   const auto own = object_of_part(first, i);
                   to[i].x1111() = from[own].x1111().get();
                   to[i].x2211() = from.get(own).x1111;
                 }));
    for (index_t k = 0; k < n - first; ++k) {
      EXPECT_EQ(to[k].x1111(), static_cast<float>(first + k + 1)) << k << " of " << n;
      EXPECT_EQ(to[k].x2211(), static_cast<float>(first + k + 1)) << k << " of " << n;
    }
  }
}

TEST(Parts, are_written_in_packs_and_nothing_beside_them) {
  constexpr index_t first = 5;
  for (const index_t n : {1, 16, 35}) {
    StressDerivativeArray<float> in(n), out(first + n + 20);
    for (index_t k = 0; k < n; ++k) in.view()[k].x1111() = static_cast<float>(k + 1);
    for (index_t k = 0; k < out.size(); ++k) out.view()[k].x1111() = out.view()[k].x2211() = -7;
    const auto from = in.const_view();
    const auto to = out.view();
    parallel_for(Host{}, n, over<float>([=](auto i) {
                   const auto own = object_of_part(first, i);
                   to[own].x1111() = from[i].x1111().get();
                   add(i, to[own].x2211(), from[i].x1111().get());
                 }));
    for (index_t k = 0; k < out.size(); ++k) {
      const bool is_of_part = k >= first && k < first + n;
      const auto number = static_cast<float>(k - first + 1);
      EXPECT_EQ(to[k].x1111(), is_of_part ? number : -7) << k << " of " << n;
      EXPECT_EQ(to[k].x2211(), is_of_part ? number - 7 : -7) << k << " of " << n;
    }
  }
}

TEST(Parts, that_end_beyond_32_bit_numbers_are_refused_in_packs) {
  constexpr index_t beyond = index_t{1} << 31;
  constexpr int W = native_lanes<float>;
  EXPECT_NO_THROW((void)object_of_part(beyond - 2 * W, Pack<W>{W}));
  EXPECT_NO_THROW((void)object_of_part(beyond - W + 1, PartialPack<W>{0, 0, W - 1}));
  EXPECT_NE(message_of([&] { (void)object_of_part(beyond - W + 1, Pack<W>{0}); }).find("2147483648"),
            std::string::npos);
  EXPECT_NE(message_of([&] { (void)object_of_part(2 * beyond, Pack<W>{0}); }).find("32-bit"), std::string::npos);
  EXPECT_EQ(object_of_part(2 * beyond, index_t{3}), 2 * beyond + 3);
}

}  // namespace
}  // namespace physgen::test
