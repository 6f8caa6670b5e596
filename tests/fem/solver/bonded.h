// Irregular bodies between two plates, for tests of the Schwarz preconditioner.
#pragma once

#include "bodies.h"
#include "irregular.h"

namespace physgen::fem {

/// The base is bonded; on top the component along z is held.
inline std::vector<MeshLevel> bonded(const Tets& tets, bool patches = false) {
  double top = 0;
  for (const Point& x : tets.rest) top = std::max(top, x[2]);
  return make_levels(tets, 0, patches,
                     [=](const Point& x) -> std::uint8_t { return x[2] == 0 ? 7 : (x[2] == top ? 4 : 0); });
}

/// A box of jittered nodes in random order.
inline const std::vector<MeshLevel>& irregular() {
  static const std::vector<MeshLevel> levels =
      bonded(shuffled(irregular_box({5, 6, 7}, {0.05, 0.06, 0.08}, 0.2, 71), 73));
  return levels;
}

}  // namespace physgen::fem
