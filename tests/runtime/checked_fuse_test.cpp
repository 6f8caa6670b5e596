// Reports of a checked build on fused kernels. This program is compiled with PHYSGEN_CHECKED.
#include <elasticity.physgen.h>
#include <everything.physgen.h>
#include <gtest/gtest.h>
#include <physgen/fuse.h>
#include <physgen/kernel.h>
#include <physgen/kernels/math.h>
#include <physgen/parallel_for.h>

#include "test_objects.h"

namespace physgen::test {
namespace {

/// The numbers of a local before anything is written to it, lane by lane.
template <class Object, class Real, class Formats, class Read>
std::vector<double> numbers_at_first(const Read& read) {
  std::vector<double> found;
  const auto unwritten = local<Object, Real, Formats>();
  const auto look = over<Real>([&](auto i) {
    const auto value = read(unwritten[i]);
    if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(value)>>) {
      found.push_back(static_cast<double>(value));
    } else {
      for (std::size_t l = 0; l < value.size; ++l) found.push_back(static_cast<double>(value.get(l)));
    }
  });
  parallel_for(Host{}, padding_objects, fuse(locals(unwritten), look));
  parallel_for(Host{}, 3, lanes<1>(fuse(locals(unwritten), look)));
  return found;
}

TEST(CheckedFuse, begins_with_numbers_that_are_none) {
  const auto expect_nan = [](const std::vector<double>& found) {
    EXPECT_EQ(found.size(), padding_objects + 3);
    for (const double number : found) EXPECT_TRUE(std::isnan(number));
  };
  using Stored = tissue::model::FrameObject;
  expect_nan(numbers_at_first<elasticity::StressDerivativeObject, float, FormatsOfSpace>(
      [](const auto& x) { return x.x3223().get(); }));
  expect_nan(numbers_at_first<elasticity::StressDerivativeObject, double, FormatsOfSpace>(
      [](const auto& x) { return x.x1111().get(); }));
  expect_nan(
      numbers_at_first<Stored, float, FormatsOf<Stored, Cuda>>([](const auto& x) { return x.origin()[2].get(); }));
  expect_nan(numbers_at_first<Stored, float, FormatsOfSpace>([](const auto& x) { return x.weight().get(); }));
}

TEST(CheckedFuse, begins_with_indices_that_no_array_has) {
  for (const double number : numbers_at_first<elasticity::TetObject, float, FormatsOfSpace>(
           [](const auto& x) { return x.nodes()[3].get(); })) {
    EXPECT_EQ(number, std::numeric_limits<std::int32_t>::min());
  }
  elasticity::NodePositionArray<float> nodes(5);
  const auto view = nodes.view();
  const auto tets = local<elasticity::TetObject, float>();
  EXPECT_EQ(message_of([&] {
              parallel_for(Host{}, 5, fuse(locals(tets), over<float>([=](auto i) {
                                             const lanes_t<std::int32_t, decltype(i)> node = tets[i].nodes()[1];
                                             (void)view[node];
                                           })));
            }),
            "physgen: elasticity::NodePosition: object -2147483648 of an array of 5");
}

TEST(CheckedFuse, reports_objects_of_arrays_that_do_not_exist) {
  elasticity::NodeForceArray<float> forces(20);
  const auto view = forces.view();
  const auto local_force = local<elasticity::NodeForceObject, float>();
  const auto fused = fuse(locals(local_force), over<float>([=](auto i) { local_force[i].f().setZero(); }),
                          over<float>([=](auto i) { view[i].f() = local_force[i].f().get(); }));
  EXPECT_EQ(message_of([&] { parallel_for(Host{}, 19, 21, fused); }),
            "physgen: elasticity::NodeForce: object 20 of an array of 20");
  EXPECT_EQ(message_of([&] { parallel_for(Host{}, 19, 21, lanes<1>(fused)); }),
            "physgen: elasticity::NodeForce: object 20 of an array of 20");
  EXPECT_NO_THROW(parallel_for(Host{}, 3, 20, fused));
}

}  // namespace
}  // namespace physgen::test
