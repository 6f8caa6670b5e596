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
  for (std::size_t g = 0; g < ghosts_.size(); ++g) {
    ghost_blocks_.resize(static_cast<std::size_t>((ghosts_[g] - ghosts_.front()) / ghost_block + 1),
                         static_cast<index_t>(g));
  }
  ghost_blocks_.push_back(static_cast<index_t>(ghosts_.size()));
}

index_t LocalSet::global_of_ghost(index_t local) const {
  if (!is_ghost(local)) return -1;
  return ghosts_[ghost_number(local)];
}

index_t LocalSet::local_of_ghost(index_t global) const {
  if (ghosts_.empty() || global < ghosts_.front() || global > ghosts_.back()) return -1;
  const auto block = static_cast<std::size_t>((global - ghosts_.front()) / ghost_block);
  const auto from = ghosts_.begin() + ghost_blocks_[block], to = ghosts_.begin() + ghost_blocks_[block + 1];
  if (from == to || global < *from) return -1;
  // Mostly ghosts follow each other.
  const index_t beyond = std::min(global - *from, static_cast<index_t>(to - from) - 1);
  const auto found = from[beyond] == global ? from + beyond : std::lower_bound(from, to, global);
  if (found == to || *found != global) return -1;
  return ghost(static_cast<std::size_t>(found - ghosts_.begin()));
}

}  // namespace physgen
