// A state of a body as its solver hands it out: of nodes and tets that are named, so that what is printed and written
// of it goes by windows.
#pragma once

#include <fem/solver/quasistatic.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace physgen::truthcube {

/// All ranks ask for the same in the same order. The first gets numbers, in the order in which nodes or tets are named,
/// others none; but for how many nodes there are, and contacts, which all get. It is asked before the solver goes on.
class BodyState {
 public:
  BodyState() = default;
  BodyState(const BodyState&) = delete;
  BodyState& operator=(const BodyState&) = delete;
  virtual ~BodyState() = default;

  /// Whether this rank gets numbers.
  [[nodiscard]] virtual bool is_here() const = 0;
  /// Of the levels on which equilibrium is solved, finest first.
  [[nodiscard]] virtual std::vector<fem::Index> nodes_of_levels() const = 0;
  /// @param level 0: the finest @return [m]
  [[nodiscard]] virtual std::vector<fem::Point> positions(std::size_t level, std::span<const fem::Index> nodes) = 0;
  /// @param level 0, or 1 where there are coarser_contacts() @return as EquilibriumSolver::forces() gives them [N]
  [[nodiscard]] virtual std::vector<fem::Point> forces(std::size_t level, std::span<const fem::Index> nodes) = 0;
  /// @return of tets of the finest mesh, by columns, as EquilibriumSolver::stresses() gives them [Pa]
  [[nodiscard]] virtual std::vector<std::array<double, 9>> stresses(std::span<const fem::Index> tets) = 0;
  /// The contact of planes with the next coarser mesh, where nested iteration has found its equilibrium; else nothing.
  [[nodiscard]] virtual std::optional<std::vector<fem::PlaneContact>> coarser_contacts() = 0;
};

/// In one process, of vectors that have all: each is made when it is asked for the first time.
class WholeState final : public BodyState {
 public:
  using Points = std::vector<fem::Point>;
  struct Makers {
    std::function<std::vector<Points>()> positions;  ///< of all levels
    std::function<Points()> forces;
    std::function<std::vector<std::array<double, 9>>()> stresses;
    std::function<std::optional<fem::NodeState>()> coarser = [] { return std::nullopt; };
  };
  explicit WholeState(Makers makers) : make_(std::move(makers)), positions_(make_.positions()) {}
  /// @param solver stays as it is as long as this
  explicit WholeState(fem::EquilibriumSolver& solver);

  [[nodiscard]] bool is_here() const override { return true; }
  [[nodiscard]] std::vector<fem::Index> nodes_of_levels() const override;
  [[nodiscard]] Points positions(std::size_t level, std::span<const fem::Index> nodes) override;
  [[nodiscard]] Points forces(std::size_t level, std::span<const fem::Index> nodes) override;
  [[nodiscard]] std::vector<std::array<double, 9>> stresses(std::span<const fem::Index> tets) override;
  [[nodiscard]] std::optional<std::vector<fem::PlaneContact>> coarser_contacts() override;

 private:
  [[nodiscard]] const std::optional<fem::NodeState>& coarser();

  Makers make_;
  std::vector<Points> positions_;
  std::optional<Points> forces_;
  std::optional<std::vector<std::array<double, 9>>> stresses_;
  std::optional<std::optional<fem::NodeState>> coarser_;
};

}  // namespace physgen::truthcube
