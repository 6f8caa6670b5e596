// See checksum.h. Sums are taken in lanes, which become registers of packs.
#include "checksum.h"

#include <algorithm>
#include <cstring>

namespace physgen::h5 {

namespace {

constexpr std::size_t lanes = 8, word = sizeof(std::uint32_t), group = lanes * word;

}  // namespace

Checksum::Checksum(std::span<const std::byte> bytes) {
  std::uint64_t first[lanes] = {}, second[lanes] = {};
  const std::size_t groups = bytes.size() / group;
  for (std::size_t g = 0; g < groups; ++g) {
    std::uint32_t in_lanes[lanes];
    std::memcpy(in_lanes, bytes.data() + g * group, group);
    for (std::size_t l = 0; l < lanes; ++l) {
      first[l] += in_lanes[l];
      second[l] += first[l];
    }
  }
  for (std::size_t l = 0; l < lanes; ++l) {  // the word of lane l in group g has the factor lanes * (groups - g) - l
    sums_[0] += first[l];
    sums_[1] += lanes * second[l] - l * first[l];
  }
  words_ = lanes * groups;
  for (std::size_t at = groups * group; at < bytes.size(); at += word) {
    std::uint32_t last = 0;
    std::memcpy(&last, bytes.data() + at, std::min(word, bytes.size() - at));
    sums_[0] += last;
    sums_[1] += sums_[0];
    ++words_;
  }
}

void Checksum::append(const Checksum& next) {
  sums_[1] += next.words_ * sums_[0] + next.sums_[1];
  sums_[0] += next.sums_[0];
  words_ += next.words_;
}

}  // namespace physgen::h5
