// See checksum.h. Parts are summed on all threads, and within a part in lanes, which become registers of packs.
#include "checksum.h"

#include <physgen/config.h>
#include <physgen/detail/host_loop.h>

#include <algorithm>
#include <cstring>
#include <vector>

namespace physgen::h5 {

namespace {

constexpr std::size_t lanes = 8, word = sizeof(std::uint32_t), group = lanes * word;
using Sums = std::array<std::uint64_t, 2>;

// Adds n words that have these sums behind others.
void append(Sums& sums, const Sums& next, std::uint64_t n) {
  sums[1] += n * sums[0] + next[1];
  sums[0] += next[0];
}

Sums sums_of(std::span<const std::byte> bytes) {
  std::uint64_t first[lanes] = {}, second[lanes] = {};
  const std::size_t groups = bytes.size() / group;
  for (std::size_t g = 0; g < groups; ++g) {
    std::uint32_t words[lanes];
    std::memcpy(words, bytes.data() + g * group, group);
    for (std::size_t l = 0; l < lanes; ++l) {
      first[l] += words[l];
      second[l] += first[l];
    }
  }
  Sums sums{};
  for (std::size_t l = 0; l < lanes; ++l) {  // the word of lane l in group g has the factor lanes * (groups - g) - l
    sums[0] += first[l];
    sums[1] += lanes * second[l] - l * first[l];
  }
  for (std::size_t at = groups * group; at < bytes.size(); at += word) {
    std::uint32_t last = 0;
    std::memcpy(&last, bytes.data() + at, std::min(word, bytes.size() - at));
    append(sums, {last, last}, 1);
  }
  return sums;
}

}  // namespace

void Checksum::add(std::span<const std::byte> bytes) {
  constexpr std::size_t part = std::size_t{1} << 18U;
  const std::size_t parts = (bytes.size() + part - 1) / part;
  std::vector<Sums> sums(parts);
  const auto bytes_of = [&](std::size_t p) { return bytes.subspan(p * part, std::min(part, bytes.size() - p * part)); };
  detail::for_each_index<index_t{part / 64}>(0, static_cast<index_t>(parts), [&](index_t p) {
    const auto at = static_cast<std::size_t>(p);
    sums[at] = sums_of(bytes_of(at));
  });
  for (std::size_t p = 0; p < parts; ++p) append(sums_, sums[p], (bytes_of(p).size() + word - 1) / word);
}

}  // namespace physgen::h5
