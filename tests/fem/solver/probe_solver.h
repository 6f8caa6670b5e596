// The whole solver under probes. For host and CUDA translation units.
#pragma once

#include <fem/materials/materials.h>
#include <fem/solver/newton/implicit_step.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "probe_arrays.h"

namespace physgen::fem::test {

/// Backward Euler, and so Newton's method with all that it may use, as steps: nothing runs.
template <class On, class Real, class Stored>
void solver_program(On& on) {
  using Space = typename On::Space;
  ProbeEquilibrium<Real, Space> body;
  std::vector<std::unique_ptr<ProbeLevel<Real, Space, Stored>>> levels;
  using Level = ProbeLevel<Real, Space, Stored>;
  levels.push_back(std::make_unique<Level>(scenes::everything_scene::Level<Space, Real, Probed<Stored>>()));
  ProbeVectors<Real, Space> vectors;
  MaterialSteps<NeoHookean<double>> steps(NeoHookean<double>::from(1e5, 0.4), false);
  typename On::Loop loop;
  levels[0]->inertia = std::make_unique<ProbeInertia<Space, Real>>(
      scenes::everything_scene::Inertia<Space, Real, Probed<StoredAsDeclared>>());
  (void)implicit_step(on, loop, body, levels, vectors, steps, NewtonSettings{}, TimeStep{}, true);
}

/// "body.positions.x" of all fields that the program reads and does not write, without the solver's lists, whose ranges
/// and entries are inputs as a whole.
inline std::set<std::string> fields_read_only() {
  std::set<std::string> fields;
  for (const probe::FieldAccess& row : probe::registered()) {
    const bool of_a_list = row.array.ends_with("_ranges") || row.array.ends_with("_entries");
    if (row.read && !row.written && !of_a_list) fields.insert(row.array + "." + row.field);
  }
  return fields;
}

}  // namespace physgen::fem::test
