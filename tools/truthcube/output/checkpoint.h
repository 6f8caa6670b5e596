// The state after a step, from which a run continues bit for bit.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace physgen::truthcube {

/// The order of a mesh: the word behind --order, and MeshOrder::digest().
struct OrderMark {
  std::string name = "mesh";
  std::uint64_t digest = 0;
  bool operator==(const OrderMark&) const = default;
};

struct Checkpoint {
  std::string settings =
      "{}";  ///< a JSON object of what a run must not change when it continues: material, volume, ...
  std::uint64_t mesh_hash = 0;    ///< mesh_hash() of hash.h
  int step = 0;                   ///< how many steps are done
  double compression = 0;         ///< of the last of them: plate travel over side
  std::vector<double> positions;  ///< [m], x y z of each node
  std::vector<double> pressures;  ///< [Pa], where the volume treatment has any
  OrderMark order{};              ///< of the nodes
};

/// Takes the next coordinates of a checkpoint [m].
using TakePositions = std::function<void(std::span<const double>)>;

/// Writes a checkpoint in the place of an old one, which stays until the new one is complete on the disk.
/// @param head all but its positions @param count of coordinates
/// @param give give(take) calls take() with all coordinates in order, as many at a time as it likes
/// @throws Error when the settings are not a JSON object, there are more or fewer coordinates, the disk is too full
/// (the bytes needed and free are said), or writing fails; an old checkpoint is then as it was
void write_checkpoint(const std::filesystem::path& file, const Checkpoint& head, std::uint64_t count,
                      const std::function<void(const TakePositions&)>& give);

/// Reads a checkpoint for a run of these settings over this mesh in this order. Every double has the bits that were
/// written.
/// @throws Error when there is no such file, it is no checkpoint, damaged, of another version, of another order or of
/// another mesh, or its settings differ, with each key that does and both values
[[nodiscard]] Checkpoint read_checkpoint(const std::filesystem::path& file, const std::string& settings,
                                         std::uint64_t mesh_hash, const OrderMark& order = {});

/// For a run that goes on, before its mesh is read: nothing where there is no such file.
/// @throws Error when the checkpoint is of another order than that of this name, or damaged
void require_order(const std::filesystem::path& file, const std::string& name);

}  // namespace physgen::truthcube
