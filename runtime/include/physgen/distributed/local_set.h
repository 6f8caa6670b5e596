// The objects of a set that a rank has, and their local numbers: ghosts below, those that it owns, ghosts above.
#pragma once

#include <physgen/distributed/runs.h>

#include <span>
#include <vector>

namespace physgen {

/// Local numbers ascend with global ones, so rows, edges and blocks add in the order of one process:
///
///   0 .. first()-1           objects that stand for none; of kernels, only those over windows are called for them
///   first() .. begin()-1     ghosts: objects of ranks below
///   begin() .. end()-1       owned; begin() is a multiple of Runs::block, as the global number is
///   end() .. size()-1        ghosts: objects of ranks above
class LocalSet {
 public:
  /// @param ghosts global numbers of objects that others own, ascending
  /// @throw Error when they do not ascend, or one is owned or no object
  LocalSet(Runs runs, int rank, std::vector<index_t> ghosts);

  /// Objects that arrays have. With several ranks one at least, so that an array can be told by its memory.
  [[nodiscard]] index_t size() const { return size_; }
  [[nodiscard]] index_t first() const { return first_; }
  [[nodiscard]] index_t begin() const { return begin_; }
  [[nodiscard]] index_t end() const { return begin_ + owned(); }
  [[nodiscard]] index_t owned() const { return runs_.end(rank_) - runs_.begin(rank_); }
  /// Behind the last object that is there.
  [[nodiscard]] index_t last() const { return first_ + owned() + static_cast<index_t>(ghosts_.size()); }
  [[nodiscard]] const Runs& runs() const { return runs_; }
  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] std::span<const index_t> ghosts() const { return ghosts_; }

  /// @return -1 for an object that stands for none
  [[nodiscard]] index_t global(index_t local) const {
    return begin_ <= local && local < end() ? local - begin_ + runs_.begin(rank_) : global_of_ghost(local);
  }
  /// @return -1 for an object that is not here
  [[nodiscard]] index_t local(index_t global) const {
    return runs_.owns(rank_, global) ? global - runs_.begin(rank_) + begin_ : local_of_ghost(global);
  }
  /// The local number of ghost g.
  [[nodiscard]] index_t ghost(std::size_t g) const {
    const auto number = static_cast<index_t>(g);
    return number < begin_ - first_ ? first_ + number : number + first_ + owned();
  }
  [[nodiscard]] bool is_ghost(index_t local) const {
    return (first_ <= local && local < begin_) || (end() <= local && local < last());
  }
  /// Which ghost has a local number. @pre is_ghost()
  [[nodiscard]] std::size_t ghost_number(index_t local) const {
    return static_cast<std::size_t>(local - first_ - (local < begin_ ? 0 : owned()));
  }

 private:
  [[nodiscard]] index_t global_of_ghost(index_t local) const;
  [[nodiscard]] index_t local_of_ghost(index_t global) const;
  Runs runs_;
  int rank_;
  std::vector<index_t> ghosts_;
  /// Which ghost is the first from the number front() + k * ghost_block of them on; and one more.
  std::vector<index_t> ghost_blocks_;
  static constexpr index_t ghost_block = 256;
  index_t first_, begin_, size_;
};

}  // namespace physgen
