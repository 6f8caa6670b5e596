// What a checked build counts and refuses on the device. This program is compiled with PHYSGEN_CHECKED.
#include <physgen/cuda/parallel_for.h>

#include "checked_formats.h"
#include "gpu_fixture.h"

namespace physgen::test {
namespace {

class CheckedOnDevice : public GpuTest {};

using Derivatives = Array<elasticity::StressDerivativeObject, float, Cuda, Aosoa<32>, Coarse>;

struct StoreTooMuch {
  Derivatives::View derivatives;
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    derivatives[i].x1111() = i % 100 == 33 ? 70000.0F : i % 100 == 34 ? 1e-7F : 1.0F;
    derivatives[i].x2211() = i == 5000 ? std::numeric_limits<float>::quiet_NaN() : 0.25F;
  }
};

TEST_F(CheckedOnDevice, kernels_count_what_formats_cannot_hold) {
  Derivatives array(10000);
  parallel_for(Cuda{}, array.size(), StoreTooMuch{array.view()});
  array.resize(10001);
  const Losses losses = array.take_losses();
  EXPECT_EQ(losses.out_of_range, 100U);
  EXPECT_EQ(losses.not_a_number, 1U);
  EXPECT_EQ(losses.imprecise, 100U);
  EXPECT_EQ(losses.first_imprecise.object % 100, 34);
  EXPECT_GT(losses.worst_relative_error(), 0x1p-11);
  EXPECT_TRUE(losses.first.object % 100 == 33 || losses.first.object == 5000) << losses.first.object;
  EXPECT_EQ(array.take_losses().falsified(), 0U) << "they were taken";
}

struct StoreReflections {
  Array<elasticity::DeformationSvdObject, float, Cuda, Soa, QuaternionRotations>::View svds;
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    svds[i].U() = Eigen::Matrix3f(Eigen::Matrix3f::Identity() * (i == 77 ? -1.0F : 1.0F));
  }
};

TEST_F(CheckedOnDevice, kernels_count_matrices_that_are_no_rotations) {
  Array<elasticity::DeformationSvdObject, float, Cuda, Soa, QuaternionRotations> array(1000);
  parallel_for(Cuda{}, array.size(), StoreReflections{array.view()});
  const Losses losses = array.take_losses();
  EXPECT_EQ(losses.not_a_rotation, 1U);
  EXPECT_EQ(losses.first.object, 77);
}

TEST_F(CheckedOnDevice, copies_refuse_what_formats_cannot_hold_and_change_nothing) {
  Derivatives array(300000);
  array.putdata(3, 0, 5);
  elasticity::StressDerivativeArray<float> wrong(array.size());
  wrong.putdata(250000, 0, 1e6);
  elasticity::StressDerivativeArray<float, Cuda> wrong_there(array.size());
  copy(wrong_there, wrong);
  const std::string part = "the first is 1e+06 in x1111 of object 250000";
  for (const std::string& message :
       {message_of([&] { copy(array, wrong); }), message_of([&] { copy(array, wrong_there); })}) {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  }
  EXPECT_EQ(array.getdata(3, 0), 5);
  EXPECT_EQ(array.getdata(250000, 0), 0);
}

}  // namespace
}  // namespace physgen::test
