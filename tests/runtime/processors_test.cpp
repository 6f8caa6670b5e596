// How many processors a process may use, read from files as Linux writes them.
#include <gtest/gtest.h>
#include <physgen/launch/processors.h>
#include <processors.h>
#include <sched.h>

#include <fstream>
#include <map>
#include <string>

namespace physgen::test {
namespace {

using detail::processors_of_quota;

/// A folder with files of text, as the system's own would be.
class Processors : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "processors.XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    root = name;
  }
  void TearDown() override { std::filesystem::remove_all(root); }

  std::optional<int> quota(const std::map<std::string, std::string>& files) {
    for (const auto& [path, text] : files) {
      std::filesystem::create_directories((root / path).parent_path());
      std::ofstream(root / path) << text;
    }
    return processors_of_quota(root);
  }

  std::filesystem::path root;
};

TEST_F(Processors, a_quota_of_version_2_is_rounded_up) {
  EXPECT_EQ(quota({{"proc/self/cgroup", "0::/\n"}, {"sys/fs/cgroup/cpu.max", "150000 100000\n"}}), 2);
}

TEST_F(Processors, a_quota_of_less_than_one_processor_is_one) {
  EXPECT_EQ(quota({{"proc/self/cgroup", "0::/\n"}, {"sys/fs/cgroup/cpu.max", "5000 100000\n"}}), 1);
}

TEST_F(Processors, a_group_of_version_2_without_a_quota_allows_all) {
  EXPECT_EQ(quota({{"proc/self/cgroup", "0::/user\n"}, {"sys/fs/cgroup/user/cpu.max", "max 100000\n"}}), std::nullopt);
}

TEST_F(Processors, the_smallest_quota_of_the_groups_around_it_counts) {
  EXPECT_EQ(quota({{"proc/self/cgroup", "0::/outer/inner\n"},
                   {"sys/fs/cgroup/outer/cpu.max", "300000 100000\n"},
                   {"sys/fs/cgroup/outer/inner/cpu.max", "800000 100000\n"},
                   {"sys/fs/cgroup/other/cpu.max", "100000 100000\n"}}),
            3);
}

TEST_F(Processors, a_quota_of_version_1_is_read_where_its_controller_is_mounted) {
  EXPECT_EQ(quota({{"proc/self/cgroup", "5:memory:/m\n4:cpu,cpuacct:/job\n0::/\n"},
                   {"sys/fs/cgroup/cpu,cpuacct/job/cpu.cfs_quota_us", "400000\n"},
                   {"sys/fs/cgroup/cpu,cpuacct/job/cpu.cfs_period_us", "100000\n"}}),
            4);
}

TEST_F(Processors, a_quota_of_version_1_below_zero_is_none) {
  EXPECT_EQ(quota({{"proc/self/cgroup", "1:cpu:/\n"},
                   {"sys/fs/cgroup/cpu/cpu.cfs_quota_us", "-1\n"},
                   {"sys/fs/cgroup/cpu/cpu.cfs_period_us", "100000\n"}}),
            std::nullopt);
}

TEST_F(Processors, a_container_that_sees_the_outer_path_has_its_group_at_the_mount) {
  EXPECT_EQ(quota({{"proc/self/cgroup", "3:cpuacct,cpu:/docker/0123abc\n"},
                   {"sys/fs/cgroup/cpu/cpu.cfs_quota_us", "250000\n"},
                   {"sys/fs/cgroup/cpu/cpu.cfs_period_us", "100000\n"}}),
            3);
}

TEST_F(Processors, files_that_are_missing_or_no_numbers_are_no_quota) {
  EXPECT_EQ(processors_of_quota(root), std::nullopt);
  EXPECT_EQ(quota({{"proc/self/cgroup", "nothing\n0::/\n1:cpu:/\n"},
                   {"sys/fs/cgroup/cpu.max", "many 100000\n"},
                   {"sys/fs/cgroup/cpu/cpu.cfs_quota_us", "100000\n"}}),
            std::nullopt);
  EXPECT_EQ(quota({{"sys/fs/cgroup/cpu.max", "100000 0\n"}}), std::nullopt);
}

TEST_F(Processors, no_more_are_allowed_than_the_affinity_of_the_process_has) {
  cpu_set_t before, one;
  ASSERT_EQ(sched_getaffinity(0, sizeof before, &before), 0);
  EXPECT_EQ(detail::processors_of_affinity(), CPU_COUNT(&before));
  EXPECT_GE(allowed_processors(), 1);
  EXPECT_LE(allowed_processors(), CPU_COUNT(&before));
  CPU_ZERO(&one);
  for (int cpu = 0; CPU_COUNT(&one) == 0; ++cpu) {
    if (CPU_ISSET(cpu, &before)) CPU_SET(cpu, &one);
  }
  ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
  EXPECT_EQ(allowed_processors(), 1);
  EXPECT_EQ(sched_setaffinity(0, sizeof before, &before), 0);
}

}  // namespace
}  // namespace physgen::test
