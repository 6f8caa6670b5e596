// The parts of allowed_processors(), for tests that bring folders of their own.
#pragma once

#include <filesystem>
#include <optional>

namespace physgen::detail {

/// @param root holds `proc/self/cgroup` and `sys/fs/cgroup`; "/" but in tests
/// @return processors that the smallest quota of the process's control groups, or of those around them, pays for,
/// rounded up; none where no group has one, or where its files are not those of Linux
[[nodiscard]] std::optional<int> processors_of_quota(const std::filesystem::path& root);

/// @return processors that the system lets the calling thread run on; at least 1
[[nodiscard]] int processors_of_affinity();

}  // namespace physgen::detail
