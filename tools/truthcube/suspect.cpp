#include "suspect.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>
#include <vector>

#include "deformation.h"
#include "state_windows.h"

namespace physgen::truthcube {

SuspectTet find_suspect(const fem::MeshLevel& level, BodyState& state, std::size_t window) {
  SuspectTet suspect;
  struct Deformed {
    Eigen::Matrix3d F;
    double J;
    bool is_finite;
  };
  std::vector<Deformed> all;
  each_window(0, level.mesh.tets.size(), WindowSizes(window).tets(), [&](std::span<const fem::Index> tets) {
    all.resize(state.is_here() ? tets.size() : 0);
    each_tet(state, level.mesh, level.rest, tets, [&](std::size_t i, const TetState& tet) {
      const Eigen::Matrix3d F = deformation_gradient(tet);
      const bool is_finite =
          F.allFinite() && std::ranges::all_of(tet.stress, [](double p) { return std::isfinite(p); });
      all[i] = {F, F.determinant(), is_finite};
    });
    for (std::size_t i = 0; i < all.size() && suspect.is_finite; ++i) {
      const auto& [F, J, is_finite] = all[i];
      if (is_finite && J <= 0) ++suspect.inverted;
      if (is_finite && tets[i] > 0 && !(J < suspect.J)) continue;
      suspect.tet = tets[i];
      suspect.J = J;
      suspect.is_finite = is_finite;
      Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(suspect.F.data()) = F;
    }
  });
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
