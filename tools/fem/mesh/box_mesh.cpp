// Tets of a box, cell by cell; all lists by formula.
#include <fem/mesh/at.h>
#include <fem/mesh/box_lists.h>
#include <fem/mesh/mesh.h>
#include <fem/mesh/stages.h>
#include <physgen/detail/host_loop.h>
#include <physgen/error.h>

#include <limits>
#include <string>
#include <vector>

namespace physgen::fem {

namespace {

void write_box_tets(std::vector<std::array<Index, 4>>& tets, Index nx, Index ny, Index nz,
                    const MirroredFrom& mirrored) {
  InStage stage("tets of the box");
  std::array<std::array<std::array<Index, 4>, 6>, 8> cells{};
  for (unsigned mirror = 0; mirror < 8; ++mirror) cells[mirror] = detail::tets_of_cell(mirror);
  const auto node = [nx, ny](Index x, Index y, Index z) { return x + (nx + 1) * (y + (ny + 1) * z); };
  std::array<Index, 8> corners{};  // from the lowest one of a cell
  for (Index c = 0; c < 8; ++c) corners[at(c)] = node(c & 1, c >> 1 & 1, c >> 2);
  physgen::detail::for_each_index<64>(0, index_t{ny} * nz, [&](index_t row) {
    const auto y = static_cast<Index>(row % ny), z = static_cast<Index>(row / ny);
    std::array<Index, 4>* next = tets.data() + 6 * row * nx;
    for (Index x = 0; x < nx; ++x) {
      const unsigned mirror = (x >= mirrored.x ? 1U : 0U) | (y >= mirrored.y ? 2U : 0U) | (z >= mirrored.z ? 4U : 0U);
      const Index origin = node(x, y, z);
      for (const auto& tet : cells[mirror]) {
        for (std::size_t c = 0; c < 4; ++c) (*next)[c] = origin + corners[at(tet[c])];
        ++next;
      }
    }
  });
  stage.moves(tets);
}

}  // namespace

TetMesh make_box_mesh(Index nx, Index ny, Index nz, const MirroredFrom& mirrored) {
  if (nx < 1 || ny < 1 || nz < 1) {
    throw Error("box mesh: cells " + std::to_string(nx) + " x " + std::to_string(ny) + " x " + std::to_string(nz) +
                "; each count must be at least 1");
  }
  // In double first: the product of three 32-bit counts overflows 64 bits.
  if (36. * nx * ny * nz > std::numeric_limits<Index>::max()) {
    throw Error("box mesh: " + std::to_string(6. * nx * ny * nz) + " tets: their incidences do not fit a 32-bit index");
  }
  TetMesh mesh;
  mesh.nodes = (nx + 1) * (ny + 1) * (nz + 1);
  mesh.tets.resize(6 * at(nx) * at(ny) * at(nz));
  write_box_tets(mesh.tets, nx, ny, nz, mirrored);
  detail::write_box_lists(mesh, nx, ny, nz, mirrored);
  return mesh;
}

}  // namespace physgen::fem
