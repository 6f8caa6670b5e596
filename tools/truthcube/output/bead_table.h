// A user's table of measured bead displacements, and how far a simulation is from it.
#pragma once

#include <fem/mesh/locate.h>
#include <fem/mesh/mesh.h>

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace physgen::truthcube {

struct BeadRow {
  fem::Point rest, displacement;      ///< [m]
  std::optional<double> compression;  ///< plate travel over side; none where the table has no such column
  int line;                           ///< in the file, counted from 1
};

struct BeadTable {
  std::filesystem::path file;
  std::vector<BeadRow> rows;
};

/// Reads a CSV file. Its first line names the columns x, y, z, ux, uy, uz and, if there is one, compression, in any
/// order; beads.csv is such a file. Empty lines are skipped.
/// @throws Error naming the file and, where it is malformed, the line: a column missing, unknown or named twice, a row
/// of another length, a value that is not a finite number, a bead that has two rows at one compression; or no rows
[[nodiscard]] BeadTable read_bead_table(const std::filesystem::path& file);

/// Where the rows' rest positions lie in a mesh: one location per row.
/// @throws Error naming the file and the line of a bead outside the mesh
[[nodiscard]] std::vector<fem::Location> locate_beads(const BeadTable& table, std::span<const fem::Point> rest,
                                                      const fem::TetMesh& mesh);

/// Lengths of the differences between measured and computed displacements [mm].
struct BeadErrors {
  std::size_t beads;
  double mean, rms, p95, max;  ///< p95: the smallest that at least 95 % of the beads do not exceed
};

/// Compares the rows of one compression, within 1e-6, or all rows of a table without compressions.
/// @param computed displacements [m] at the rows' rest positions, one per row
/// @return nothing when the table has no row of this compression
/// @throws Error when there is not one displacement per row
[[nodiscard]] std::optional<BeadErrors> compare_beads(const BeadTable& table, double compression,
                                                      std::span<const fem::Point> computed);

}  // namespace physgen::truthcube
