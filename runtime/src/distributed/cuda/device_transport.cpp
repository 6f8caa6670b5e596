// Which transport devices have.
#include <physgen/distributed/cuda/device.h>
#include <physgen/distributed/cuda/transports.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

namespace physgen::cuda {

std::string reason_of_all(const std::string& mine, Transport& host) {
  std::array<char, 512> text{};
  std::strncpy(text.data(), mine.c_str(), text.size() - 1);
  std::vector<std::array<char, 512>> all(static_cast<std::size_t>(host.count()));
  const std::vector<index_t> sizes(all.size(), index_t{sizeof text});
  host.gather(std::as_bytes(std::span(text)), sizes, std::as_writable_bytes(std::span(all)));
  for (std::size_t r = 0; r < all.size(); ++r) {
    if (all[r][0] != '\0') return "rank " + std::to_string(r) + ": " + all[r].data();
  }
  return "";
}

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
