#include "fields.h"

#include <Eigen/Dense>
#include <cmath>

#include "deformation.h"

namespace physgen::truthcube {

Fields make_fields(const fem::TetMesh& mesh, std::span<const fem::Point> rest, std::span<const fem::Point> positions,
                   std::span<const std::array<double, 9>> stresses, Strain strain) {
  Fields fields;
  const auto nodes = static_cast<std::size_t>(mesh.nodes);
  fields.displacement.reserve(3 * nodes);
  fields.stress.reserve(6 * mesh.tets.size());
  fields.von_mises.reserve(mesh.tets.size());
  fields.volume_ratio.reserve(mesh.tets.size());
  for (std::size_t n = 0; n < nodes; ++n) {
    for (std::size_t k = 0; k < 3; ++k) fields.displacement.push_back(positions[n][k] - rest[n][k]);
  }
  std::vector<double> volume(nodes, 0.0);
  fields.pressure.assign(nodes, 0.0);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const Eigen::Matrix3d F = deformation_gradient(mesh.tets[t], rest, positions);
    const double J = F.determinant();
    Eigen::Matrix3d sigma = Eigen::Map<const Eigen::Matrix3d>(stresses[t].data());
    if (strain == Strain::finite) sigma = (sigma * F.transpose() / J).eval();
    fields.stress.insert(fields.stress.end(),
                         {sigma(0, 0), sigma(1, 1), sigma(2, 2), sigma(0, 1), sigma(1, 2), sigma(0, 2)});
    const double mean = sigma.trace() / 3;
    const Eigen::Matrix3d deviator = sigma - mean * Eigen::Matrix3d::Identity();
    fields.von_mises.push_back(std::sqrt(1.5) * deviator.norm());
    fields.volume_ratio.push_back(J);
    const double own = std::abs(edges_of(mesh.tets[t], strain == Strain::finite ? positions : rest).determinant());
    for (const fem::Index n : mesh.tets[t]) {
      fields.pressure[static_cast<std::size_t>(n)] -= own * mean;
      volume[static_cast<std::size_t>(n)] += own;
    }
  }
  for (std::size_t n = 0; n < nodes; ++n) {
    if (volume[n] > 0) fields.pressure[n] /= volume[n];
  }
  return fields;
}

}  // namespace physgen::truthcube
