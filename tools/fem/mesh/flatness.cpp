#include <fem/mesh/at.h>
#include <fem/mesh/flatness.h>
#include <fem/mesh/geometry.h>
#include <fem/mesh/stages.h>
#include <physgen/detail/host_loop.h>

#include <algorithm>
#include <cmath>

namespace physgen::fem {

namespace {

double flatness_of(const std::array<Index, 4>& tet, std::span<const Point> rest) {
  double longest = 0;
  for (const auto& [a, b] : tet_edges) {
    const Point edge = difference(rest[at(tet[at(b)])], rest[at(tet[at(a)])]);
    longest = std::max(longest, dot(edge, edge));
  }
  return longest * std::sqrt(longest) / (3 * std::sqrt(3.) * std::abs(six_volumes(tet, rest)));
}

}  // namespace

double flatness(const TetMesh& mesh, std::span<const Point> rest) {
  if (mesh.tets.empty()) return 0;
  InStage stage("flatness of tets");
  HostList<double> of_tets(mesh.tets.size());
  physgen::detail::for_each_index<4>(0, static_cast<index_t>(of_tets.size()),
                                     [&](index_t t) { of_tets[at(t)] = flatness_of(mesh.tets[at(t)], rest); });
  const auto most = of_tets.begin() + static_cast<std::ptrdiff_t>((of_tets.size() - 1) * 99 / 100);
  std::nth_element(of_tets.begin(), most, of_tets.end());
  stage.moves(mesh.tets, rest, of_tets);
  return *most;
}

}  // namespace physgen::fem
