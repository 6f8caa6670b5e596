#include "body_state.h"

#include <fem/mesh/follow_numbers.h>

namespace physgen::truthcube {

using fem::in_order;
using fem::Index;
using fem::Point;

WholeState::WholeState(fem::EquilibriumSolver& solver)
    : WholeState({[&solver] { return solver.state().positions; }, [&solver] { return solver.forces(); },
                  [&solver] { return solver.stresses(); }, [&solver] { return solver.coarser_equilibrium(); }}) {}

std::vector<Index> WholeState::nodes_of_levels() const {
  std::vector<Index> nodes;
  for (const Points& level : positions_) nodes.push_back(static_cast<Index>(level.size()));
  return nodes;
}

WholeState::Points WholeState::positions(std::size_t level, std::span<const Index> nodes) {
  return in_order(std::span<const Point>(positions_.at(level)), nodes);
}

WholeState::Points WholeState::forces(std::size_t level, std::span<const Index> nodes) {
  if (level > 0) return in_order(std::span<const Point>(coarser().value().forces), nodes);
  if (!forces_) forces_ = make_.forces();
  return in_order(std::span<const Point>(*forces_), nodes);
}

std::vector<std::array<double, 9>> WholeState::stresses(std::span<const Index> tets) {
  if (!stresses_) stresses_ = make_.stresses();
  return in_order(std::span<const std::array<double, 9>>(*stresses_), tets);
}

std::optional<std::vector<fem::PlaneContact>> WholeState::coarser_contacts() {
  if (!coarser()) return std::nullopt;
  return coarser()->planes;
}

const std::optional<fem::NodeState>& WholeState::coarser() {
  if (!coarser_) coarser_ = make_.coarser();
  return *coarser_;
}

}  // namespace physgen::truthcube
