#include <fem/solver/load_history.h>
#include <physgen/error.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace physgen::fem {

namespace {

/// a += factor b; of no vectors, b alone.
void add(std::vector<Point>& a, const std::vector<Point>& b, double factor) {
  if (b.empty()) return;
  a.resize(b.size(), Point{});
  for (std::size_t n = 0; n < b.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) a[n][k] += factor * b[n][k];
  }
}

class HistorySolver final : public EquilibriumSolver {
 public:
  HistorySolver(std::unique_ptr<EquilibriumSolver> solver, LoadHistory history, int most_bisections)
      : solver_(std::move(solver)), history_(std::move(history)), most_bisections_(most_bisections) {
    for (const LoadHistory::Part& part : history_.parts) {
      require_curve(part.curve);
      reached_ = reached_ && part.curve.at(0) == 0;
    }
  }

  NewtonResult solve_to(double load, const std::function<void(std::size_t, const NewtonStep&)>& report) override {
    if (load == load_ && reached_) return solver_->solve_to(solver_->load(), report);
    NewtonResult total;
    int halvings = 0;
    for (;;) {
      const double next = halvings == 0 ? load : load_ + (load - load_) * std::ldexp(1.0, -halvings);
      solver_->set_loading(history_.at(next));
      const NewtonResult result = solver_->solve_to(1, report);
      const int bisections = total.bisections + result.bisections;
      add_increment(total, result);
      total.bisections = bisections;
      if (result.status == NewtonStatus::converged) {
        load_ = next;
        reached_ = true;
        if (load_ == load) return total;
        if (halvings > 0) --halvings;
        continue;
      }
      solver_->set_loading(history_.at(load_));
      const bool began_badly = result.status == NewtonStatus::not_finite && result.steps == 0;
      if (began_badly || load_ == load || ++halvings > most_bisections_ || total.bisections >= 4 * most_bisections_) {
        return total;
      }
      ++total.bisections;
    }
  }

  void set_loading(const Loading& loading) override {
    history_ = {loading, {}};
    reached_ = false;
  }
  [[nodiscard]] double load() const override { return load_; }
  [[nodiscard]] std::vector<Point> positions() const override { return solver_->positions(); }
  [[nodiscard]] std::vector<Point> forces() override { return solver_->forces(); }
  [[nodiscard]] std::optional<NodeState> coarser_equilibrium() override { return solver_->coarser_equilibrium(); }
  [[nodiscard]] std::vector<PlaneContact> plane_contacts() override { return solver_->plane_contacts(); }
  [[nodiscard]] std::vector<std::array<double, 9>> stresses() override { return solver_->stresses(); }
  [[nodiscard]] index_t bytes() const override { return solver_->bytes(); }
  [[nodiscard]] SolverState state() const override {
    SolverState state = solver_->state();
    state.load = load_;
    state.is_equilibrium = reached_;
    return state;
  }
  void restore(const SolverState& state) override {
    SolverState own = state;
    own.load = std::isfinite(state.load) ? 1.0 : state.load;
    solver_->restore(own);
    solver_->set_loading(history_.at(state.load));
    load_ = state.load;
    reached_ = state.is_equilibrium;
  }

 private:
  std::unique_ptr<EquilibriumSolver> solver_;
  LoadHistory history_;
  int most_bisections_;
  double load_ = 0;
  bool reached_ = true;  ///< whether positions are an equilibrium of load_
};

}  // namespace

double LoadCurve::at(double load) const {
  const auto behind = std::ranges::upper_bound(points, load, {}, [](const auto& point) { return point[0]; });
  if (behind == points.begin()) return points.front()[1];
  if (behind == points.end()) return points.back()[1];
  const auto& [low, factor] = *(behind - 1);
  const auto& [high, next] = *behind;
  return factor + (next - factor) * ((load - low) / (high - low));
}

void require_curve(const LoadCurve& curve) {
  const std::string which = "the curve '" + curve.name + "' ";
  if (curve.points.empty()) throw Error(which + "has no points; give at least one: a load and a factor");
  for (std::size_t k = 0; k < curve.points.size(); ++k) {
    const auto& [load, factor] = curve.points[k];
    if (!std::isfinite(load) || !std::isfinite(factor)) {
      throw Error(which + "has a point " + std::to_string(k) + " that is not finite; give a load and a factor");
    }
    if (k > 0 && !(load > curve.points[k - 1][0])) {
      throw Error(which + "does not ascend at point " + std::to_string(k) + ": " + std::to_string(load) + " follows " +
                  std::to_string(curve.points[k - 1][0]) + "; order the points by their loads");
    }
  }
}

Loading LoadHistory::at(double load) const {
  Loading sum;
  sum.planes = proportional.planes;
  const auto join = [&](const Loading& loading, double factor) {
    add(sum.motion, loading.motion, factor);
    add(sum.forces, loading.forces, factor);
    for (FollowingPressure pressure : loading.pressures) {
      pressure.pressure *= factor;
      sum.pressures.push_back(std::move(pressure));
    }
  };
  join(proportional, load);
  for (const Part& part : parts) join(part.loading, part.curve.at(load));
  return sum;
}

std::unique_ptr<EquilibriumSolver> follow(std::unique_ptr<EquilibriumSolver> solver, LoadHistory history,
                                          int most_bisections) {
  return std::make_unique<HistorySolver>(std::move(solver), std::move(history), most_bisections);
}

}  // namespace physgen::fem
