// NCCL is found without a device, and a program without it says what is missing.
#include <gtest/gtest.h>
#include <physgen/distributed/cuda/nccl.h>

#include <cstdlib>
#include <iostream>

namespace physgen {
namespace {

TEST(Nccl, IsLoadedAndSaysItsVersion) {
  const cuda::NcclFound& found = cuda::find_nccl();
  if (!found.why_not.empty() && found.version == 0) GTEST_SKIP() << "NCCL is not here: " << found.why_not;
  std::cout << "NCCL " << cuda::nccl_version_text(found.version) << '\n';
  EXPECT_GE(found.version, 21300) << found.why_not;
  EXPECT_EQ(found.why_not, "");
}

// In a process of its own, since a library is looked for once.
TEST(NcclDeathTest, ThatIsHiddenIsNamed) {
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        setenv("PHYSGEN_NCCL", "/nowhere/libnccl.so.2", 1);
        const cuda::NcclFound& found = cuda::find_nccl();
        std::cerr << found.version << ": " << found.why_not << '\n';
        std::exit(0);
      },
      testing::ExitedWithCode(0), "0: .*/nowhere/libnccl.so.2.*");
}

TEST(Nccl, VersionsAreWrittenAsNcclDoes) {
  EXPECT_EQ(cuda::nccl_version_text(22809), "2.28.9");
  EXPECT_EQ(cuda::nccl_version_text(23012), "2.30.12");
}

}  // namespace
}  // namespace physgen
