// Tets of a box, cell by cell; all lists from cell to cell.
#include <fem/mesh/at.h>
#include <fem/mesh/box_lists.h>
#include <fem/mesh/mesh.h>
#include <fem/mesh/stages.h>
#include <physgen/detail/launch.h>
#include <physgen/error.h>

#include <atomic>
#include <limits>
#include <string>
#include <vector>

namespace physgen::fem {

namespace {

// The tets of a box, cell by cell.
class TetsOfBox {
 public:
  explicit TetsOfBox(const BoxCells& box) : box_(box) {
    for (unsigned mirror = 0; mirror < 8; ++mirror) cells_[mirror] = detail::tets_of_cell(mirror);
    for (Index c = 0; c < 8; ++c) corners_[at(c)] = node(c & 1, c >> 1 & 1, c >> 2);
  }
  [[nodiscard]] index_t rows() const { return index_t{box_.cells[1]} * box_.cells[2]; }
  [[nodiscard]] index_t tets_of_row() const { return index_t{6} * box_.cells[0]; }
  // Calls act(tet) for the tets of a row of cells along x.
  template <class Act>
  void each_of_row(index_t row, const Act& act) const {
    const auto y = static_cast<Index>(row % box_.cells[1]), z = static_cast<Index>(row / box_.cells[1]);
    const MirroredFrom& from = box_.mirrored;
    for (Index x = 0; x < box_.cells[0]; ++x) {
      const unsigned mirror = (x >= from.x ? 1U : 0U) | (y >= from.y ? 2U : 0U) | (z >= from.z ? 4U : 0U);
      const Index origin = node(x, y, z);
      for (const auto& corners : cells_[mirror]) {
        std::array<Index, 4> tet{};
        for (std::size_t c = 0; c < 4; ++c) tet[c] = origin + corners_[at(corners[c])];
        act(tet);
      }
    }
  }

 private:
  [[nodiscard]] Index node(Index x, Index y, Index z) const {
    return x + (box_.cells[0] + 1) * (y + (box_.cells[1] + 1) * z);
  }

  BoxCells box_;
  std::array<std::array<std::array<Index, 4>, 6>, 8> cells_{};
  std::array<Index, 8> corners_{};  // from the lowest one of a cell
};

void write_box_tets(TetMesh& mesh) {
  InStage stage("tets of the box");
  const TetsOfBox box(*mesh.box);
  physgen::detail::for_each_index<64>(0, box.rows(), [&](index_t row) {
    std::array<Index, 4>* next = mesh.tets.data() + row * box.tets_of_row();
    box.each_of_row(row, [&next](const std::array<Index, 4>& tet) { *next++ = tet; });
  });
  stage.moves(mesh.tets);
}

}  // namespace

bool detail::is_box_of(const BoxCells& box, Index nodes) {
  const auto& [nx, ny, nz] = box.cells;
  const MirroredFrom& from = box.mirrored;
  if (nx < 1 || ny < 1 || nz < 1 || from.x < 0 || from.y < 0 || from.z < 0) return false;
  const index_t layer = (index_t{nx} + 1) * (index_t{ny} + 1);
  return nodes % layer == 0 && nodes / layer == index_t{nz} + 1;  // no product of three, which may overflow
}

bool detail::has_tets_of_box(const TetMesh& mesh) {
  if (!mesh.box || !is_box_of(*mesh.box, mesh.nodes)) return false;
  const TetsOfBox box(*mesh.box);
  if (static_cast<index_t>(mesh.tets.size()) != box.rows() * box.tets_of_row()) return false;
  std::atomic<bool> has_all = true;
  physgen::detail::for_each_index<64>(0, box.rows(), [&](index_t row) {
    const std::array<Index, 4>* next = mesh.tets.data() + row * box.tets_of_row();
    bool is_same = true;
    box.each_of_row(row, [&](const std::array<Index, 4>& tet) {
      for (std::size_t c = 0; c < 4; ++c) is_same &= tet[c] == (*next)[c];
      ++next;
    });
    if (!is_same) has_all = false;
  });
  return has_all;
}

TetMesh detail::make_box_tets(const BoxCells& box) {
  const auto& [nx, ny, nz] = box.cells;
  if (nx < 1 || ny < 1 || nz < 1) {
    throw Error("box mesh: cells " + std::to_string(nx) + " x " + std::to_string(ny) + " x " + std::to_string(nz) +
                "; each count must be at least 1");
  }
  // In double first: the product of three 32-bit counts overflows 64 bits.
  if (36. * nx * ny * nz > std::numeric_limits<Index>::max()) {
    throw Error("box mesh: " + std::to_string(6. * nx * ny * nz) + " tets: their incidences do not fit a 32-bit index");
  }
  TetMesh mesh;
  mesh.box = box;
  mesh.nodes = (nx + 1) * (ny + 1) * (nz + 1);
  mesh.tets.resize(6 * at(nx) * at(ny) * at(nz));
  write_box_tets(mesh);
  return mesh;
}

TetMesh make_box_mesh(Index nx, Index ny, Index nz, const MirroredFrom& mirrored) {
  TetMesh mesh = detail::make_box_tets({{nx, ny, nz}, mirrored});
  detail::write_box_lists(mesh);
  return mesh;
}

}  // namespace physgen::fem
