// The tet to look at in a state that no body can be in.
#pragma once

#include <fem/mesh/mesh.h>

#include <array>
#include <cstddef>
#include <string>

#include "body_state.h"
#include "output/window.h"
#include "scene.h"

namespace physgen::truthcube {

struct SuspectTet {
  fem::Index tet = 0;
  std::array<double, 9> F{};  ///< deformation gradient, by rows
  double J = 1;
  bool is_finite = true;    ///< whether its F and stress are
  fem::Index inverted = 0;  ///< tets of J <= 0, where all are finite
};

/// The first tet whose deformation gradient or stress is not finite; where all are, that of the smallest J.
/// All ranks call it; on those that get no numbers nothing is suspect. @param window bytes
[[nodiscard]] SuspectTet find_suspect(const fem::MeshLevel& level, BodyState& state, std::size_t window = window_bytes);

/// "tet 7 is deformed most: J 0.31, F = [...; ...; ...]", or what else is wrong with it. @param scene names its tets
[[nodiscard]] std::string describe(const SuspectTet& suspect, const Scene& scene);

}  // namespace physgen::truthcube
