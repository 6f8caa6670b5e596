// Values that a checked build refuses to gather into device memory. Compiled with PHYSGEN_CHECKED.
#include <physgen/gather.h>

#include "checked_formats.h"
#include "gpu_fixture.h"

namespace physgen::test {
namespace {

class CheckedGather : public GpuTest {};

TEST_F(CheckedGather, refuses_what_formats_cannot_hold_by_its_number_and_keeps_the_array) {
  Array<elasticity::StressDerivativeObject, float, Cuda, Aosoa<32>, Coarse> array(300000);  // more than a chunk
  array.putdata(3, 0, 5);
  const auto object_of = [](index_t i) noexcept {
    elasticity::StressDerivative<float> object = {};
    if (i == 250000) object.x1111 = 1e6F;
    return object;
  };
  const std::string message = message_of([&] { gather_by(array, array.size(), object_of); });
  EXPECT_NE(message.find("cannot hold 1 values"), std::string::npos) << message;
  EXPECT_NE(message.find("the first is 1e+06 Pa in x1111 of object 250000"), std::string::npos) << message;
  EXPECT_EQ(array.getdata(3, 0), 5);
  EXPECT_EQ(array.getdata(250000, 0), 0);
}

}  // namespace
}  // namespace physgen::test
