// cloth [PICTURE.svg]: a sheet that hangs at two corners falls for half a second in implicit steps. Exit status 1 where
// the pinned corners have moved, conjugate gradients did not converge, or the sheet has gained energy.
#include <algorithm>
#include <cstdio>

#include "cloth.h"

int main(int count, char** words) {
  constexpr int side = 24, steps = 250;
  const sheet::Setting setting = sheet::make_setting(side);
  sheet::Sheet cloth(setting);
  int most = 0;
  for (int step = 0; step < steps; ++step) {
    cloth.compute_springs();
    most = std::max(most, cloth.solve_and_move());
  }
  double kinetic = 0, fallen = 0, moved = 0;
  for (physgen::index_t i = 0; i < cloth.nodes.size(); ++i) {
    const auto node = cloth.nodes.view().get(i);
    const Eigen::Vector3d from(setting.positions[static_cast<std::size_t>(i)].data());
    kinetic += 0.5 * node.m * node.v.squaredNorm();
    fallen += node.m * -setting.gravity * (from[2] - node.x[2]);
    if (node.free == 0) moved = std::max(moved, (node.x - from).norm());
  }
  std::printf("nodes, springs          %10d %ld\n", side * side, static_cast<long>(cloth.springs.size()));
  std::printf("most iterations         %10d\n", most);
  std::printf("kinetic energy          %10.4f J\n", kinetic);
  std::printf("work of gravity         %10.4f J\n", fallen);
  std::printf("pinned corners moved    %10.1e m\n", moved);
  if (count > 1) {
    std::FILE* file = std::fopen(words[1], "w");
    if (file == nullptr)
      return std::fprintf(stderr, "cloth: %s cannot be written; name a file in a folder that exists\n", words[1]), 2;
    std::fprintf(
        file,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-20 -20 440 300\" fill=\"none\" stroke=\"#0072B2\">\n");
    for (int line = 0; line < 2 * side; ++line) {
      std::fprintf(file, "<polyline points=\"");
      for (int k = 0; k < side; ++k) {
        const int at = line < side ? k + side * line : line - side + side * k;
        const Eigen::Vector3d x = cloth.nodes[at].x();
        std::fprintf(file, "%.0f,%.0f ", 300 * x[0] + 100 * x[1], -220 * x[2] - 40 * x[1] + 40);
      }
      std::fprintf(file, "\"/>\n");
    }
    std::fprintf(file, "</svg>\n");
    std::fclose(file);
  }
  return moved == 0 && most < setting.most_iterations && kinetic > 0 && kinetic <= fallen ? 0 : 1;
}
