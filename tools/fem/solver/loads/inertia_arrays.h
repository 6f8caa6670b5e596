// The arrays that a level keeps of inertia; made only where bodies move.
#pragma once

#include <dynamics.physgen.h>
#include <fem/solver/arrays/over_groups.h>
#include <fem/solver/arrays/solver_arrays.h>
#include <fem/solver/loads/inertia.h>

#include <utility>
#include <vector>

namespace physgen::fem {

/// @tparam Group with the arrays of Inertia in solver_groups.h
template <class Group>
struct InertiaOver : Group {
  double per_mass = 0;  ///< c / m [1/s^2]; 0: no inertia

  explicit InertiaOver(Group&& arrays) : Group(std::move(arrays)) {}
  /// @param masses_of_nodes [kg] @param solved whether equilibrium is solved on the level
  InertiaOver(const std::vector<double>& masses_of_nodes, bool solved) {
    const auto nodes = index_t(masses_of_nodes.size());
    this->allocate(counts(nodes, solved));
    put(this->masses, host_masses(masses_of_nodes));
  }

  [[nodiscard]] static auto counts(index_t nodes, bool solved) {
    return typename Group::Counts{.node = nodes, .moving_node = solved ? nodes : 0, .measure = solved ? 1 : 0};
  }

  /// For kernels. @pre equilibrium is solved on the level
  [[nodiscard]] auto at_step() const {
    return Inertia{per_mass, this->masses.const_view(), this->centres.const_view()};
  }

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
