// What a level keeps of inertia; made only where bodies move.
#pragma once

#include <dynamics.physgen.h>
#include <fem/solver/inertia.h>
#include <fem/solver/solver_arrays.h>

#include <vector>

namespace physgen::fem {

template <class Space>
struct InertiaArrays {
  dynamics::NodeMassArray<double, Space> masses;
  // Empty where equilibrium is not solved.
  elasticity::NodePositionArray<double, Space> centres;  ///< y of inertia.h
  dynamics::NodeVelocityArray<double, Space> velocities;
  dynamics::MotionArray<double, Space> measured;
  double per_mass = 0;  ///< c / m [1/s^2]; 0: no inertia

  /// @param masses_of_nodes [kg] @param solved whether equilibrium is solved on the level
  InertiaArrays(const std::vector<double>& masses_of_nodes, bool solved)
      : masses(moved_to<decltype(masses)>(host_masses(masses_of_nodes))),
        centres(solved ? masses.size() : 0),
        velocities(solved ? masses.size() : 0),
        measured(solved ? 1 : 0) {}

  [[nodiscard]] index_t bytes() const { return bytes_of(masses, centres, velocities, measured); }
  /// For kernels. @pre equilibrium is solved on the level
  [[nodiscard]] auto at_step() const { return Inertia{per_mass, masses.const_view(), centres.const_view()}; }

 private:
  static auto host_masses(const std::vector<double>& given) {
    dynamics::NodeMassArray<double> array(index_t(given.size()));
    for (index_t n = 0; n < array.size(); ++n) array.view()[n].mass() = given[std::size_t(n)];
    return array;
  }
};

/// Masses of the next coarser mesh: those of children, shared by their parents.
[[nodiscard]] inline std::vector<double> coarsened_masses(const std::vector<double>& masses,
                                                          const std::vector<std::array<Index, 2>>& parents,
                                                          Index coarse_nodes) {
  std::vector<double> coarse(static_cast<std::size_t>(coarse_nodes), 0.0);
  for (std::size_t n = 0; n < parents.size(); ++n) {
    for (const Index parent : parents[n]) coarse[static_cast<std::size_t>(parent)] += 0.5 * masses[n];
  }
  return coarse;
}

}  // namespace physgen::fem
