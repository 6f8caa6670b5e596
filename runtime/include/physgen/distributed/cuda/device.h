// Which CUDA device a rank takes: one for each rank of a machine.
#pragma once

#include <physgen/distributed/ranks.h>
#include <physgen/distributed/transport.h>

namespace physgen::cuda {

/// The device of a rank.
struct RankDevice {
  int number;      ///< as CUDA counts the devices that this process sees
  bool is_shared;  ///< whether any two ranks take one device
};

/// Rank r of those on its machine takes device r modulo their number, which becomes the current device. cut() does so
/// before it gives arrays on a device their memory; what was allocated before lies on the device that was current then.
/// All ranks call it together the first time; later calls return what was decided then, and with one rank the device
/// that is current stays.
/// @throw Error when there is no device, or when ranks would share one without PHYSGEN_SHARE_GPU=1 in the environment
RankDevice take_device(const Ranks& ranks, Transport& transport);

}  // namespace physgen::cuda
