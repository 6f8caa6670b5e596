// Uses what physgen::fem compiles and what it generates: prints the nodes of a renumbered box, and whether its own
// array is checked, by reading behind the end of one.
#include <elasticity.physgen.h>
#include <fem/kernels/symmetric_product.h>
#include <fem/mesh/mesh.h>
#include <fem/mesh/renumber.h>

#include <cstdio>

int main() {
  const physgen::fem::TetMesh box = physgen::fem::make_box_mesh(2, 2, 2);
  const physgen::fem::TetMesh mesh = physgen::fem::renumbered(box, physgen::fem::renumber_for_locality(box));
  const physgen::fem::EdgeSums sums(mesh, physgen::SpaceKind::host, sizeof(float));
  elasticity::NodePositionArray<float> nodes(mesh.nodes);
  std::printf("%lld nodes, %lld edges\n", static_cast<long long>(nodes.size()), static_cast<long long>(sums.edges()));
  std::fflush(stdout);
  const auto position = nodes.view().get(nodes.size());  // not there, but padding is
  return position.x[0] == 0.0F ? 0 : 1;
}
