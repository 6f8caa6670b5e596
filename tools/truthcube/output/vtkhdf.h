// Writes a mesh of tets, or of triangles, and fields over time into one VTKHDF file, which ParaView opens. Format:
// VTK's "VTKHDF format specification", version 2.0, type UnstructuredGrid, with the mesh stored once for all steps.
#pragma once

#include <fem/mesh/mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace physgen::h5 {
class File;
}

namespace physgen::truthcube {

/// 1 in cells that belong to a group, 0 in others.
struct CellGroup {
  std::string name;  ///< as of fields
  std::vector<std::uint8_t> is_in;
};

/// Points in metres and cells of one kind, as viewers see them: tets, or the triangles of a surface.
struct ViewedMesh {
  std::span<const fem::Point> points;   ///< stored in double precision
  std::span<const fem::Index> corners;  ///< of all cells, behind each other
  std::size_t corners_of_cell;
  std::span<const CellGroup> groups;  ///< stored once, as fields of the cells

  ViewedMesh(std::span<const fem::Point> points_of_all, std::span<const std::array<fem::Index, 4>> tets,
             std::span<const CellGroup> groups_of_cells = {})
      : points(points_of_all), corners(flat(tets)), corners_of_cell(4), groups(groups_of_cells) {}
  ViewedMesh(std::span<const fem::Point> points_of_all, std::span<const std::array<fem::Index, 3>> triangles,
             std::span<const CellGroup> groups_of_cells = {})
      : points(points_of_all), corners(flat(triangles)), corners_of_cell(3), groups(groups_of_cells) {}

  [[nodiscard]] std::size_t cells() const { return corners.size() / corners_of_cell; }

 private:
  // Arrays have no gaps between them: flat, they are the same numbers.
  template <class Cell>
  static std::span<const fem::Index> flat(std::span<const Cell> cells) {
    return {cells.empty() ? nullptr : cells.front().data(), std::tuple_size_v<Cell> * cells.size()};
  }
};

/// Values of one field at the points, or in the cells, of one step.
struct Field {
  std::string name;                ///< shown by viewers; neither empty nor with '/' or '.'
  int components;                  ///< 1 or more
  std::span<const double> values;  ///< `components` for each point or cell; stored in single precision
};

/// The file is open only inside these functions, and no lock is taken: viewers may read it at any time. Room on the
/// disk is taken before a step is written, and its data are in the file before the step counts: neither a full disk nor
/// a kill costs earlier steps. What is left of a step that was not finished is overwritten by the next.
class VtkHdfWriter {
 public:
  /// Creates a file with a mesh and no steps, in the place of an old one.
  /// @throws Error when the mesh has no points or no cells, a group has another number of cells or no usable name, the
  /// file cannot be created, or the disk is too full
  VtkHdfWriter(std::filesystem::path path, const ViewedMesh& mesh);

  /// Continues a file after its first `steps` steps. Where it has more, a copy without them takes its place, for which
  /// the disk needs room. With 0 steps the file is created anew.
  /// @throws Error when there is no such file, it is of another mesh or damaged, it has fewer steps, or the disk is too
  /// full; the file is then as it was
  [[nodiscard]] static VtkHdfWriter append_to(std::filesystem::path path, const ViewedMesh& mesh, int steps);

  /// Appends a step. The first step decides which fields the file has, in any order.
  /// @param time what viewers show as time; it should grow from step to step
  /// @throws Error when a later step has other fields, a field has a wrong name or number of values, the disk is too
  /// full (the bytes needed and free are said; there may be room later), or writing fails, after which this process
  /// cannot write to the file any more. The steps before are then as they were.
  void write_step(double time, std::span<const Field> point_fields, std::span<const Field> cell_fields);

  /// How many steps are in the file.
  [[nodiscard]] int steps() const { return steps_; }

 private:
  // The fields of the points, or of the cells.
  struct Arrays {
    struct Kind {
      std::string name;
      int components;
      auto operator<=>(const Kind&) const = default;
    };
    std::string what;                 // "Point", "Cell"
    std::uint64_t rows;               // points or cells
    std::vector<Kind> kinds;          // ascending
    std::vector<std::string> groups;  // stored once: kinds are those of steps
  };

  struct Unopened {};
  VtkHdfWriter(Unopened, std::filesystem::path path, const ViewedMesh& mesh);
  static void copy_steps(const h5::File& file, VtkHdfWriter to, int steps);
  [[nodiscard]] static std::vector<Arrays::Kind> kinds_in(const h5::File& file, const Arrays& arrays);
  [[nodiscard]] std::vector<Arrays::Kind> checked_kinds(const Arrays& arrays, std::span<const Field> fields) const;
  [[nodiscard]] std::uint64_t bytes_of_step() const;

  std::filesystem::path path_;
  Arrays points_{"Point", 0, {}, {}}, cells_{"Cell", 0, {}, {}};
  int steps_ = 0;
};

}  // namespace physgen::truthcube
