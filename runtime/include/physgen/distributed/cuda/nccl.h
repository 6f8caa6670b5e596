// NCCL, which is loaded when a program first needs it: programs start without it.
#pragma once

#include <string>

namespace physgen::cuda {

/// What was found of NCCL.
struct NcclFound {
  int version = 0;      ///< 22809 of 2.28.9
  std::string why_not;  ///< why it cannot be used; empty where it can
};

/// Loads libnccl.so.2, or the library that PHYSGEN_NCCL in the environment names, the first time. It must be
/// 2.13 or later, of the major version of the header that physgen was built with. It needs no device.
[[nodiscard]] const NcclFound& find_nccl();

/// "2.28.9"
[[nodiscard]] std::string nccl_version_text(int version);

}  // namespace physgen::cuda
