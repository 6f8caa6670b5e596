// Each word is added to the state and mixed by the finalizer of SplitMix64, under which every bit of the one changes
// every bit of the other with a probability near one half. Source: Steele, Lea and Flood 2014.
#include <truthcube/output/hash.h>

#include <cstring>

namespace physgen::truthcube {

void Hash::add(std::uint64_t word) {
  std::uint64_t z = state_ + word + 0x9E3779B97F4A7C15U;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  state_ = z ^ (z >> 31U);
}

void Hash::add(std::span<const std::byte> bytes) {
  add(bytes.size());
  for (; bytes.size() >= sizeof(std::uint64_t); bytes = bytes.subspan(sizeof(std::uint64_t))) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data(), sizeof word);
    add(word);
  }
  if (!bytes.empty()) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data(), bytes.size());
    add(word);
  }
}

std::uint64_t mesh_hash(std::span<const fem::Point> rest, std::span<const std::array<fem::Index, 4>> tets) {
  Hash hash;
  hash.add(std::as_bytes(rest));
  hash.add(std::as_bytes(tets));
  return hash.value();
}

std::uint64_t groups_hash(std::span<const fem::MeshGroup> groups) {
  Hash hash;
  for (const fem::MeshGroup& group : groups) {
    hash.add(std::as_bytes(std::span(group.name)));
    hash.add(std::as_bytes(std::span(group.nodes)));
    hash.add(std::as_bytes(std::span(group.lines)));
    hash.add(std::as_bytes(std::span(group.faces)));
    hash.add(std::as_bytes(std::span(group.tets)));
  }
  return hash.value();
}

}  // namespace physgen::truthcube
