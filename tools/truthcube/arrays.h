// Whose arrays a run has: those of a scene, with the fields alone that its program needs, or those with all fields.
#pragma once

#include <fem/solver/settings.h>

#include <string>

#include "options.h"

namespace physgen::truthcube {

/// The name of a scene in schemas/scenes; "everything" for scenes that are choices of the solvers with all arrays, as
/// linear elasticity is where it asks for what linear_elastic has not.
[[nodiscard]] std::string arrays_of(SceneKind scene, const fem::SolverSettings& settings);

}  // namespace physgen::truthcube
