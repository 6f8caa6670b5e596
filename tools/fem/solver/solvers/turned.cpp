#include <fem/mesh/geometry.h>
#include <fem/solver/number_text.h>
#include <fem/solver/solvers/turned.h>
#include <physgen/error.h>

#include <cmath>
#include <string>
#include <utility>

namespace physgen::fem {

namespace {

/// What both kinds of solvers do. @tparam Base EquilibriumSolver or QuasistaticSolver
template <class Base>
class TurnedSolver : public Base {
 public:
  TurnedSolver(const Turn& turn, std::unique_ptr<Base> solver) : turn_(turn), solver_(std::move(solver)) {}

  NewtonResult solve_to(double load, const std::function<void(std::size_t, const NewtonStep&)>& report) override {
    return solver_->solve_to(load, report);
  }
  void set_loading(const Loading& loading) override { solver_->set_loading(turn_.along(loading)); }
  [[nodiscard]] double load() const override { return solver_->load(); }
  [[nodiscard]] std::vector<Point> positions() const override { return turn_.back(solver_->positions()); }
  [[nodiscard]] std::vector<Point> forces() override { return turn_.back(solver_->forces()); }
  [[nodiscard]] std::optional<NodeState> coarser_equilibrium() override {
    std::optional<NodeState> state = solver_->coarser_equilibrium();
    if (state) {
      state->positions = turn_.back(std::move(state->positions));
      state->forces = turn_.back(std::move(state->forces));
    }
    return state;
  }
  [[nodiscard]] std::vector<PlaneContact> plane_contacts() override { return solver_->plane_contacts(); }
  [[nodiscard]] std::vector<Turn::Block> stresses() override {
    std::vector<Turn::Block> stresses = solver_->stresses();
    for (Turn::Block& stress : stresses) stress = turn_.back(stress);
    return stresses;
  }
  [[nodiscard]] index_t bytes() const override { return solver_->bytes(); }
  [[nodiscard]] SolverState state() const override {
    SolverState state = solver_->state();
    for (auto& positions : state.positions) positions = turn_.back(std::move(positions));
    return state;
  }
  void restore(const SolverState& state) override {
    SolverState turned{state.load, state.is_equilibrium, {}};
    for (const auto& positions : state.positions) turned.positions.push_back(turn_.along(positions));
    solver_->restore(turned);
  }

 protected:
  Turn turn_;
  std::unique_ptr<Base> solver_;
};

class TurnedQuasistaticSolver final : public TurnedSolver<QuasistaticSolver> {
 public:
  using TurnedSolver::TurnedSolver;

  void set_positions(std::span<const Point> positions) override { solver_->set_positions(turn_.along(positions)); }
  [[nodiscard]] AssembledStiffness stiffness() override {
    AssembledStiffness stiffness = solver_->stiffness();
    for (auto* blocks : {&stiffness.nodes, &stiffness.edge_blocks}) {
      for (Turn::Block& block : *blocks) block = turn_.back(block);
    }
    return stiffness;
  }
  LinearMeasurement measure_linear(std::span<const Point> force, const LinearTask& task,
                                   std::vector<Point>* step) override {
    const LinearMeasurement measured = solver_->measure_linear(turn_.along(force), task, step);
    if (step != nullptr) *step = turn_.back(std::move(*step));
    return measured;
  }
};

}  // namespace

Turn::Turn(const std::array<Point, 3>& axes) : axes_(axes) {
  constexpr double rounding = 1e-9;
  bool right = dot(cross(axes[0], axes[1]), axes[2]) > 0;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t l = 0; l <= k; ++l) {
      right = right && std::abs(dot(axes[k], axes[l]) - (k == l ? 1 : 0)) < rounding;
    }
  }
  if (right) return;
  std::string all;
  for (const Point& a : axes) {
    all += (all.empty() ? "(" : ", (") + number_text(a[0]) + ", " + number_text(a[1]) + ", " + number_text(a[2]) + ")";
  }
  throw Error("the axes of prescribed components are " + all +
              " and must be perpendicular to each other, of length 1 and right-handed");
}

Point Turn::along(const Point& x) const { return {dot(axes_[0], x), dot(axes_[1], x), dot(axes_[2], x)}; }

std::vector<Point> Turn::along(std::span<const Point> vectors) const {
  std::vector<Point> turned;
  turned.reserve(vectors.size());
  for (const Point& x : vectors) turned.push_back(along(x));
  return turned;
}

std::vector<MeshLevel> Turn::along(const std::vector<MeshLevel>& levels) const {
  std::vector<MeshLevel> turned = levels;
  for (MeshLevel& level : turned) {
    for (Point& x : level.rest) x = along(x);
    level.axes.reset();
  }
  return turned;
}

Loading Turn::along(const Loading& loading) const {
  Loading turned = loading;
  turned.motion = along(std::span<const Point>(loading.motion));
  turned.forces = along(std::span<const Point>(loading.forces));
  for (RigidPlane& plane : turned.planes) plane.normal = along(plane.normal);
  return turned;
}

Point Turn::back(const Point& x) const {
  Point result{};
  for (std::size_t c = 0; c < 3; ++c) result[c] = axes_[0][c] * x[0] + axes_[1][c] * x[1] + axes_[2][c] * x[2];
  return result;
}

std::vector<Point> Turn::back(std::vector<Point> vectors) const {
  for (Point& x : vectors) x = back(x);
  return vectors;
}

Turn::Block Turn::back(const Block& tensor) const {
  Block result{};
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t l = 0; l < 3; ++l) result[r + 3 * c] += axes_[k][r] * tensor[k + 3 * l] * axes_[l][c];
      }
    }
  }
  return result;
}

std::unique_ptr<QuasistaticSolver> Turn::back(std::unique_ptr<QuasistaticSolver> solver) const {
  return std::make_unique<TurnedQuasistaticSolver>(*this, std::move(solver));
}

std::unique_ptr<EquilibriumSolver> Turn::back(std::unique_ptr<EquilibriumSolver> solver) const {
  return std::make_unique<TurnedSolver<EquilibriumSolver>>(*this, std::move(solver));
}

}  // namespace physgen::fem
