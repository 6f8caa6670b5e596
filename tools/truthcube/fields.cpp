#include "fields.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace physgen::truthcube {

namespace {

Eigen::Matrix3d edges_of(const std::array<fem::Index, 4>& tet, std::span<const fem::Point> x) {
  const auto at = [&](std::size_t c) {
    const fem::Point& p = x[static_cast<std::size_t>(tet[c])];
    return Eigen::Vector3d(p[0], p[1], p[2]);
  };
  Eigen::Matrix3d edges;
  for (int c = 0; c < 3; ++c) edges.col(c) = at(static_cast<std::size_t>(c) + 1) - at(0);
  return edges;
}

Eigen::Matrix3d deformation_gradient(const std::array<fem::Index, 4>& tet, std::span<const fem::Point> rest,
                                     std::span<const fem::Point> positions) {
  return edges_of(tet, positions) * edges_of(tet, rest).inverse();
}

}  // namespace

Fields make_fields(const fem::TetMesh& mesh, std::span<const fem::Point> rest, std::span<const fem::Point> positions,
                   std::span<const std::array<double, 9>> first_piola) {
  Fields fields;
  const auto nodes = static_cast<std::size_t>(mesh.nodes);
  for (std::size_t n = 0; n < nodes; ++n) {
    for (std::size_t k = 0; k < 3; ++k) fields.displacement.push_back(positions[n][k] - rest[n][k]);
  }
  std::vector<double> volume(nodes, 0.0);
  fields.pressure.assign(nodes, 0.0);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const Eigen::Matrix3d F = deformation_gradient(mesh.tets[t], rest, positions);
    const double J = F.determinant();
    const Eigen::Matrix3d P = Eigen::Map<const Eigen::Matrix3d>(first_piola[t].data());
    const Eigen::Matrix3d sigma = P * F.transpose() / J;
    fields.stress.insert(fields.stress.end(),
                         {sigma(0, 0), sigma(1, 1), sigma(2, 2), sigma(0, 1), sigma(1, 2), sigma(0, 2)});
    const double mean = sigma.trace() / 3;
    const Eigen::Matrix3d deviator = sigma - mean * Eigen::Matrix3d::Identity();
    fields.von_mises.push_back(std::sqrt(1.5) * deviator.norm());
    fields.volume_ratio.push_back(J);
    const double own = std::abs(edges_of(mesh.tets[t], positions).determinant());
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

SuspectTet find_suspect(const fem::TetMesh& mesh, std::span<const fem::Point> rest,
                        std::span<const fem::Point> positions, std::span<const std::array<double, 9>> first_piola) {
  SuspectTet suspect;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const Eigen::Matrix3d F = deformation_gradient(mesh.tets[t], rest, positions);
    const double J = F.determinant();
    const bool finite = F.allFinite() && std::ranges::all_of(first_piola[t], [](double p) { return std::isfinite(p); });
    if (finite && t > 0 && !(J < suspect.J)) continue;
    suspect.tet = static_cast<fem::Index>(t);
    suspect.J = J;
    suspect.is_finite = finite;
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(suspect.F.data()) = F;
    if (!finite) break;
  }
  return suspect;
}

}  // namespace physgen::truthcube
