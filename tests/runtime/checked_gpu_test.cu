// Counts and refusals of a checked build on the device. This program is compiled with PHYSGEN_CHECKED.
#include <physgen/cuda/parallel_for.h>

#include <cstdio>
#include <cstdlib>

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
  EXPECT_EQ(losses.first_imprecise.object, 34);
  EXPECT_EQ(losses.first_imprecise.value, double{1e-7F});
  EXPECT_GT(losses.worst_relative_error(), 0x1p-11);
  EXPECT_EQ(losses.first.object, 33);
  EXPECT_EQ(losses.first.value, 70000);
  EXPECT_EQ(array.take_losses().falsified(), 0U) << "they were taken";
}

struct StoreInTurn {
  Derivatives::View derivatives;
  index_t step;
  PHYSGEN_FUNCTION void operator()(index_t k) const {
    const index_t i = k * step % derivatives.size();
    derivatives[i].x1111() = i >= 17 ? static_cast<float>(100000 + i) : 0.0F;
  }
};

/// Every thread of every warp has something to count, in orders of their own.
TEST_F(CheckedOnDevice, kernels_name_the_first_object_that_is_wrong_whichever_thread_comes_first) {
  Derivatives array(1000003);
  for (const index_t step : {1, 1000002, 7, 500001}) {
    parallel_for(Cuda{}, array.size(), StoreInTurn{array.view(), step});
    const Losses losses = array.take_losses();
    EXPECT_EQ(losses.out_of_range, 1000003U - 17U);
    EXPECT_EQ(losses.first.object, 17) << step;
    EXPECT_EQ(losses.first.value, 100017) << step;
  }
  elasticity::StressDerivativeArray<float, Cuda> wrong(300000);
  const Derivatives target(wrong.size());
  for (const index_t i : {299999, 77, 5000}) wrong.putdata(i, 0, 1e6 + static_cast<double>(i));
  const Losses copied = losses_of_copy(target.untyped(), wrong.untyped());
  EXPECT_EQ(copied.out_of_range, 3U);
  EXPECT_EQ(copied.first.object, 77);
  EXPECT_EQ(copied.first.value, 1000077);
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
  const std::string part = "the first is 1e+06 Pa in x1111 of object 250000";
  for (const std::string& message :
       {message_of([&] { copy(array, wrong); }), message_of([&] { copy(array, wrong_there); })}) {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  }
  EXPECT_EQ(array.getdata(3, 0), 5);
  EXPECT_EQ(array.getdata(250000, 0), 0);
}

struct ReadAnEntry {
  elasticity::TetStiffnessArray<float, Cuda>::ConstView blocks;
  elasticity::NodeForceArray<float, Cuda>::View out;
  int entry, element;
  PHYSGEN_FUNCTION void operator()(index_t i) const { out[i].f()[0] = blocks[i].k(entry)[element]; }
};

// In a process of its own, which the trap leaves without a device.
[[noreturn]] void read_an_entry(int entry, int element) {
  try {
    elasticity::TetStiffnessArray<float, Cuda> blocks(3);
    elasticity::NodeForceArray<float, Cuda> out(3);
    parallel_for(Cuda{}, 3, ReadAnEntry{blocks.const_view(), out.view(), entry, element});
    synchronize();
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    std::_Exit(3);
  }
  std::_Exit(0);
}

TEST_F(CheckedOnDevice, entries_and_elements_that_do_not_exist_stop_the_kernel) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(read_an_entry(3, 5), testing::ExitedWithCode(0), "");
  EXPECT_EXIT(read_an_entry(4, 0), testing::ExitedWithCode(3), "cudaError");
  EXPECT_EXIT(read_an_entry(0, 6), testing::ExitedWithCode(3), "cudaError");
}

}  // namespace
}  // namespace physgen::test
