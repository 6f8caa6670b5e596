#include <fem/solver/assembled_stiffness.h>
#include <physgen/error.h>

#include <Eigen/Core>
#include <cmath>

namespace physgen::fem {

namespace {

using Matrix = Eigen::Map<const Eigen::Matrix3d>;
using Vector = Eigen::Map<const Eigen::Vector3d>;

void require_nodes(const char* what, std::size_t given, std::size_t nodes) {
  if (given != nodes) {
    throw Error(std::string(what) + " of " + std::to_string(given) + " nodes for a stiffness of " +
                std::to_string(nodes));
  }
}

}  // namespace

std::vector<Point> AssembledStiffness::product(std::span<const Point> dx) const {
  require_nodes("a vector", dx.size(), nodes.size());
  std::vector<Point> df(nodes.size());
  const auto at = [&df](std::size_t n) { return Eigen::Map<Eigen::Vector3d>(df[n].data()); };
  const auto vector = [&dx](std::size_t n) { return Vector(dx[n].data()); };
  for (std::size_t n = 0; n < nodes.size(); ++n) at(n) = Matrix(nodes[n].data()) * vector(n);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const Matrix E(edge_blocks[e].data());
    const auto m = static_cast<std::size_t>(edges[e][0]), n = static_cast<std::size_t>(edges[e][1]);
    at(m) += E * vector(n);
    at(n) += E.transpose() * vector(m);
  }
  return df;
}

double relative_residual(const AssembledStiffness& stiffness, std::span<const std::uint8_t> fixed,
                         std::span<const Point> f, std::span<const Point> dx) {
  require_nodes("prescribed components", fixed.size(), stiffness.nodes.size());
  require_nodes("a right-hand side", f.size(), stiffness.nodes.size());
  const std::vector<Point> Kdx = stiffness.product(dx);
  double left = 0, given = 0;
  for (std::size_t n = 0; n < fixed.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) {
      if ((fixed[n] >> k & 1) != 0) continue;
      const double r = f[n][k] + Kdx[n][k];
      left += r * r;
      given += f[n][k] * f[n][k];
    }
  }
  return left == 0 ? 0.0 : std::sqrt(left / given);
}

}  // namespace physgen::fem
