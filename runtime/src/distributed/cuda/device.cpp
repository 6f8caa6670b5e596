// The CUDA device of each rank.
#include <physgen/cuda/check.h>
#include <physgen/distributed/cuda/device.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

namespace physgen::cuda {

namespace {

/// What ranks tell each other: their machine, and the device that they take there.
struct Place {
  std::array<char, 256> host{};
  std::array<char, 16> device{};  ///< CUDA's name of it, which no two devices have
  int number = -1, count = 0;

  [[nodiscard]] bool is_beside(const Place& other) const { return host == other.host; }
  [[nodiscard]] bool shares_with(const Place& other) const { return is_beside(other) && device == other.device; }
};

std::vector<Place> places_of_all(const Place& mine, Transport& transport) {
  std::vector<Place> all(static_cast<std::size_t>(transport.count()));
  const std::vector<index_t> sizes(all.size(), index_t{sizeof(Place)});
  transport.gather(std::as_bytes(std::span(&mine, 1)), sizes, std::as_writable_bytes(std::span(all)));
  return all;
}

RankDevice choose(const Ranks& ranks, Transport& transport) {
  Place mine;
  std::strncpy(mine.host.data(), ranks.host().c_str(), mine.host.size() - 1);
  if (cudaGetDeviceCount(&mine.count) != cudaSuccess) {
    cudaGetLastError();
    mine.count = 0;
  }
  if (ranks.count() == 1) {
    if (mine.count == 0) throw Error("there is no CUDA device; run the program over arrays of the host");
    check(cudaGetDevice(&mine.number), "asking for the current device");
    return {mine.number, false};
  }
  const auto rank = static_cast<std::size_t>(ranks.rank());
  const std::vector<Place> hosts = places_of_all(mine, transport);
  for (std::size_t r = 0; r < hosts.size(); ++r) {
    if (hosts[r].count > 0) continue;
    throw Error(
        "rank " + std::to_string(r) + " on " + hosts[r].host.data() +
        " finds no CUDA device; start ranks on machines that have one, or run the program over arrays of the host");
  }
  int before = 0;  // ranks of this machine
  for (std::size_t r = 0; r < rank; ++r) before += hosts[r].is_beside(mine) ? 1 : 0;
  mine.number = before % mine.count;
  check(cudaSetDevice(mine.number), "taking a device");
  cudaDeviceProp properties{};
  check(cudaGetDeviceProperties(&properties, mine.number), "asking for the name of a device");
  static_assert(sizeof mine.device == sizeof properties.uuid);
  std::memcpy(mine.device.data(), &properties.uuid, sizeof mine.device);

  const std::vector<Place> all = places_of_all(mine, transport);
  const char* const shares = std::getenv("PHYSGEN_SHARE_GPU");
  const bool may_share = shares != nullptr && std::string(shares) == "1";
  for (std::size_t a = 0; a < all.size(); ++a) {
    for (std::size_t b = a + 1; b < all.size(); ++b) {
      if (!all[a].shares_with(all[b])) continue;
      if (may_share) return {mine.number, true};
      throw Error(
          "ranks " + std::to_string(a) + " and " + std::to_string(b) + " on " + all[a].host.data() +
          " would share a GPU, of which it has " + std::to_string(all[a].count) +
          "; start no more ranks on a machine than it has GPUs, or set PHYSGEN_SHARE_GPU=1, which is for tests: "
          "halos then cross through pinned memory and MPI");
    }
  }
  return {mine.number, false};
}

}  // namespace

RankDevice take_device(const Ranks& ranks, Transport& transport) {
  static std::optional<RankDevice> chosen;
  if (!chosen) chosen = choose(ranks, transport);
  return *chosen;
}

}  // namespace physgen::cuda
