#include <explicit_dynamics.halos.h>
#include <fem/dynamics/explicit.h>
#include <fem/dynamics/explicit_on_ranks.h>
#include <fem/dynamics/explicit_solver_of.h>
#include <fem/solver/elastic/rest_shapes.h>
#include <fem/solver/levels/listed_mesh.h>
#include <fem/solver/solvers/named_of_ranks.h>
#include <fem/solver/solvers/numbers_of_ranks.h>
#include <physgen/distributed/executor.h>
#include <physgen/error.h>

#include <iterator>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace physgen::fem {

namespace {

using On = DistributedExecutor<HostExecutor>;

/// The table of the scene, and rows of what the solver does besides.
[[nodiscard]] HaloUses table() {
  static const std::vector<HaloUse> rows = [] {
    std::vector<HaloUse> all(std::begin(scenes::explicit_dynamics_scene::halos),
                             std::end(scenes::explicit_dynamics_scene::halos));
    all.push_back({"physgen::fem::ComputeStress", 1, "P", {.writes_own = true}});
    return all;
  }();
  return rows;
}

/// What a rank has of a body in explicit dynamics.
/// @tparam Body of the scene explicit_dynamics
template <class Body>
struct PartOfExplicit {
  DistributedArrays arrays;
  Body body;
  typename ExplicitSteps<On, Body>::Stresses stresses_of_tets;

  PartOfExplicit(const Ranks& ranks, const MeshLevel& level, const Loading& loading, double density)
      : arrays(ranks, table()) {
    const PartOfLevels part = part_of_levels(std::span(&level, 1), 1, ranks.rank(), ranks.count(), false);
    const MeshLevel& here = part.levels.empty() ? level : part.levels.front();
    const ListedLevel of = part.listed.levels.front();
    add(here.mesh, of);
    arrays.cut();
    arrays.fill(body.rest.contents(), [&, shapes = host_rest_shapes(here)](index_t tet) {
      const auto shape = shapes.const_view().get(of.tets.here(tet));
      typename decltype(body.rest)::Value value{};
      value.dm_inverse = shape.dm_inverse.template cast<typename Body::Real>();
      value.volume = static_cast<typename Body::Real>(shape.volume);
      return value;
    });
    arrays.fill(body.constraints.contents(), [&](index_t node) {
      typename decltype(body.constraints)::Value value{};
      value.fixed = level.fixed[at(node)];
      return value;
    });
    arrays.fill(body.masses.contents(), [masses = lumped_masses(level.mesh, level.rest, density)](index_t node) {
      typename decltype(body.masses)::Value value{};
      value.mass = masses[at(node)];
      return value;
    });
    fill_loading(arrays, body.motion, body.loads, level.fixed, loading.motion, loading.forces);
    body.measured.resize(1);
  }

 private:
  /// Adds and connects the arrays of the body. @param mesh what this rank's lists have of the whole mesh
  void add(const TetMesh& mesh, const ListedLevel& of) {
    for (const char* set : {"node", "row"}) arrays.add_set(set, of.nodes.size);
    for (const char* set : {"tet", "gathered_tet"}) arrays.add_set(set, of.tets.size);
    arrays.same_set("row", "node");
    arrays.same_set("gathered_tet", "tet");
    arrays.follow("tet", "node");
    arrays.add("body.tets", "tet", body.tets.contents());
    arrays.add("body.rest", "tet", body.rest.contents());
    arrays.add("body.corners", "gathered_tet", body.corners);
    arrays.add("body.node_tet_ranges", "row", body.node_tet_ranges.contents());
    arrays.add("body.constraints", "node", body.constraints.contents());
    arrays.add("body.masses", "node", body.masses.contents());
    arrays.add("body.loads", "node", body.loads.contents());
    arrays.add("body.motion", "node", body.motion.contents());
    arrays.add("body.displacements", "node", body.displacements);
    arrays.add("body.rounded", "node", body.rounded);
    arrays.add("body.velocities", "node", body.velocities);
    arrays.add("body.forces", "node", body.forces);
    arrays.add("stresses.of_tets", "tet", stresses_of_tets);
    arrays.connect(body.tets.contents(), "nodes", "node", nodes_of_tets(mesh, of), of.tets.known);
    using Entry = typename decltype(body.node_tets)::Value;
    arrays.connect_rows(body.node_tet_ranges.contents(), "body.node_tets", body.node_tets.contents(), "element",
                        "gathered_tet",
                        entries_of(mesh.node_tets, of.nodes,
                                   [tets = static_cast<Index>(of.tets.offset)](const IncidenceEntry& from) {
                                     Entry entry{};
                                     entry.element = from.element + tets;
                                     entry.local = from.local;
                                     return entry;
                                   }),
                        0, of.nodes.known);
  }
};

template <class Real>
class ExplicitOnRanks final : public MotionOnRanks {
  using Body = scenes::explicit_dynamics_scene::Body<Host, Real>;

 public:
  ExplicitOnRanks(const Ranks& ranks, const MeshLevel& level, const Loading& loading, const DynamicSettings& settings,
                  const DistributedOptions& options)
      : settings_(settings),
        nodes_(level.rest.size()),
        rest_(ranks.is_first() ? level.rest : std::vector<Point>()),
        steps_(make_explicit_steps<On, Body>(settings.solver)),
        part_(ranks, level, loading, settings.density),
        on_(ranks, part_.arrays, options) {}

  NewtonResult step(double length, double load) override {
    require_step(length, load);
    steps_->step(on_, part_.body, {length, load, settings_.damping});
    time_ += length;
    load_ = load;
    return {};
  }
  [[nodiscard]] double time() const override { return time_; }
  [[nodiscard]] std::vector<Point> positions() const override {
    std::vector<Point> x = displacements();
    for (std::size_t n = 0; n < x.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) x[n][k] += rest_[n][k];
    }
    return x;
  }
  [[nodiscard]] std::vector<Point> velocities() const override {
    return of_all_ranks<3>(part_.arrays, part_.body.velocities,
                           [](const auto& node, int k) -> double { return node.v()[k]; });
  }
  void set_positions(std::span<const Point> positions) override {
    std::vector<Point> u;
    if (part_.arrays.ranks().is_first()) {
      require_vectors("the position", positions, nodes_);
      u.assign(positions.begin(), positions.end());
      for (std::size_t n = 0; n < u.size(); ++n) {
        for (std::size_t k = 0; k < 3; ++k) u[n][k] -= rest_[n][k];
      }
    }
    move_to(u);
  }
  void set_velocities(std::span<const Point> velocities) override {
    if (part_.arrays.ranks().is_first()) require_vectors("the velocity", velocities, nodes_);
    fill_from_first_rank(part_.arrays, part_.body.velocities, velocities,
                         [](auto& node, int k) -> auto& { return node.v[k]; });
  }
  [[nodiscard]] std::vector<Point> forces() override {
    compute_forces(0);
    std::vector<Point> f = of_all_ranks<3>(part_.arrays, part_.body.forces, force);
    const std::vector<Point> loads = of_all_ranks<3>(part_.arrays, part_.body.loads.contents(), force);
    for (std::size_t n = 0; n < f.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) f[n][k] += load_ * loads[n][k];
    }
    return f;
  }
  [[nodiscard]] std::vector<std::array<double, 9>> stresses() override {
    compute_stresses();
    return of_all_ranks<9>(part_.arrays, part_.stresses_of_tets, stress);
  }
  [[nodiscard]] MotionMeasure measure() override {
    steps_->measure(on_, part_.body);
    const auto found = on_.value(part_.body.measured);
    return {found.kinetic, found.elastic, {found.momentum[0], found.momentum[1], found.momentum[2]}};
  }
  [[nodiscard]] index_t bytes() const override { return part_.body.bytes() + part_.stresses_of_tets.bytes(); }

  [[nodiscard]] std::vector<Index> nodes_of_levels() const override { return {static_cast<Index>(nodes_)}; }
  [[nodiscard]] std::vector<Point> positions_of(std::size_t /*level*/, std::span<const Index> nodes) const override {
    std::vector<Point> x = named_of_ranks<3>(part_.arrays, part_.body.displacements, nodes, displacement);
    for (std::size_t i = 0; i < x.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) x[i][k] += rest_[at(nodes[i])][k];
    }
    return x;
  }
  [[nodiscard]] std::vector<Point> forces_of(std::size_t /*level*/, std::span<const Index> nodes) const override {
    std::vector<Point> f = named_of_ranks<3>(part_.arrays, part_.body.forces, nodes, force);
    const std::vector<Point> loads = named_of_ranks<3>(part_.arrays, part_.body.loads.contents(), nodes, force);
    for (std::size_t i = 0; i < f.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) f[i][k] += load_ * loads[i][k];
    }
    return f;
  }
  [[nodiscard]] std::vector<std::array<double, 9>> stresses_of(std::span<const Index> tets) const override {
    return named_of_ranks<9>(part_.arrays, part_.stresses_of_tets, tets, stress);
  }
  void compute_forces(std::size_t /*level*/) override { steps_->forces(on_, part_.body); }
  void compute_stresses() override { steps_->stresses(on_, part_.body, part_.stresses_of_tets); }

  [[nodiscard]] PartOfMesh part() const override {
    return part_of(part_.arrays.objects_of(part_.body.velocities), part_.arrays.objects_of(part_.stresses_of_tets));
  }
  [[nodiscard]] Traffic traffic() const override { return on_.traffic(); }
  [[nodiscard]] std::string transport() const override { return transport_of(on_); }
  [[nodiscard]] std::vector<std::string> unknown_kernels() const override { return unknown_kernels_of(on_); }
  [[nodiscard]] Traffic traffic_of_iteration() override {
    const std::vector<Point> u = displacements(), v = velocities();
    const TimeStep step{a_moment, load_, settings_.damping};
    Traffic before;
    for (int k = 0; k < 3; ++k) {  // fields cross more than once before ranks know what all steps read
      before = on_.traffic();
      steps_->step(on_, part_.body, step);
    }
    const Traffic sent = on_.traffic() - before;
    move_to(u);
    set_velocities(v);
    return sent;
  }

 private:
  static constexpr auto displacement = [](const auto& node, int k) -> double { return node.dx()[k]; };
  static constexpr auto force = [](const auto& node, int k) -> double { return node.f()[k]; };
  static constexpr auto stress = [](const auto& tet, int k) -> double { return tet.P()[k]; };

  static constexpr double a_moment = 1e-9;  // [s]
  DynamicSettings settings_;
  std::size_t nodes_;
  std::vector<Point> rest_;  ///< of all, on the first rank
  std::unique_ptr<ExplicitSteps<On, Body>> steps_;
  mutable PartOfExplicit<Body> part_;
  On on_;
  double time_ = 0, load_ = 0;

  [[nodiscard]] std::vector<Point> displacements() const {
    return of_all_ranks<3>(part_.arrays, part_.body.displacements, displacement);
  }
  void move_to(const std::vector<Point>& u) {
    const auto component = [](auto& node, int k) -> auto& { return node.dx[k]; };
    fill_from_first_rank(part_.arrays, part_.body.displacements, u, component);
    fill_from_first_rank(part_.arrays, part_.body.rounded, u, component);
  }
};

}  // namespace

std::unique_ptr<MotionOnRanks> make_explicit_solver_on_ranks(const Ranks& ranks, const MeshLevel& level,
                                                             const Loading& loading, const DynamicSettings& settings,
                                                             const DistributedOptions& options) {
  require_explicit_solver(level, loading, settings);
  if (settings.solver.device != Device::cpu) {
    throw Error("several ranks do not have explicit dynamics on CUDA; choose the device cpu, or solve in one process");
  }
  if (settings.solver.precision == TangentPrecision::float64) {
    return std::make_unique<ExplicitOnRanks<double>>(ranks, level, loading, settings, options);
  }
  return std::make_unique<ExplicitOnRanks<float>>(ranks, level, loading, settings, options);
}

}  // namespace physgen::fem
