// The whole solver under probes. For host and CUDA translation units.
#pragma once

#include <fem/materials/materials.h>
#include <fem/solver/newton.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "probe_arrays.h"

namespace physgen::fem::test {

/// Newton's method with all that it may use, as steps: nothing runs.
template <class On, class Real, class Stored>
void newton_program(On& on) {
  using Space = typename On::Space;
  ProbeEquilibrium<Real, Space> body;
  std::vector<std::unique_ptr<ProbeLevel<Real, Space, Stored>>> levels;
  levels.push_back(std::make_unique<ProbeLevel<Real, Space, Stored>>());
  ProbeVectors<Real, Space> vectors;
  MaterialSteps<NeoHookean<double>> steps(NeoHookean<double>::from(1e5, 0.4), false);
  typename On::Loop loop;
  (void)find_equilibrium(on, loop, body, levels, 0, vectors, steps, NewtonSettings{}, 1.0, false, true, {});
}

}  // namespace physgen::fem::test
