// One V-cycle of multigrid, as a program over an executor: over the levels' arrays, or on CUDA within one kernel over
// their views (small_levels_cuda.h).
#pragma once

#include <fem/kernels/symmetric_product.h>
#include <fem/solver/performs_in.h>
#include <fem/solver/preconditioners/multigrid/coarse_inverse.h>
#include <fem/solver/preconditioners/multigrid/smoother.h>
#include <fem/solver/preconditioners/multigrid/transfer.h>
#include <fem/solver/settings.h>

#include <cstddef>

// Before a program that executors on the host and on the device run: of what it calls, each of them compiles its own.
#if defined(__CUDACC__)
#define PHYSGEN_PROGRAM _Pragma("nv_exec_check_disable")
#else
#define PHYSGEN_PROGRAM
#endif

namespace physgen::fem {

/// The product of a level's scaled stiffness, over edges in the mesh's order.
template <class Level, class DisplacementView, class DifferentialView>
[[nodiscard]] auto scaled_product(const Level& level, const DisplacementView& x, const DifferentialView& y) {
  return SymmetricProduct{level.scaled_nodes.const_view(), level.scaled_edges.const_view(), level.edges.const_view(), x,
                          y};
}

/// The product of a level's scaled stiffness with its direction d, whose nodes' part r has: r += K d.
template <class On, class Level>
void add_scaled_edges(On& on, Level& level) {
  add_edges(on, scaled_product(level, level.direction.const_view(), level.residual.view()), level.sums);
}

/// Chebyshev steps on a level: z grows by a polynomial of -D K times D r.
/// @param residual_after whether r is wanted after the last step
PHYSGEN_PROGRAM
template <class On, class Level>
PHYSGEN_FUNCTION void smooth(On& on, Level& level, int degree, double low, bool grows, bool residual_after) {
  const index_t n = level.nodes();
  const auto stiffness = level.scaled_nodes.const_view();
  const auto inverse = level.inverse.const_view();
  const auto smoother = level.smoother.const_view();
  const auto residual = level.residual.view();
  const auto direction = level.direction.view();
  const auto correction = level.correction.view();
  for (int step = 1; step <= degree; ++step) {
    const bool product = step < degree || residual_after;
    if (step == 1) {
      on.run(n, BeginChebyshev{grows, product, low, stiffness, inverse, residual, smoother, direction, correction});
    } else {
      on.run(n, ContinueChebyshev{step, product, low, stiffness, inverse, residual, smoother, direction, correction});
    }
    if (product) add_scaled_edges(on, level);
  }
}

namespace detail {

PHYSGEN_PROGRAM
template <class On, class Level, class Interpolation>
PHYSGEN_FUNCTION void restrict_residual(On& on, Level& level, Level& coarse, const Interpolation& interpolation) {
  run_rows(on, coarse.nodes(),
           RestrictResidual{interpolation, level.children.const_view(), level.scales.const_view(),
                            level.residual.const_view(), coarse.constraints.const_view(), coarse.scales.const_view(),
                            coarse.residual.view()});
}

PHYSGEN_PROGRAM
template <class On, class Level, class Interpolation>
PHYSGEN_FUNCTION void interpolate_correction(On& on, Level& level, Level& coarse, const Interpolation& interpolation) {
  on.run(level.nodes(), InterpolateCorrection{interpolation, coarse.scales.const_view(), coarse.correction.const_view(),
                                              level.constraints.const_view(), level.scales.const_view(),
                                              level.scaled_nodes.const_view(), level.direction.view(),
                                              level.correction.view(), level.residual.view()});
}

}  // namespace detail

/// Whether the next coarser level is the finest of a background grid. A rank may have no node of those that lie in it.
PHYSGEN_PROGRAM
template <class Level>
[[nodiscard]] PHYSGEN_FUNCTION bool lies_in_grid(const Level& level) {
  return Level::Choices::grids && level.lies_in_grid;
}

/// r of the next coarser level, of what smoothing has left.
PHYSGEN_PROGRAM
template <class On, class Level>
PHYSGEN_FUNCTION void restrict_residual(On& on, Level& level, Level& coarse) {
  if (!lies_in_grid(level)) {
    detail::restrict_residual(on, level, coarse, HalfWay{level.parents.const_view()});
  } else if constexpr (Level::Choices::grids) {
    detail::restrict_residual(on, level, coarse, InGrid{level.grid_parents.const_view()});
  }
}

/// z takes in that of the next coarser level, and r what follows.
PHYSGEN_PROGRAM
template <class On, class Level>
PHYSGEN_FUNCTION void interpolate_correction(On& on, Level& level, Level& coarse) {
  if (!lies_in_grid(level)) {
    detail::interpolate_correction(on, level, coarse, HalfWay{level.parents.const_view()});
  } else if constexpr (Level::Choices::grids) {
    detail::interpolate_correction(on, level, coarse, InGrid{level.grid_parents.const_view()});
  }
  add_scaled_edges(on, level);
}

/// z of the coarsest level from its r.
PHYSGEN_PROGRAM
template <class On, class Level>
PHYSGEN_FUNCTION void solve_coarsest(On& on, Level& level) {
  if (level.coarse_inverse.size() != 0) {
    run_rows(on, level.nodes(),
             ApplyCoarseInverse{level.nodes(), level.coarse_inverse.const_view(), level.residual.const_view(),
                                level.correction.view()});
  } else {  // too large to be inverted: a polynomial of a wider interval
    smooth(on, level, 24, 0.005, false, false);
  }
}

/// For executors that run all small levels at once: z of level l from its r.
/// @return whether this one does, and has
template <class On, class Levels>
  requires(!PerformsIn<On, Cuda>)
PHYSGEN_FUNCTION bool cycle_at_once(On& /*on*/, Levels& /*levels*/, std::size_t /*l*/,
                                    const PreconditionerSettings& /*settings*/) {
  return false;
}

/// z of level `top` from its r; both scaled. r is used up. @param levels finest first
PHYSGEN_PROGRAM
template <class On, class Levels>
PHYSGEN_FUNCTION void v_cycle(On& on, Levels& levels, std::size_t top, const PreconditionerSettings& settings) {
  std::size_t l = top;
  while (!cycle_at_once(on, levels, l, settings)) {
    if (l + 1 == levels.size()) {
      solve_coarsest(on, *levels[l]);
      break;
    }
    smooth(on, *levels[l], settings.degree, settings.low, false, true);
    restrict_residual(on, *levels[l], *levels[l + 1]);
    ++l;
  }
  while (l > top) {
    --l;
    interpolate_correction(on, *levels[l], *levels[l + 1]);
    smooth(on, *levels[l], settings.degree, settings.low, true, false);
  }
}

}  // namespace physgen::fem
