// cloth [FOLDER]: a sheet that hangs at two corners falls for half a second in implicit steps; FOLDER gets x.npy and
// the other fields of the nodes. Exit status 1 where the pinned corners have moved, conjugate gradients did not
// converge, or the sheet has gained energy.
#include <physgen/save_npy.h>

#include <algorithm>
#include <cstdio>

#include "cloth.h"
int main(int count, char** words) try {
  const sheet::Cloth start(24);
  sheet::Cloth cloth(24);
  int most = 0;
  for (int step = 0; step < 250; ++step) {
    cloth.compute_springs();
    most = std::max(most, cloth.solve_and_move());
  }
  double kinetic = 0, fallen = 0, moved = 0;
  for (physgen::index_t i = 0; i < cloth.nodes.size(); ++i) {
    const auto node = cloth.nodes[i].get(), from = start.nodes[i].get();
    kinetic += 0.5 * node.m * node.v.squaredNorm();
    fallen += node.m * sheet::gravity * (node.x[2] - from.x[2]);
    if (node.free == 0) moved = std::max(moved, (node.x - from.x).norm());
  }
  std::printf("nodes, springs          %10ld %ld\n", long(cloth.nodes.size()), long(cloth.springs.size()));
  std::printf("most iterations         %10d\nkinetic energy          %10.4f J\n", most, kinetic);
  std::printf("work of gravity         %10.4f J\npinned corners moved    %10.1e m\n", fallen, moved);
  if (count > 1) save_npy(cloth.nodes, words[1]);
  return moved == 0 && most < sheet::most_iterations && kinetic > 0 && kinetic <= fallen ? 0 : 1;
} catch (const std::exception& error) {
  return std::fprintf(stderr, "%s\n", error.what()), 1;
}
