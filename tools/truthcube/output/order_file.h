// order.h5: the order of a run's mesh, so that whoever goes on with the run numbers nodes and tets as it did.
#pragma once

#include <fem/mesh/renumber.h>

#include <cstdint>
#include <filesystem>

namespace physgen::truthcube {

/// New numbers of a user's mesh; none where the mesh keeps its own.
struct MeshOrder {
  std::uint64_t mesh_hash = 0;  ///< mesh_hash() of hash.h, of the mesh under its own numbers
  fem::Renumbering numbers;

  [[nodiscard]] bool is_own() const { return numbers.node_order.empty(); }
  /// Tells orders apart; 0 where the mesh keeps its own.
  [[nodiscard]] std::uint64_t digest() const;
  bool operator==(const MeshOrder&) const = default;
};

/// Writes the order in the place of an old one, which stays until the new one is complete on the disk.
/// @throws Error when the disk is too full, or writing fails; an old file is then as it was
void write_order(const std::filesystem::path& file, const MeshOrder& order);

/// Reads the order of this mesh.
/// @throws Error when there is no such file, it is none of an order, damaged, of another version or of another mesh
[[nodiscard]] MeshOrder read_order(const std::filesystem::path& file, std::uint64_t mesh_hash);

}  // namespace physgen::truthcube
