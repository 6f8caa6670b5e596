// The 343 beads inside the Truth Cube, whose displacements were measured: where they are, where a deformed mesh puts
// them, and the file beads.csv.
#pragma once

#include <fem/mesh/locate.h>
#include <fem/mesh/mesh.h>

#include <filesystem>
#include <span>
#include <vector>

namespace physgen::truthcube {

inline constexpr std::size_t bead_count = 343;

/// Rest positions (i, j, k) * 0.01 m for i, j, k = 1 .. 7, i outermost.
[[nodiscard]] std::vector<fem::Point> bead_positions();

/// The corners of the tets in which points are located, four for each.
[[nodiscard]] std::vector<fem::Index> corners_of(std::span<const fem::Location> locations, const fem::TetMesh& mesh);

/// Displacements [m] of located points: those of the nodes, interpolated linearly.
/// @param rest of the mesh's nodes [m] @param corners where corners_of() these points are, deformed [m]
/// @throws Error when there is not one rest position per node, or not one position per corner
[[nodiscard]] std::vector<fem::Point> interpolate_displacements(std::span<const fem::Location> locations,
                                                                const fem::TetMesh& mesh,
                                                                std::span<const fem::Point> rest,
                                                                std::span<const fem::Point> corners);

/// beads.csv: a header `compression,x,y,z,ux,uy,uz`, then 343 rows a step: rest positions and displacements in metres,
/// 17 significant digits, which give the same numbers when read.
class BeadFile {
 public:
  /// Creates the file with its header, in the place of an old one. @throws Error when it cannot be created
  explicit BeadFile(std::filesystem::path path);

  /// Continues a file after its first `steps` steps; what follows is removed. With 0 steps it is created anew.
  /// @throws Error when there is no such file, it has another header, or it has fewer steps
  [[nodiscard]] static BeadFile append_to(std::filesystem::path path, int steps);

  /// Appends the rows of one step. @param compression plate travel over side
  /// @throws Error when there are not 343 displacements [m] or writing fails; the rows before are then as they were
  void write_step(double compression, std::span<const fem::Point> displacements);

 private:
  struct Existing {};
  BeadFile(std::filesystem::path path, Existing /*tag*/) : path_(std::move(path)) {}
  std::filesystem::path path_;
};

}  // namespace physgen::truthcube
