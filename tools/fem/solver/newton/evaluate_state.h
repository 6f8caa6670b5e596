// Energy and forces of a mesh at given positions, as a program over an executor and arrays by name.
#pragma once

#include <fem/solver/elastic/evaluate.h>
#include <fem/solver/newton/newton_steps.h>

#include <cmath>

namespace physgen::fem {

/// Energy, forces and residual of the state at `positions`.
/// @param evaluator an Evaluator of these arrays, or MaterialSteps
/// @param restart averaged volumes begin their linearised pressure anew
template <class On, class Arrays, class Level, class Evaluate, class Positions, class Forces>
auto evaluate_state(On& on, Arrays& a, Level& level, Evaluate& evaluator, const Positions& positions,
                    const Forces& forces, const AtLoad& at, bool restart) {
  const auto state = a.state.view();
  evaluator.evaluate_volumes(on, a, positions, restart);
  for (const TetChunk& chunk : a.chunks) {
    evaluator.evaluate_forces(on, a, chunk, positions);
    on.run(chunk.nodes(), SumForces{chunk, at.load, a.node_tets.const_view(), a.chunk_arrays->corners.const_view(),
                                    a.loads.const_view(), forces});
  }
  where(a.surface, [&](auto& surface) {
    on.run(a.nodes(),
           AddPressures{at.load, surface.node_faces.const_view(), surface.faces.const_view(), positions, forces});
  });
  const auto measure = [&](const auto& planes, const auto& inertia) {
    on.reduce(a.nodes(),
              MeasureForces{at.load, a.loads.const_view(), level.constraints.const_view(), a.rest.const_view(),
                            positions, forces, planes, inertia},
              Sum{}, StoreForces{state});
  };
  const auto measure_with = [&](const auto& inertia) {
    if (!where(level.planes, [&](auto& planes) { measure(planes.at(at), inertia); })) measure(NoPlanes{}, inertia);
  };
  if (!where(level.inertia, [&](auto& own) { measure_with(own.at_step()); })) measure_with(NoInertia{});
  where(a.surface, [&](auto& surface) {
    on.reduce(surface.faces.size(),
              PressurePotential{at.load, surface.centre, surface.faces.const_view(), a.rest.const_view(), positions},
              Sum{}, AddPressurePotential{state});
  });
  on.reduce(a.tet_count(), VolumeRatio{a.tets.const_view(), a.rest.const_view(), positions}, Min{},
            StoreSmallestRatio{state});
  return on.value(a.state);
}

/// [J] @param state what evaluate_state() returns
template <class State>
[[nodiscard]] double energy_of(const State& state) {
  return state.elastic + state.volumetric + state.loads;
}
/// |force| over free components [N]
template <class State>
[[nodiscard]] double free_force(const State& state) {
  return std::sqrt(state.free_square);
}

}  // namespace physgen::fem
