// Rotations that are stored as quaternions, of components in any format.
#include "format_checks.h"

namespace physgen::test {
namespace {

template <class Layout>
class QuaternionIn : public ::testing::Test {};
TYPED_TEST_SUITE(QuaternionIn, AllLayouts, LayoutName);

TYPED_TEST(QuaternionIn, gives_rotations_back) {
  check_rotations<Host, TypeParam, format::Native>(257, 1.2e-6);  // what format/quaternion.h states
  check_rotations<Host, TypeParam, format::Half<>>(257, 2e-3);
  check_rotations<Host, TypeParam, format::Snorm16<format::Interval{-1.0, 1.0}>>(257, 9e-5);
  check_rotations<Host, TypeParam, format::Bfloat16>(257, 1.6e-2);
}

TEST(Quaternion, of_a_new_rotation_is_the_identity) {
  Array<elasticity::DeformationSvdObject, float, Host, Soa, CompactSvd<format::Half<>>> array(3);
  EXPECT_EQ(array.view().get(2).U, Eigen::Matrix3f::Identity());
  EXPECT_EQ(array.getdata(1, 4), 1);
  EXPECT_NE(message_of([&] { array.putdata(1, 4, 2); }).find("stored as a quaternion"), std::string::npos);
}

}  // namespace
}  // namespace physgen::test
