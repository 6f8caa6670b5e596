#include <physgen/distributed/runs.h>
#include <physgen/error.h>

#include <algorithm>
#include <string>

namespace physgen {

Runs Runs::of_blocks(index_t size, int ranks) {
  if (size < 0 || ranks < 1) {
    throw Error("runs of " + std::to_string(size) + " objects on " + std::to_string(ranks) +
                " ranks cannot exist; give a size that is not negative and one rank at least");
  }
  const index_t blocks = (size + block - 1) / block;
  std::vector<index_t> begins(static_cast<std::size_t>(ranks) + 1, size);
  for (int r = 0; r < ranks; ++r) begins[static_cast<std::size_t>(r)] = std::min(r * blocks / ranks * block, size);
  return Runs(std::move(begins));
}

Runs Runs::near(index_t size, std::span<const index_t> cuts) {
  std::vector<index_t> begins(cuts.size() + 1, size);
  index_t before = 0;
  for (std::size_t r = 0; r < cuts.size(); ++r) {
    const index_t nearest = (std::clamp(cuts[r], index_t{0}, size) + block / 2) / block * block;
    before = begins[r] = r == 0 ? 0 : std::clamp(nearest, before, size);
  }
  return Runs(std::move(begins));
}

Runs Runs::at(index_t size, std::span<const index_t> cuts) {
  std::vector<index_t> begins(cuts.size() + 1, size);
  index_t before = 0;
  for (std::size_t r = 0; r < cuts.size(); ++r) before = begins[r] = r == 0 ? 0 : std::clamp(cuts[r], before, size);
  return Runs(std::move(begins));
}

int Runs::owner(index_t object) const {
  if (object < 0 || object >= size()) {
    throw Error("object " + std::to_string(object) + " is none of a set of " + std::to_string(size()) +
                "; name one of 0 .. size-1");
  }
  return static_cast<int>(std::upper_bound(begins_.begin(), begins_.end(), object) - begins_.begin()) - 1;
}

}  // namespace physgen
