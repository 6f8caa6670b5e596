// Tests that need a CUDA device: skipped, visibly, on a machine without one.
#pragma once

#include <gtest/gtest.h>
#include <physgen/device.h>

namespace physgen::test {

class GpuTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!cuda_available()) GTEST_SKIP() << "no CUDA device on this machine";
  }
};

}  // namespace physgen::test
