// Copies, appended objects and mirrors keep what a field's format keeps of a double, as kernels that store it do.
#include <physgen/mirror.h>
#include <physgen/topology.h>

#include "copy_precision_checks.h"

namespace physgen::test {
namespace {

TEST(CopyPrecision, copies_compute_in_the_wider_precision_of_the_two_arrays) {
  check_copies_between<Host, format::Native, format::Half<3>, FloatAround300, HalfAround300, Fine>(200);
}

// 300.00001 is 300 in float; halves near 1e-5 are 6e-8 apart.
constexpr double value = 300.00001, error = 3e-8;

template <class Format>
PositionsArray<double, Host, Aos, Format> one_position() {
  PositionsArray<double, Host, Aos, Format> one(1);
  one.view()[0].x() = Eigen::Vector3d(value, value, value);
  return one;
}

TEST(CopyPrecision, a_copy_stores_what_a_kernel_stores) {
  const auto from = one_position<FloatAround300>();
  PositionsArray<double, Host, Soa, HalfAround300> copied(1), stored(1);
  stored.view()[0].x() = from.const_view()[0].x().get();
  copy(copied, from);
  EXPECT_EQ(copied.getdata(0, 0), stored.getdata(0, 0));
  EXPECT_NEAR(copied.getdata(0, 0), value, error);
}

TEST(CopyPrecision, appended_objects_keep_it) {
  PositionsArray<double, Host, Soa, HalfAround300> to;
  append(to, one_position<FloatAround300>());
  EXPECT_NEAR(to.getdata(0, 2), value, error);
}

TEST(CopyPrecision, the_other_side_of_a_mirror_keeps_it) {
  using Positions = PositionsArray<double, Host, Aos, FloatAround300>;
  Mirror<Positions, PositionsArray<double, Host, Soa, HalfAround300>> mirror(one_position<FloatAround300>());
  EXPECT_NEAR(mirror.read_device()[0].x()[1], value, error);
}

}  // namespace
}  // namespace physgen::test
