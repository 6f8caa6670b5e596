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
