#include <physgen/distributed/local_set.h>
#include <physgen/error.h>

#include <algorithm>
#include <string>

namespace physgen {

LocalSet::LocalSet(Runs runs, int rank, std::vector<index_t> ghosts)
    : runs_(std::move(runs)), rank_(rank), ghosts_(std::move(ghosts)) {
  for (std::size_t g = 0; g < ghosts_.size(); ++g) {
    const index_t ghost = ghosts_[g];
    if (ghost < 0 || ghost >= runs_.size() || runs_.owns(rank_, ghost) || (g > 0 && ghost <= ghosts_[g - 1])) {
      throw Error("ghost " + std::to_string(g) + " of rank " + std::to_string(rank_) + " is object " +
                  std::to_string(ghost) + " of " + std::to_string(runs_.size()) +
                  "; list objects that other ranks own, in ascending order, each once");
    }
  }
  const index_t begin = runs_.begin(rank_);
  const auto below = static_cast<index_t>(std::lower_bound(ghosts_.begin(), ghosts_.end(), begin) - ghosts_.begin());
  begin_ = align_up(below, Runs::block);
  first_ = begin_ - below;
  size_ = std::max(last(), index_t{runs_.ranks() > 1 ? 1 : 0});
}

index_t LocalSet::global_of_ghost(index_t local) const {
  if (!is_ghost(local)) return -1;
  return ghosts_[ghost_number(local)];
}

index_t LocalSet::local_of_ghost(index_t global) const {
  const auto found = std::lower_bound(ghosts_.begin(), ghosts_.end(), global);
  if (found == ghosts_.end() || *found != global) return -1;
  return ghost(static_cast<std::size_t>(found - ghosts_.begin()));
}

}  // namespace physgen
