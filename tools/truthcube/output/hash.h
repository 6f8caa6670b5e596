// A 64-bit hash of arrays, which tells meshes apart and finds damage in files. It is not made against forgery.
#pragma once

#include <fem/mesh/groups.h>
#include <fem/mesh/mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace physgen::truthcube {

/// Hashes what is added, in its order. The same on every machine of the same byte order, since hashes are stored.
class Hash {
 public:
  void add(std::uint64_t word);
  /// Adds the number of bytes, then the bytes.
  void add(std::span<const std::byte> bytes);
  [[nodiscard]] std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0;
};

/// The hash of a mesh: of the bits of its rest positions and of its tets, both in their order.
[[nodiscard]] std::uint64_t mesh_hash(std::span<const fem::Point> rest,
                                      std::span<const std::array<fem::Index, 4>> tets);
/// The hash of the groups of a mesh: of their names and members, in their order.
[[nodiscard]] std::uint64_t groups_hash(std::span<const fem::MeshGroup> groups);

}  // namespace physgen::truthcube
