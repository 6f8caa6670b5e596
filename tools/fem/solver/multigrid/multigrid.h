// The preconditioner: one V-cycle of multigrid with Galerkin levels, smoothed by Chebyshev polynomials of block Jacobi;
// or a multilevel Schwarz preconditioner, or block Jacobi alone. Programs over an executor, so that they run on the CPU
// and on CUDA alike.
#pragma once

#include <fem/solver/elastic/tangent_blocks.h>
#include <fem/solver/loads/inertia.h>
#include <fem/solver/loads/rigid_planes.h>
#include <fem/solver/multigrid/cycle.h>
#include <fem/solver/multigrid/galerkin.h>
#include <fem/solver/multigrid/grid_galerkin.h>
#include <fem/solver/multigrid/linear_level.h>
#include <fem/solver/multigrid/power_iteration.h>
#include <fem/solver/multigrid/scaled_blocks.h>
#include <fem/solver/multigrid/vector_steps.h>
#include <fem/solver/schwarz/schwarz.h>
#include <fem/solver/settings.h>
#include <physgen/reduce.h>

#include <vector>

namespace physgen::fem {

/// y = K x of a level's scaled stiffness.
template <class On, class Level, class DisplacementView, class DifferentialView>
void multiply_scaled(On& on, Level& level, const DisplacementView& x, const DifferentialView& y) {
  multiply(on, scaled_product(level, x, y), level.sums);
}

/// Runs a ScaleEdges over all edges; the scaled blocks lie as the executor's products want them.
template <class On, class Level, class Kernel>
void scale_edges(On& on, Level& level, const Kernel& kernel) {
  on.run(level.edge_count(), kernel);
}

/// The scaled copy of a level's stiffness, its block inverses, and the largest eigenvalue of both.
/// @param fresh whether power iterations begin anew
template <class On, class Level>
void prepare_level(On& on, Level& level, const PreconditionerSettings& settings, bool fresh) {
  const index_t n = level.nodes();
  const auto scales = level.scales.view();
  const auto inverse = level.inverse.view();
  const bool unit = settings.kind == Preconditioner::none || settings.kind == Preconditioner::schwarz;
  on.run(n, ComputeNodeScale{unit, level.node_stiffness.const_view(), scales});
  on.run(n, ScaleNodes{level.node_stiffness.const_view(), level.constraints.const_view(), level.scales.const_view(),
                       level.scaled_nodes.view(), inverse});
  if (settings.kind != Preconditioner::multigrid) return;
  scale_edges(on, level,
              ScaleEdges{level.edges.const_view(), level.constraints.const_view(), level.edge_stiffness.const_view(),
                         level.scales.const_view(), level.scaled_edges.view()});
  if constexpr (Level::Stored::rounds) {
    using Format = typename Level::Stored::Edge;
    on.run(n, keep_translations<Format>(level.node_edges.const_view(), level.edges.const_view(),
                                        level.constraints.const_view(), level.scales.const_view(),
                                        level.edge_stiffness.const_view(), level.scaled_nodes.view()));
  }
  const auto power = level.power.view();
  const auto smoother = level.smoother.view();
  if (fresh) on.run(n, ScatterDirection{power});
  const int steps = fresh ? settings.first_power_steps : settings.next_power_steps;
  for (int k = 1; k <= steps; ++k) {  // the last one is measured
    if (k == steps || k % 8 == 0) {
      on.reduce(n, SquaredLength{level.power.const_view()}, Sum{}, StoreLength{smoother});
    }
    if (k < steps && k % 8 == 0) {  // before a float overflows
      on.run(n, NormalisePower{level.smoother.const_view(), power});
    }
    multiply_scaled(on, level, level.power.const_view(), level.residual.view());
    const IteratePower iterate{level.inverse.const_view(), level.residual.const_view(), power};
    if (k < steps) {
      on.run(n, iterate);
    } else {
      on.reduce(n, iterate, Sum{}, StoreLargest{smoother});
    }
  }
  on.run(n, NormalisePower{level.smoother.const_view(), power});
}

/// The stiffness of the next coarser level.
template <class On, class Level>
void coarsen_stiffness(On& on, Level& fine, Level& coarse) {
  const auto node_stiffness = fine.node_stiffness.const_view();
  const auto edge_stiffness = fine.edge_stiffness.const_view();
  if (!lies_in_grid(fine)) {
    on.run(coarse.edge_count(), CoarsenEdgeStiffness{fine.edge_terms.const_view(), node_stiffness, edge_stiffness,
                                                     coarse.edge_stiffness.view()});
  } else if constexpr (Level::Choices::grids) {
    on.run(coarse.edge_count(), CoarsenToGrid{fine.edge_terms.const_view(), fine.grid_parents.const_view(),
                                              fine.constraints.const_view(), fine.edges.const_view(), node_stiffness,
                                              edge_stiffness, coarse.edges.const_view(), coarse.edge_stiffness.view()});
    on.run(fine.nodes(),
           SumTranslationStiffness{fine.node_edges.const_view(), fine.edges.const_view(), fine.constraints.const_view(),
                                   node_stiffness, edge_stiffness, fine.translations.view()});
    where(fine.planes, [&](auto& planes) {
      on.run(fine.nodes(), AddPlaneTranslations{fine.constraints.const_view(), planes.stiffness.const_view(),
                                                fine.translations.view()});
    });
    where(fine.inertia, [&](auto& inertia) {
      on.run(fine.nodes(), AddInertiaTranslations{inertia.per_mass, fine.constraints.const_view(),
                                                  inertia.masses.const_view(), fine.translations.view()});
    });
  }
  on.run(coarse.nodes(), SumNodeStiffness{coarse.node_edges.const_view(), coarse.edge_stiffness.const_view(),
                                          coarse.node_stiffness.view()});
  if (!coarse.is_grid) {
    where(fine.planes, coarse.planes, [&](auto& planes, auto& coarse_planes) {
      on.run(coarse.nodes(), CoarsenPlaneStiffness{fine.children.const_view(), planes.stiffness.const_view(),
                                                   coarse_planes.stiffness.view(), coarse.node_stiffness.view()});
    });
    where(fine.inertia, coarse.inertia, [&](auto& inertia, auto& coarse_inertia) {
      on.run(coarse.nodes(),
             AddInertiaStiffness{inertia.per_mass, coarse_inertia.masses.const_view(), coarse.node_stiffness.view()});
    });
    return;
  }
  if constexpr (Level::Choices::grids) {
    with_interpolation(fine, [&](const auto& interpolation) {
      on.run(coarse.nodes(), CoarsenTranslationStiffness{interpolation, fine.children.const_view(),
                                                         fine.translations.const_view(), coarse.translations.view()});
    });
    on.run(coarse.nodes(), AddTranslationStiffness{coarse.translations.const_view(), coarse.node_stiffness.view()});
  }
}

/// Everything that depends on the stiffness of level `top`, which is given: coarser stiffness, scaled copies,
/// eigenvalues, the coarsest inverse. @param levels finest first
template <class On, class Levels>
void prepare(On& on, Levels& levels, std::size_t top, const PreconditionerSettings& settings, bool fresh) {
  prepare_level(on, *levels[top], settings, fresh);
  if (settings.kind == Preconditioner::schwarz) prepare_schwarz(on, *levels[top]);
  if (settings.kind != Preconditioner::multigrid) return;
  for (std::size_t l = top; l + 1 < levels.size(); ++l) {
    auto& fine = *levels[l];
    auto& coarse = *levels[l + 1];
    coarsen_stiffness(on, fine, coarse);
    prepare_level(on, coarse, settings, fresh);
  }
  invert_coarsest(on, *levels.back());
}

/// z = M r of level `top`, both scaled. r is used up.
template <class On, class Levels>
void precondition(On& on, Levels& levels, std::size_t top, const PreconditionerSettings& settings) {
  auto& level = *levels[top];
  const index_t n = level.nodes();
  if (settings.kind == Preconditioner::none) {
    on.run(n, CopyResidual{level.residual.const_view(), level.correction.view()});
  } else if (settings.kind == Preconditioner::block_jacobi) {
    on.run(n, ApplyBlockJacobi{level.inverse.const_view(), level.residual.const_view(), level.correction.view()});
  } else if (settings.kind == Preconditioner::schwarz) {
    apply_schwarz(on, level);
  } else if constexpr (std::remove_cvref_t<decltype(level)>::Choices::assembled) {
    v_cycle(on, levels, top, settings);
  }
}

}  // namespace physgen::fem
