// The copy on the CPU.
#include "measure/host.h"

#include <omp.h>
#include <physgen/buffer.h>

#include <algorithm>
#include <cstring>
#include <memory>

namespace physgen::bench {

std::function<double()> HostDevice::copy(double bytes) {
  const auto half = static_cast<index_t>(bytes / 2);
  const auto from = std::make_shared<Buffer>(SpaceKind::host, half, "the source of the copy");
  const auto to = std::make_shared<Buffer>(SpaceKind::host, half, "the target of the copy");
  return [from, to] {
    return time([&] {
#pragma omp parallel
      {
        constexpr index_t page = 4096;
        const index_t piece = align_up(from->bytes() / omp_get_num_threads() + 1, page);
        const index_t begin = std::min(piece * omp_get_thread_num(), from->bytes());
        const index_t end = std::min(begin + piece, from->bytes());
        std::memcpy(to->data() + begin, from->data() + begin, static_cast<std::size_t>(end - begin));
      }
    });
  };
}

}  // namespace physgen::bench
