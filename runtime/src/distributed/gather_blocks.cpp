#include <physgen/distributed/gather_blocks.h>

#include <algorithm>

namespace physgen {

std::vector<std::byte> gather_blocks(Transport& transport, const Runs& runs, std::span<const std::byte> mine,
                                     int entries, std::size_t value_bytes) {
  const auto bytes_of_entry = [&](index_t begin, index_t end) {
    return static_cast<std::size_t>((end - begin + Runs::block - 1) / Runs::block) * value_bytes;
  };
  const std::size_t all = bytes_of_entry(0, runs.size());
  std::vector<index_t> sizes;
  for (int r = 0; r < runs.ranks(); ++r) {
    sizes.push_back(static_cast<index_t>(bytes_of_entry(runs.begin(r), runs.end(r))) * entries);
  }
  std::vector<std::byte> gathered(all * static_cast<std::size_t>(entries)), ordered(gathered.size());
  transport.gather(mine, sizes, gathered);
  // Each rank gave its blocks entry by entry.
  const std::byte* from = gathered.data();
  std::size_t before = 0;
  for (int r = 0; r < runs.ranks(); ++r) {
    const std::size_t bytes = bytes_of_entry(runs.begin(r), runs.end(r));
    for (int k = 0; k < entries; ++k, from += bytes) {
      std::copy_n(from, bytes, ordered.data() + static_cast<std::size_t>(k) * all + before);
    }
    before += bytes;
  }
  return ordered;
}

}  // namespace physgen
