#include "suspect.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "deformation.h"

namespace physgen::truthcube {

SuspectTet find_suspect(const fem::TetMesh& mesh, std::span<const fem::Point> rest,
                        std::span<const fem::Point> positions, std::span<const std::array<double, 9>> stresses) {
  SuspectTet suspect;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const Eigen::Matrix3d F = deformation_gradient(mesh.tets[t], rest, positions);
    const double J = F.determinant();
    const bool finite = F.allFinite() && std::ranges::all_of(stresses[t], [](double p) { return std::isfinite(p); });
    if (finite && J <= 0) ++suspect.inverted;
    if (finite && t > 0 && !(J < suspect.J)) continue;
    suspect.tet = static_cast<fem::Index>(t);
    suspect.J = J;
    suspect.is_finite = finite;
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(suspect.F.data()) = F;
    if (!finite) break;
  }
  return suspect;
}

std::string describe(const SuspectTet& suspect, const Scene& scene) {
  std::string text = name_of_tet(scene, suspect.tet);
  if (!suspect.is_finite) {
    text += " has a stress that is not finite";
  } else if (suspect.inverted > 0) {
    text = std::to_string(suspect.inverted) +
           (suspect.inverted == 1 ? " tet is inverted, " : " tets are inverted, most of all ") + text;
  } else {
    text += " is deformed most";
  }
  const auto& F = suspect.F;
  std::array<char, 256> numbers{};
  std::snprintf(numbers.data(), numbers.size(), ": J %.4g, F = [%.6g %.6g %.6g; %.6g %.6g %.6g; %.6g %.6g %.6g]",
                suspect.J, F[0], F[1], F[2], F[3], F[4], F[5], F[6], F[7], F[8]);
  return text + numbers.data();
}

}  // namespace physgen::truthcube
