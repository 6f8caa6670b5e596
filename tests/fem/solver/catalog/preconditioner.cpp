// Makes and applies the preconditioner that solver_catalog.py adds: of diagonal blocks it is the inverse.
#include <fem/solver/linear/performed_steps.h>
#include <fem/solver/preconditioners/make_linear_levels.h>
#include <fem/solver/solvers/all_arrays.h>
#include <physgen/executor.h>

#include <cmath>
#include <cstdio>

namespace fem = physgen::fem;

int main() {
  const fem::PreconditionerRow& row = fem::row_of(fem::Preconditioner::diagonal);
  std::printf("%s; without blocks of edges: %s\n", row.name, fem::preconditioners_without(fem::asks::edges).c_str());
  fem::SolverSettings settings;
  settings.nested = false;
  settings.newton.preconditioner.kind = fem::Preconditioner::diagonal;
  auto used = fem::levels_in_use(fem::make_cube_levels(2, 1, false), settings);
  const auto levels =
      fem::make_linear_levels<fem::LinearLevel<double, physgen::Host, fem::StoredAsComputed>>(used, settings);
  auto& level = *levels.front();
  for (physgen::index_t n = 0; n < level.nodes(); ++n) {
    level.node_stiffness.view()[n].K() =
        Eigen::Matrix3d(-Eigen::Vector3d(1, 2, 4 + double(n)).asDiagonal().toDenseMatrix());
    level.residual.view()[n].df() = Eigen::Vector3d(1, 2, 3);
  }
  physgen::HostExecutor on;
  fem::prepare(on, levels, 0, settings.newton.preconditioner, true);
  fem::precondition(on, levels, 0, settings.newton.preconditioner);
  on.wait();
  int wrong = levels.size() == 1 ? 0 : 1;
  for (physgen::index_t n = 0; n < level.nodes(); ++n) {
    const double s = level.scales.const_view()[n].scale();
    const Eigen::Vector3d z = level.correction.const_view()[n].dx().get() * (s * s);
    const Eigen::Vector3d expected(1, 1, 3 / (4 + double(n)));
    if (!((z - expected).norm() <= 1e-14)) ++wrong;
  }
  std::printf("%lld nodes, %d wrong\n", static_cast<long long>(level.nodes()), wrong);
  return wrong;
}
