// Which blocks of a mirror are newer on which side.
#include <physgen/error.h>
#include <physgen/mirror.h>

#include <algorithm>
#include <string>

namespace physgen::detail {

namespace {

std::size_t block_of(index_t i) { return static_cast<std::size_t>(i / mirror_block); }

// One past the last block that holds objects before `end`.
std::size_t blocks_up_to(index_t end) { return static_cast<std::size_t>((end + mirror_block - 1) / mirror_block); }

const char* name(Side side) { return side == Side::host ? "host" : "device"; }

}  // namespace

ChangedBlocks::ChangedBlocks(index_t size, std::string_view object)
    : size_(size), object_(object), blocks_(blocks_up_to(size), State::same) {}

void ChangedBlocks::mark(Side side, index_t begin, index_t end) {
  check_range(begin, end);
  if (begin == end) return;
  const Side other = side == Side::host ? Side::device : Side::host;
  for (std::size_t block = block_of(begin); block < blocks_up_to(end); ++block) {
    if (blocks_[block] != newer_on(other)) continue;
    const Range range = objects_of(block);
    throw Error(std::string(object_) + "[" + std::to_string(size_) + "]: block " + std::to_string(block) +
                " (objects " + std::to_string(range.begin) + " to " + std::to_string(range.end - 1) +
                ") was changed on the " + name(other) + " and cannot be changed on the " + name(side) +
                " as well; read_" + name(side) + "() first");
  }
  std::fill(blocks_.begin() + static_cast<std::ptrdiff_t>(block_of(begin)),
            blocks_.begin() + static_cast<std::ptrdiff_t>(blocks_up_to(end)), newer_on(side));
}

std::vector<ChangedBlocks::Range> ChangedBlocks::newer(Side side, index_t begin, index_t end) const {
  check_range(begin, end);
  std::vector<Range> ranges;
  if (begin == end) return ranges;
  for (std::size_t block = block_of(begin); block < blocks_up_to(end); ++block) {
    if (blocks_[block] != newer_on(side)) continue;
    const Range range = objects_of(block);
    if (!ranges.empty() && ranges.back().end == range.begin) {
      ranges.back().end = range.end;
    } else {
      ranges.push_back(range);
    }
  }
  return ranges;
}

void ChangedBlocks::settle(const Range& range) {
  for (std::size_t block = block_of(range.begin); block < blocks_up_to(range.end); ++block) {
    blocks_[block] = State::same;
  }
}

void ChangedBlocks::check_range(index_t begin, index_t end) const {
  if (begin < 0 || begin > end || end > size_) {
    throw Error(std::string(object_) + "[" + std::to_string(size_) + "]: there are no objects " +
                std::to_string(begin) + " up to " + std::to_string(end));
  }
}

ChangedBlocks::Range ChangedBlocks::objects_of(std::size_t block) const {
  const index_t begin = static_cast<index_t>(block) * mirror_block;
  return {begin, std::min(begin + mirror_block, size_)};
}

}  // namespace physgen::detail
