// How many processors a process may use: fewer than the machine has where it runs in a container or under taskset.
#pragma once

namespace physgen {

/// The processors that this process may keep busy at once: those of its affinity (`taskset`, cpusets), and no more than
/// the quota of processor time of its control groups (Linux's cgroups, version 2 or 1), rounded up. Threads beyond that
/// wait for each other. It is read anew at each call, which takes up to a tenth of a millisecond.
/// @return at least 1
[[nodiscard]] int allowed_processors();

}  // namespace physgen
