#include <fem/dynamics/explicit.h>
#include <fem/dynamics/explicit_solvers.h>
#include <fem/solver/masses.h>
#include <fem/solver/solvers/require.h>
#include <physgen/error.h>

namespace physgen::fem {

double stable_time_step(const MeshLevel& level, const DynamicSettings& settings) {
  const LameParameters lame =
      lame_parameters(settings.solver.youngs_modulus, settings.solver.poissons_ratio, settings.solver.material.c_str());
  return stable_time_step(level.mesh, level.rest, lame, settings.density);
}

void require_explicit_solver(const MeshLevel& level, const Loading& loading, const DynamicSettings& settings) {
  if (level.mesh.tets.empty()) throw Error("a solver needs a mesh with at least one tet");
  require_rest(0, level);
  require_motion(settings);
  require_plain("the explicit solver", level, loading);
}

std::unique_ptr<DynamicSolver> make_explicit_solver(const MeshLevel& level, const Loading& loading,
                                                    const DynamicSettings& settings) {
  require_explicit_solver(level, loading, settings);
  if (settings.solver.device == Device::cpu) return make_host_explicit_solver(level, loading, settings);
#ifdef PHYSGEN_SOLVER_HAS_CUDA
  return make_cuda_explicit_solver(level, loading, settings);
#else
  refuse_cuda();
#endif
}

}  // namespace physgen::fem
