// Writes a mesh of tets, or of triangles, and fields over time into one VTKHDF file, which ParaView opens from 5.12 on,
// and beside it an XDMF file, by which older ones open it (xdmf.h). Format: VTK's "VTKHDF format specification",
// version 2.0, type UnstructuredGrid, with the mesh stored once for all steps.
#pragma once

#include <truthcube/output/viewed_mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace physgen::h5 {
class File;
}

namespace physgen::truthcube {

/// What a field is called, and how many values it has for each point or cell.
struct FieldKind {
  std::string name;  ///< shown by viewers; neither empty nor with '/', '.', '|' or ':'
  int components;    ///< 1 or more
  auto operator<=>(const FieldKind&) const = default;
};

/// Values of one field at the points, or in the cells, of one step, or of some rows of it.
struct Field {
  std::string name;                ///< as above
  int components;                  ///< as above
  std::span<const double> values;  ///< `components` for each point or cell; stored in single precision
};

/// The file is open only while a step is written, and no lock is taken: viewers may read it at any time. Room on the
/// disk is taken before a step is written, and its data are in the file before the step counts: neither a full disk nor
/// a kill costs earlier steps. What is left of a step that was not finished is overwritten by the next. The XDMF file,
/// of the same name but for its end, `.xdmf`, is replaced when a step counts; a kill may leave it one step behind.
class VtkHdfWriter {
  // The fields of the points, or of the cells.
  struct Arrays {
    std::string what;                 // "Point", "Cell"
    std::uint64_t rows;               // points or cells
    std::vector<FieldKind> kinds;     // ascending
    std::vector<std::string> groups;  // stored once: kinds are those of steps
  };

 public:
  /// Creates a file with a mesh and no steps, in the place of an old one.
  /// @throws Error when the mesh has no points or no cells, a group has another number of cells or no usable name, an
  /// XDMF file of that name is not one of this file, the file cannot be created, or the disk is too full
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
  /// cannot write to the file any more. The steps before are then as they were; where the XDMF file alone cannot be
  /// written, this one counts, too.
  void write_step(double time, std::span<const Field> point_fields, std::span<const Field> cell_fields);

  /// A step whose values come some rows at a time, so that no memory is needed for all of them.
  class Step {
   public:
    Step(Step&&) noexcept;
    Step& operator=(Step&&) = delete;
    ~Step();  ///< of a step that has not ended nothing counts
    /// The next rows of the fields of points, or of cells: each field of begin_step(), in any order, with as many rows.
    /// The caller may change the values afterwards.
    /// @throws Error when the fields are others, or there are more rows than points or cells; and as write_step()
    void add_points(std::span<const Field> fields);
    void add_cells(std::span<const Field> fields);
    /// The step counts. It is the last call.
    /// @throws Error when rows are missing, and as write_step()
    void end();

   private:
    friend class VtkHdfWriter;
    Step(VtkHdfWriter& writer, double time);
    void make_datasets(const std::string& group);
    void add(const Arrays& arrays, std::uint64_t& done, std::span<const Field> fields);
    void end_without_xdmf();

    VtkHdfWriter* writer_;
    double time_;
    std::unique_ptr<h5::File> file_;
    std::uint64_t points_done_ = 0, cells_done_ = 0;
  };
  /// Begins to write a step of these fields. It ends before the next begins, and this writer stays where it is.
  /// @throws Error as write_step()
  [[nodiscard]] Step begin_step(double time, std::span<const FieldKind> of_points, std::span<const FieldKind> of_cells);

  /// How many steps are in the file.
  [[nodiscard]] int steps() const { return static_cast<int>(times_.size()); }

 private:
  struct Unopened {};
  VtkHdfWriter(Unopened, std::filesystem::path path, const ViewedMesh& mesh);
  static void copy_steps(const h5::File& file, VtkHdfWriter to, int steps);
  [[nodiscard]] static std::vector<FieldKind> kinds_in(const h5::File& file, const Arrays& arrays);
  [[nodiscard]] std::vector<FieldKind> checked_kinds(const Arrays& arrays, std::span<const FieldKind> kinds) const;
  void require_rows(const Arrays& arrays, std::span<const Field> fields, std::uint64_t rows) const;
  [[nodiscard]] std::uint64_t bytes_of_step() const;
  void write_xdmf() const;

  std::filesystem::path path_;
  std::size_t corners_of_cell_;
  Arrays points_{"Point", 0, {}, {}}, cells_{"Cell", 0, {}, {}};
  std::vector<double> times_;  // of all steps
};

}  // namespace physgen::truthcube
