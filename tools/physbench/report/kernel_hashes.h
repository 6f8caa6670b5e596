// The compiled kernels with which a row was measured, by hashes that the build makes of their objects
// (tools/report/kernel_hashes.py). A file that the build writes makes them known by a static variable.
#pragma once

#include <string>

namespace physgen::bench {

/// @param lines "KEY HASH" each: "scene/host/svd 0123456789abcdef", "storage/cuda 0123456789abcdef"
bool add_kernel_hashes(const std::string& lines);

/// The files whose kernels a row may have run, with their hashes: "storage/cuda 0123456789abcdef, ...". Empty: not
/// known.
/// @param row its name
[[nodiscard]] std::string kernels_of(const std::string& group, const std::string& row);

}  // namespace physgen::bench
