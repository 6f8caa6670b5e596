// The solver of the scene implicit_dynamics on several ranks.
#include <fem/solver/linear/performed_steps.h>
#include <fem/solver/masses.h>
#include <fem/solver/solvers/implicit_steps.h>
#include <fem/solver/solvers/named_of_ranks.h>
#include <fem/solver/solvers/part_of_rank.h>
#include <fem/solver/solvers/solvers_on_ranks.h>
#include <implicit_dynamics.halos.h>
#include <quasistatic.halos.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace physgen::fem {

/// The program of the scene evaluates no stresses; their rows are those of quasistatic, which has the same arrays.
template <>
inline HaloUses halos_of<scenes::implicit_dynamics>() {
  static const std::vector<HaloUse> rows = [] {
    std::vector<HaloUse> all(std::begin(scenes::implicit_dynamics_scene::halos),
                             std::end(scenes::implicit_dynamics_scene::halos));
    std::ranges::copy_if(scenes::quasistatic_scene::halos, std::back_inserter(all), [](const HaloUse& row) {
      return row.kernel == std::string_view("physgen::fem::EvaluateStress");
    });
    return all;
  }();
  return rows;
}

namespace {

using On = DistributedExecutor<HostExecutor>;
using Scene = scenes::implicit_dynamics;
using Types = QuasistaticMesh<Host, Scene>::Types;
using Inertias = std::vector<scenes::implicit_dynamics_scene::Inertia<Host>>;

/// The masses of the nodes of the first `used` levels [kg], finest first. @param density [kg/m^3]
std::vector<std::vector<double>> masses_of(const std::vector<MeshLevel>& levels, std::size_t used, double density) {
  std::vector<std::vector<double>> masses{lumped_masses(levels.front().mesh, levels.front().rest, density)};
  while (masses.size() < used) {
    const std::size_t l = masses.size();
    masses.push_back(coarsened_masses(masses.back(), levels[l - 1].parents, levels[l].mesh.nodes));
  }
  return masses;
}

/// Adds the arrays of inertia of all levels. @param nodes of the whole finest mesh
void add(DistributedArrays& arrays, Inertias& inertia, index_t nodes) {
  arrays.add_set("moving_node", nodes);
  arrays.same_set("moving_node", "node");
  arrays.add("inertia.centres", "moving_node", inertia.front().centres);
  arrays.add("inertia.velocities", "moving_node", inertia.front().velocities);
  for (std::size_t l = 0; l < inertia.size(); ++l) {
    const std::string number = detail::in_brackets(l) + ".";
    arrays.add("inertia" + number + "masses", "level" + number + "node", inertia[l].masses.contents());
  }
}

/// What a rank has of a body that moves.
struct MovingPart {
  std::vector<std::vector<double>> masses;  ///< of all nodes of each level [kg]
  Inertias inertia;
  detail::PartOfRank<On, Scene> of_body;

  MovingPart(const Ranks& ranks, WholeBody<Scene>& whole, const std::vector<MeshLevel>& levels, double density,
             const DistributedOptions& options)
      : masses(masses_of(levels, whole.levels.size(), density)),
        inertia(masses.size()),
        of_body(ranks, whole, options,
                [&](DistributedArrays& arrays) { add(arrays, inertia, static_cast<index_t>(masses.front().size())); }) {
    for (std::size_t l = 0; l < inertia.size(); ++l) {
      of_body.finest->arrays.fill(inertia[l].masses.contents(), [&](index_t node) {
        typename decltype(inertia[l].masses)::Value value{};
        value.mass = masses[l][static_cast<std::size_t>(node)];
        return value;
      });
    }
    inertia.front().measured.resize(1);
  }
};

class ImplicitOnRanks final : public MotionOnRanks, private MovingPart, private ImplicitSteps<On, Types> {
  using Steps = ImplicitSteps<On, Types>;

 public:
  ImplicitOnRanks(const Ranks& ranks, WholeBody<Scene> whole, const std::vector<MeshLevel>& levels,
                  const DynamicSettings& settings, const DistributedOptions& options)
      : MovingPart(ranks, whole, levels, settings.density, options),
        Steps(*of_body.on, settings.solver, Types::make_material(settings.solver, whole.body.volumes.size() > 0), 1) {
    Steps::take(*of_body.finest);
    Steps::take_levels(*of_body.finest);
    for (std::size_t l = 0; l < linear_.size(); ++l) {
      linear_[l]->inertia = std::make_unique<GroupOf<decltype(linear_[l]->inertia)>>(std::move(inertia[l]));
    }
    const double spacing = mean_spacing(levels.front().mesh, levels.front().rest);
    body_ = {settings.damping, node_stiffness(settings.solver, false, spacing), std::ranges::max(masses.front()),
             masses.front().size()};
    masses.clear();
    masses.shrink_to_fit();
  }

  NewtonResult step(double length, double load) override { return Steps::step(length, load); }
  [[nodiscard]] double time() const override { return time_; }
  [[nodiscard]] std::vector<Point> positions() const override {
    return of_all_ranks<3>(arrays(), arrays_.front()->positions, position);
  }
  [[nodiscard]] std::vector<Point> velocities() const override {
    return of_all_ranks<3>(arrays(), linear_.front()->inertia->velocities,
                           [](const auto& node, int k) -> double { return node.v()[k]; });
  }
  void set_positions(std::span<const Point> positions) override {
    require_of_first("the position", positions);
    for (auto* array : {&arrays_.front()->positions, &arrays_.front()->kept}) {
      fill_from_first_rank(arrays(), *array, positions, [](auto& node, int k) -> auto& { return node.x[k]; });
    }
    is_moved_ = true;
  }
  void set_velocities(std::span<const Point> velocities) override {
    require_of_first("the velocity", velocities);
    fill_from_first_rank(arrays(), linear_.front()->inertia->velocities, velocities,
                         [](auto& node, int k) -> auto& { return node.v[k]; });
  }
  [[nodiscard]] std::vector<Point> forces() override {
    compute_forces(0);
    return of_all_ranks<3>(arrays(), arrays_.front()->forces, force);
  }
  [[nodiscard]] std::vector<std::array<double, 9>> stresses() override {
    compute_stresses();
    return of_all_ranks<9>(arrays(), of_body.stresses_of_tets, stress);
  }
  [[nodiscard]] MotionMeasure measure() override { return Steps::measure(); }
  [[nodiscard]] index_t bytes() const override { return Steps::bytes() + of_body.stresses_of_tets.bytes(); }

  [[nodiscard]] std::vector<Index> nodes_of_levels() const override { return {static_cast<Index>(body_.nodes)}; }
  [[nodiscard]] std::vector<Point> positions_of(std::size_t level, std::span<const Index> nodes) const override {
    return named_of_ranks<3>(arrays(), arrays_.at(level)->positions, nodes, position);
  }
  [[nodiscard]] std::vector<Point> forces_of(std::size_t level, std::span<const Index> nodes) const override {
    return named_of_ranks<3>(arrays(), arrays_.at(level)->forces, nodes, force);
  }
  [[nodiscard]] std::vector<std::array<double, 9>> stresses_of(std::span<const Index> tets) const override {
    return named_of_ranks<9>(arrays(), of_body.stresses_of_tets, tets, stress);
  }
  void compute_forces(std::size_t level) override { (void)evaluate_now(level, load_); }
  void compute_stresses() override { evaluate_stresses(load_, of_body.stresses_of_tets); }

  [[nodiscard]] PartOfMesh part() const override {
    return part_of(arrays().objects_of(arrays_.front()->positions), arrays().objects_of(of_body.stresses_of_tets));
  }
  [[nodiscard]] Traffic traffic() const override { return on_->traffic(); }
  [[nodiscard]] std::string transport() const override { return transport_of(*on_); }
  [[nodiscard]] std::vector<std::string> unknown_kernels() const override { return unknown_kernels_of(*on_); }
  [[nodiscard]] Traffic traffic_of_iteration() override {
    (void)evaluate_now(0, load_);
    return of_body.traffic_of_iteration(*arrays_.front(), linear_, *vectors_.front(), *evaluator_,
                                        settings_.newton.preconditioner, load_);
  }

 private:
  static constexpr auto position = [](const auto& node, int k) -> double { return node.x()[k]; };
  static constexpr auto force = [](const auto& node, int k) -> double { return node.f()[k]; };
  static constexpr auto stress = [](const auto& tet, int k) -> double { return tet.P()[k]; };

  [[nodiscard]] DistributedArrays& arrays() const { return of_body.finest->arrays; }
  void require_of_first(const char* what, std::span<const Point> vectors) const {
    if (arrays().ranks().is_first()) require_vectors(what, vectors, body_.nodes);
  }
};

}  // namespace

std::unique_ptr<MotionOnRanks> make_implicit_dynamics_on_ranks(const Ranks& ranks, const std::vector<MeshLevel>& levels,
                                                               const Loading& loading, const DynamicSettings& given,
                                                               std::optional<index_t> replicated,
                                                               const DistributedOptions& options) {
  DynamicSettings settings = given;
  settings.solver.nested = false;  // equilibrium is found on the finest level alone
  return std::make_unique<ImplicitOnRanks>(ranks, WholeBody<Scene>(ranks, levels, loading, settings.solver, replicated),
                                           levels, settings, options);
}

}  // namespace physgen::fem
