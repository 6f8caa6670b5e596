// The levels of multigrid, from the finest stiffness: coarser stiffness, scaled copies, eigenvalues.
#pragma once

#include <fem/solver/elastic/tangent_blocks.h>
#include <fem/solver/levels/linear_level.h>
#include <fem/solver/levels/scaled_blocks.h>
#include <fem/solver/loads/inertia.h>
#include <fem/solver/loads/rigid_planes.h>
#include <fem/solver/preconditioners/multigrid/cycle.h>
#include <fem/solver/preconditioners/multigrid/galerkin.h>
#include <fem/solver/preconditioners/multigrid/grid_galerkin.h>
#include <fem/solver/preconditioners/multigrid/power_iteration.h>
#include <fem/solver/settings.h>
#include <physgen/launch/reduce.h>

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
  scale_nodes(on, level, false);
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
  if (fresh) on.run(n, ScatterDirection{numbers_of(on, level.power), power});
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

}  // namespace physgen::fem
