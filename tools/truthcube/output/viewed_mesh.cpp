#include <truthcube/output/hash.h>
#include <truthcube/output/viewed_mesh.h>

namespace physgen::truthcube {

std::string in_words(std::uint64_t points, std::uint64_t cells, std::size_t corners_of_cell) {
  return std::to_string(points) + " points and " + std::to_string(cells) +
         (corners_of_cell == 4 ? " tets" : " triangles");
}
std::string in_words(const ViewedMesh& mesh) {
  return in_words(mesh.points.size(), mesh.cells(), mesh.corners_of_cell);
}

std::uint64_t hash_of(const ViewedMesh& mesh) {
  Hash hash;
  hash.add(std::as_bytes(mesh.points));
  hash.add(std::as_bytes(mesh.corners));
  if (mesh.corners_of_cell != 4) hash.add(mesh.corners_of_cell);
  for (const CellGroup& group : mesh.groups) {
    hash.add(std::as_bytes(std::span(group.name)));
    hash.add(std::as_bytes(std::span(group.is_in)));
  }
  return hash.value();
}

}  // namespace physgen::truthcube
