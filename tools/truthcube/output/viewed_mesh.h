// Points and cells as viewers see them: what a VTKHDF file and the XDMF file beside it have for all steps.
#pragma once

#include <fem/mesh/mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <tuple>
#include <vector>

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

/// "8 points and 5 tets", for messages.
[[nodiscard]] std::string in_words(std::uint64_t points, std::uint64_t cells, std::size_t corners_of_cell);
[[nodiscard]] std::string in_words(const ViewedMesh& mesh);

/// A number by which a file knows its mesh again; of tets without groups it is mesh_hash().
[[nodiscard]] std::uint64_t hash_of(const ViewedMesh& mesh);

}  // namespace physgen::truthcube
