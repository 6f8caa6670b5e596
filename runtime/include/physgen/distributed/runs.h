// Which objects of a set each rank owns: a run of whole blocks of one global order, which does not depend on ranks.
#pragma once

#include <physgen/config.h>

#include <span>
#include <vector>

namespace physgen {

/// Rank r owns the objects begin(r) .. end(r)-1. Every run but that of the last objects has whole blocks of a reduction
/// (launch/reduce.h), so that the values of blocks, and what they add up to, are those of one process; but for those of
/// at(). Ranks may own nothing.
class Runs {
 public:
  static constexpr index_t block = 2048;  ///< objects of a block of reductions

  /// As many blocks for each rank, or one more.
  /// @throw Error when size is negative or there is no rank
  [[nodiscard]] static Runs of_blocks(index_t size, int ranks);
  /// Runs that begin at the block nearest to where the caller would have them begin: for sets whose objects lie where
  /// those of another set do.
  /// @param cuts of each rank, ascending; the first run begins with object 0 in any case
  [[nodiscard]] static Runs near(index_t size, std::span<const index_t> cuts);
  /// Runs that begin with these objects: of what no reduction goes by.
  /// @param cuts as above
  [[nodiscard]] static Runs at(index_t size, std::span<const index_t> cuts);

  [[nodiscard]] index_t size() const { return begins_.back(); }
  [[nodiscard]] int ranks() const { return static_cast<int>(begins_.size()) - 1; }
  [[nodiscard]] index_t begin(int rank) const { return begins_[static_cast<std::size_t>(rank)]; }
  [[nodiscard]] index_t end(int rank) const { return begins_[static_cast<std::size_t>(rank) + 1]; }
  [[nodiscard]] bool owns(int rank, index_t object) const { return begin(rank) <= object && object < end(rank); }
  /// @throw Error when there is no such object
  [[nodiscard]] int owner(index_t object) const;

 private:
  explicit Runs(std::vector<index_t> begins) : begins_(std::move(begins)) {}
  std::vector<index_t> begins_;  ///< of all ranks, and the number of objects
};

}  // namespace physgen
