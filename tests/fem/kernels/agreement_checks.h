// How near another run comes to the file that the CPU's run in packs wrote. Instantiated by agreement_test.cpp (single
// numbers and narrower packs) and agreement_gpu_test.cu (CUDA). parallel_for is included by those files.
#pragma once

#include <gtest/gtest.h>

#include "agreement.h"

namespace physgen::fem {

template <class Case>
class Agreement : public testing::Test {
 protected:
  void SetUp() override {
    if (Case::Space::kind == SpaceKind::cuda && !cuda_available()) GTEST_SKIP() << "no CUDA device here";
  }
};
TYPED_TEST_SUITE_P(Agreement);

/// Everything is one source with every fused multiply-add spelt out, so results are the same bits, except where a
/// platform's estimate of a root enters: the SVD, the eigenvalues of the filters, and Mooney-Rivlin's cube root.
TYPED_TEST_P(Agreement, with_the_file_of_a_cpu_run_is_bit_for_bit_but_for_estimated_roots) {
  using Real = typename TypeParam::Real;
  const auto expected = agreement::results_of_a_cpu_run<Real>();
  const auto differences = agreement::compare<Real>(expected, agreement::run<TypeParam>(expected));
  agreement::print("compared with the CPU's packs", differences);
  ASSERT_GE(differences.size(), 20u);
  for (const auto& [name, difference] : differences) {
    EXPECT_GE(difference.objects, 1300u) << name;
    if (name == "svd" || name == "x clamped" || name == "x absolute") {
      EXPECT_LE(difference.worst, 16) << name;
    } else if (name.find("Mooney-Rivlin") != std::string::npos) {
      EXPECT_LE(difference.worst, 4) << name;
    } else {
      EXPECT_EQ(difference.differing, 0u) << name << ": " << difference.worst << " eps";
    }
  }
}

REGISTER_TYPED_TEST_SUITE_P(Agreement, with_the_file_of_a_cpu_run_is_bit_for_bit_but_for_estimated_roots);

}  // namespace physgen::fem
