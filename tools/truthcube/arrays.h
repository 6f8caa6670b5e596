// Whose arrays a run has: those of a scene, with the fields alone that its program needs.
#pragma once

#include <string>

#include "options.h"

namespace physgen::truthcube {

/// The row of a scene of equilibria that has a solver of its own; else null.
[[nodiscard]] const fem::SceneRow* equilibrium_row(SceneKind scene);

/// The name of a scene in tools/fem/solver/scenes: that of the run, or "everything" where --scene implicit-dynamics is
/// asked for what implicit_dynamics has not.
[[nodiscard]] std::string arrays_of(const Options& options);

}  // namespace physgen::truthcube
