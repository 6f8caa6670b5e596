#include "arrays.h"

#include <fem/solver/solvers/scene_solvers.h>

namespace physgen::truthcube {

namespace {

/// Whether the scene implicit_dynamics has what is asked for. A mesh of one's own may need a background grid.
bool has_implicit_dynamics(const Options& options) {
  const fem::SolverSettings& settings = options.solver;
  return settings.material == "stable-neo-hookean" && settings.precision == fem::TangentPrecision::float32 &&
         !fem::asks_for(settings.newton.preconditioner.kind, fem::asks::arrays) &&
         options.volume != VolumeTreatment::nodes && options.plates == Plates::held && options.is_cube();
}

}  // namespace

const fem::SceneRow* equilibrium_row(SceneKind scene) {
  const auto rows = fem::equilibrium_scenes();
  const int row = static_cast<int>(scene) - 1;  // the first kind is `everything`, and rows follow
  return row >= 0 && row < static_cast<int>(rows.size()) ? &rows[static_cast<std::size_t>(row)] : nullptr;
}

std::string arrays_of(const Options& options) {
  if (const fem::SceneRow* row = equilibrium_row(options.scene)) return row->name;
  switch (options.scene) {
    case SceneKind::explicit_dynamics:
      return "explicit_dynamics";
    case SceneKind::implicit_dynamics:
      return has_implicit_dynamics(options) ? "implicit_dynamics" : "everything";
    case SceneKind::linear_elastic:
      return options.solver.newton.product == fem::Product::assembled ? "linear_elastic_assembled" : "linear_elastic";
    default:
      return "everything";
  }
}

}  // namespace physgen::truthcube
