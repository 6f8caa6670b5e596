// The hash of a mesh.
#include <gtest/gtest.h>
#include <truthcube/output/hash.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace physgen::truthcube {
namespace {

TEST(MeshHash, tells_meshes_apart) {
  const fem::TetMesh mesh = fem::make_box_mesh(2, 2, 2);
  std::vector<fem::Point> rest(static_cast<std::size_t>(mesh.nodes));
  for (std::size_t n = 0; n < rest.size(); ++n) rest[n] = {0.1 * static_cast<double>(n), 0, 1};
  const std::uint64_t original = mesh_hash(rest, mesh.tets);
  EXPECT_EQ(mesh_hash(std::vector(rest), std::vector(mesh.tets)), original);
  std::vector<std::uint64_t> hashes{original, mesh_hash(rest, {}), mesh_hash({}, mesh.tets), mesh_hash({}, {})};
  for (std::size_t n = 0; n < rest.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<fem::Point> moved = rest;
      moved[n][k] = std::nextafter(moved[n][k], 10);
      hashes.push_back(mesh_hash(moved, mesh.tets));
    }
  }
  for (std::size_t t = 0; t + 1 < mesh.tets.size(); ++t) {
    auto tets = mesh.tets;
    std::swap(tets[t], tets[t + 1]);
    hashes.push_back(mesh_hash(rest, tets));
    tets = mesh.tets;
    std::swap(tets[t][0], tets[t][1]);
    hashes.push_back(mesh_hash(rest, tets));
  }
  std::ranges::sort(hashes);
  EXPECT_EQ(std::ranges::adjacent_find(hashes), hashes.end());
}

}  // namespace
}  // namespace physgen::truthcube
