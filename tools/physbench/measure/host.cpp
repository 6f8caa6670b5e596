// The copy on the CPU.
#include "measure/host.h"

#include <physgen/detail/host_loop.h>
#include <physgen/memory/buffer.h>
#include <physgen/threads.h>

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
      // Pieces of many pages, as threads take them; one thread copies all at once.
      const index_t piece = threads() == 1 ? from->bytes() : index_t{1} << 20;
      physgen::detail::host_loop((from->bytes() + piece - 1) / piece, [&](index_t p) {
        const index_t begin = p * piece, end = std::min(begin + piece, from->bytes());
        std::memcpy(to->data() + begin, from->data() + begin, static_cast<std::size_t>(end - begin));
      });
    });
  };
}

}  // namespace physgen::bench
