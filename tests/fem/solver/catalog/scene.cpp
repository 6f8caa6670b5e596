// Chooses the scene that solver_catalog.py adds as the command line does, forecasts its bytes, and finds an
// equilibrium.
#include <fem/solver/solvers/scene_solvers.h>
#include <truthcube/arrays.h>
#include <truthcube/run_bytes.h>
#include <truthcube/scene_choice.h>

#include <algorithm>
#include <cstdio>

namespace fem = physgen::fem;
using namespace physgen::truthcube;

int main() {
  int wrong = 0;
  Options options;
  options.scene = SceneKind::quasistatic_neo_hookean;
  options.solver.youngs_modulus = 15e3;
  options.solver.poissons_ratio = 0.4;
  apply_scene(options, [](const std::string& /*flag*/) { return false; });
  if (name_of(scene_kinds, options.scene) != "neo-hookean" || options.solver.material != "neo-hookean") ++wrong;
  if (options.volume != VolumeTreatment::tets || options.notes.empty()) ++wrong;
  auto levels = fem::make_cube_levels(4, 0.08, false);
  for (fem::MeshLevel& level : levels) {
    for (std::size_t n = 0; n < level.rest.size(); ++n) {
      if (level.rest[n][2] == 0 || level.rest[n][2] == 0.08) level.fixed[n] = 7;
    }
  }
  fem::Loading loading{std::vector<fem::Point>(levels.front().rest.size(), fem::Point{}), {}};
  for (std::size_t n = 0; n < loading.motion.size(); ++n) {
    if (levels.front().rest[n][2] == 0.08) loading.motion[n][2] = -0.08;
  }
  const auto solver = fem::make_scene_solver(arrays_of(options), levels, loading, options.solver);
  const auto bytes = bytes_of_run(count_levels(levels), options.solver, {options.scene, arrays_of(options)}).solver;
  const fem::NewtonResult result = solver->solve_to(0.05, {});
  std::printf("%s: %lld bytes, %lld forecast; %d Newton steps, %d of conjugate gradients, residual %.2e\n",
              arrays_of(options).c_str(), static_cast<long long>(solver->bytes()), static_cast<long long>(bytes),
              result.steps, result.iterations, result.residual);
  if (bytes != solver->bytes() || result.status != fem::NewtonStatus::converged || result.steps == 0) ++wrong;
  return wrong;
}
