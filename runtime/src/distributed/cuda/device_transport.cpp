// Which transport devices have.
#include <physgen/distributed/cuda/device.h>
#include <physgen/distributed/cuda/transports.h>

#include <cstdio>
#include <utility>

namespace physgen::cuda {

DeviceTransport make_device_transport(const Ranks& ranks, Transport& host, Stream stream, bool uses_nccl) {
  const bool is_shared = take_device(ranks, host).is_shared;
  std::string why_not = !uses_nccl ? "the program asks for it" : is_shared ? "ranks share a GPU" : "";
  if (why_not.empty()) {
    if (std::unique_ptr<Transport> made = make_nccl_transport(host, stream, why_not)) {
      return {std::move(made), "NCCL " + nccl_version_text(find_nccl().version)};
    }
    static bool is_said = false;
    if (ranks.is_first() && !std::exchange(is_said, true)) {
      std::fprintf(stderr, "physgen: halos cross through pinned memory and MPI, without NCCL: %s\n", why_not.c_str());
    }
  }
  return {make_pinned_transport(host, stream), "pinned memory and MPI, since " + why_not};
}

}  // namespace physgen::cuda
