// A state of a body on several ranks, of what their solver hands out of nodes and tets that are named.
#pragma once

#include <fem/solver/solvers/solver_on_ranks.h>

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "body_state.h"

namespace physgen::truthcube {

/// Forces and stresses are computed when they are asked for the first time.
class StateOnRanks final : public BodyState {
 public:
  /// @param solver stays as it is as long as this @param is_first whether this is the rank that gets numbers
  StateOnRanks(fem::RankReport& solver, bool is_first) : solver_(solver), is_first_(is_first) {}

  [[nodiscard]] bool is_here() const override { return is_first_; }
  [[nodiscard]] std::vector<fem::Index> nodes_of_levels() const override { return solver_.nodes_of_levels(); }
  [[nodiscard]] std::vector<fem::Point> positions(std::size_t level, std::span<const fem::Index> nodes) override {
    return solver_.positions_of(level, nodes);
  }
  [[nodiscard]] std::vector<fem::Point> forces(std::size_t level, std::span<const fem::Index> nodes) override {
    if (!std::exchange(has_forces_.at(level), true)) solver_.compute_forces(level);
    return solver_.forces_of(level, nodes);
  }
  [[nodiscard]] std::vector<std::array<double, 9>> stresses(std::span<const fem::Index> tets) override {
    if (!std::exchange(has_stresses_, true)) solver_.compute_stresses();
    return solver_.stresses_of(tets);
  }
  [[nodiscard]] std::optional<std::vector<fem::PlaneContact>> coarser_contacts() override {
    return solver_.coarser_contacts();
  }

 private:
  fem::RankReport& solver_;
  bool is_first_, has_stresses_ = false;
  std::array<bool, 2> has_forces_{};  // of the finest mesh and the next coarser one
};

}  // namespace physgen::truthcube
