// The solver of equilibria on several ranks, over arrays in one space: see solver_on_ranks.h.
#pragma once

#include <fem/solver/solvers/named_of_ranks.h>
#include <fem/solver/solvers/nested_newton.h>
#include <fem/solver/solvers/numbers_of_ranks.h>
#include <fem/solver/solvers/part_of_rank.h>
#include <fem/solver/solvers/require.h>
#include <fem/solver/solvers/solver_on_ranks.h>

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace physgen::fem {

/// @tparam On DistributedExecutor @tparam Scene of a row of PHYSGEN_EQUILIBRIUM_SCENES, or EverythingOnRanks
template <class On, class Scene = scenes::quasistatic>
class QuasistaticOnRanks final : public SolverOnRanks,
                                 private detail::PartOfRank<On, Scene>,
                                 private NestedNewton<On, typename QuasistaticMesh<typename On::Space, Scene>::Types> {
  using Types = typename QuasistaticMesh<typename On::Space, Scene>::Types;
  using PartOfRank = detail::PartOfRank<On, Scene>;
  using Nested = NestedNewton<On, Types>;
  using Nested::arrays_;
  using Nested::coarser_load_;
  using Nested::evaluate_now;
  using Nested::evaluator_;
  using Nested::last_reaction_;
  using Nested::linear_;
  using Nested::load_;
  using Nested::plane_contacts_of;
  using Nested::reached_;
  using Nested::settings_;
  using Nested::solved_;
  using Nested::state_now;
  using Nested::vectors_;
  using PartOfRank::coarser;
  using PartOfRank::finest;
  using PartOfRank::on;
  using PartOfRank::stresses_of_tets;
  using typename Nested::Level;
  using typename PartOfRank::Mesh;

 public:
  QuasistaticOnRanks(const Ranks& ranks, WholeBody<Scene> whole, const SolverSettings& settings,
                     const DistributedOptions& options)
      : PartOfRank(ranks, whole, options),
        Nested(*PartOfRank::on, settings, Types::make_material(settings, whole.body.volumes.size() > 0),
               1 + whole.coarser.size()),
        is_first_(ranks.is_first()),
        fixed_(std::move(whole.fixed)),
        parents_(std::move(whole.parents)) {
    Nested::take(*finest);
    for (Mesh& mesh : coarser) Nested::take(mesh);
    Nested::take_levels(*finest);
    for (std::size_t l = 0; l < linear_.size(); ++l) {
      linear_[l]->is_grid = whole.graphs[l].is_grid;
      linear_[l]->lies_in_grid = !whole.graphs[l].grid_parents.empty();
    }
    if constexpr (may_have<decltype(Level::planes)>) {
      for (std::size_t l = 0; l < PartOfRank::planes.size(); ++l) {
        linear_[l]->planes = std::make_unique<GroupOf<decltype(Level::planes)>>(std::move(PartOfRank::planes[l]));
        if (l <= coarser.size())
          linear_[l]->planes->per_area = (l == 0 ? finest->facts : coarser[l - 1].facts).plane_stiffness;
      }
      has_planes_ = !PartOfRank::planes.empty();
    }
    reached_ = !has_planes_;  // planes may push at rest
  }

  NewtonResult solve_to(double load, const std::function<void(std::size_t, const NewtonStep&)>& report) override {
    return Nested::solve_to(load, report);
  }
  void set_loading(const Loading& loading) override {
    require_next_loading(loading, fixed_.front().size(), has_planes_, {});
    std::vector<Point> motion = loading.motion, forces = loading.forces;
    for (std::size_t l = 0; l < arrays_.size(); ++l) {
      fill_loading(finest->arrays, arrays_[l]->motion, arrays_[l]->loads, fixed_[l], motion, forces);
      if (l + 1 < arrays_.size()) {
        coarsen_loading(parents_[l], static_cast<Index>(fixed_[l + 1].size()), motion, forces);
      }
    }
    reached_ = false;
  }
  [[nodiscard]] double load() const override { return load_; }
  [[nodiscard]] std::vector<Point> positions() const override { return all_positions(0); }
  [[nodiscard]] std::vector<Point> forces() override {
    compute_forces(0);
    return all_forces(0);
  }
  [[nodiscard]] std::optional<NodeState> coarser_equilibrium() override {
    const auto contacts = coarser_contacts();
    if (!contacts) return std::nullopt;
    compute_forces(1);
    return NodeState{all_positions(1), all_forces(1), *contacts};
  }
  [[nodiscard]] std::vector<std::array<double, 9>> stresses() override {
    compute_stresses();
    return of_all_ranks<9>(stresses_of_tets, stress);
  }
  [[nodiscard]] std::vector<PlaneContact> plane_contacts() override { return plane_contacts_of(0); }
  [[nodiscard]] index_t bytes() const override {
    index_t sum = stresses_of_tets.bytes();
    for (const auto& level : linear_) sum += level->bytes();
    for (const auto& arrays : arrays_) sum += arrays->bytes() + arrays->chunk_arrays->bytes();
    for (const auto& vectors : vectors_) sum += vectors->bytes();
    return sum;
  }

  [[nodiscard]] SolverState state() const override {
    SolverState state;
    state.load = load_;
    state.is_equilibrium = reached_;
    for (std::size_t l = 0; l < arrays_.size(); ++l) state.positions.push_back(all_positions(l));
    return state;
  }
  void restore(const SolverState& state) override {
    const std::vector<Index> nodes = nodes_of_levels();
    if (is_first_) require_state(state, std::vector<std::size_t>(nodes.begin(), nodes.end()));
    for (std::size_t l = 0; l < arrays_.size(); ++l) {
      const auto positions = is_first_ ? std::span(state.positions[l]) : std::span<const Point>();
      for (auto* array : {&arrays_[l]->positions, &arrays_[l]->kept}) {
        fill_from_first_rank(finest->arrays, *array, positions, [](auto& node, int k) -> auto& { return node.x[k]; });
      }
    }
    load_ = state.load;
    reached_ = state.is_equilibrium;
    coarser_load_ = reached_ ? load_ : std::numeric_limits<double>::quiet_NaN();
    last_reaction_ = reached_ ? state_now().reaction : 0.0;
  }

  [[nodiscard]] std::vector<Index> nodes_of_levels() const override {
    std::vector<Index> nodes;
    for (const auto& a : arrays_) nodes.push_back(static_cast<Index>(objects_of(a->rest.contents()).runs().size()));
    return nodes;
  }
  [[nodiscard]] std::vector<Point> positions_of(std::size_t level, std::span<const Index> nodes) const override {
    return of_named<3>(arrays_.at(level)->positions, nodes, position);
  }
  [[nodiscard]] std::vector<Point> forces_of(std::size_t level, std::span<const Index> nodes) const override {
    return of_named<3>(arrays_.at(level)->forces, nodes, force);
  }
  [[nodiscard]] std::vector<std::array<double, 9>> stresses_of(std::span<const Index> tets) const override {
    return of_named<9>(stresses_of_tets, tets, stress);
  }
  void compute_forces(std::size_t level) override { (void)evaluate_now(level, load_); }
  [[nodiscard]] std::optional<std::vector<PlaneContact>> coarser_contacts() override {
    if (solved_ < 2 || coarser_load_ != load_ || !reached_) return std::nullopt;
    return plane_contacts_of(1);
  }
  void compute_stresses() override { Nested::evaluate_stresses(load_, stresses_of_tets); }

  [[nodiscard]] PartOfMesh part() const override {
    return part_of(objects_of(arrays_.front()->positions), objects_of(stresses_of_tets));
  }
  [[nodiscard]] Traffic traffic() const override { return on->traffic(); }
  [[nodiscard]] std::string transport() const override { return transport_of(*on); }
  [[nodiscard]] std::vector<std::string> unknown_kernels() const override { return unknown_kernels_of(*on); }
  [[nodiscard]] Traffic traffic_of_iteration() override {
    (void)evaluate_now(0, load_);
    return PartOfRank::traffic_of_iteration(*arrays_.front(), linear_, *vectors_.front(), *evaluator_,
                                            settings_.newton.preconditioner, load_);
  }

 private:
  static constexpr auto position = [](const auto& node, int k) -> double { return node.x()[k]; };
  static constexpr auto force = [](const auto& node, int k) -> double { return node.f()[k]; };
  static constexpr auto stress = [](const auto& tet, int k) -> double { return tet.P()[k]; };

  bool is_first_, has_planes_ = false;
  // Of all nodes of each mesh, as WholeBody has them.
  std::vector<std::vector<std::uint8_t>> fixed_;
  std::vector<std::vector<std::array<Index, 2>>> parents_;

  template <class Array>
  [[nodiscard]] const LocalSet& objects_of(const Array& array) const {
    return finest->arrays.objects_of(array);
  }
  [[nodiscard]] std::vector<Point> all_positions(std::size_t level) const {
    return of_all_ranks<3>(arrays_[level]->positions, position);
  }
  [[nodiscard]] std::vector<Point> all_forces(std::size_t level) const {
    return of_all_ranks<3>(arrays_[level]->forces, force);
  }
  template <std::size_t kCount, class Array, class Element>
  [[nodiscard]] std::vector<std::array<double, kCount>> of_all_ranks(const Array& array, const Element& element) const {
    on->wait();
    return fem::of_all_ranks<kCount>(finest->arrays, array, element);
  }
  template <std::size_t kCount, class Array, class Element>
  [[nodiscard]] std::vector<std::array<double, kCount>> of_named(const Array& array, std::span<const Index> named,
                                                                 const Element& element) const {
    on->wait();
    return named_of_ranks<kCount>(finest->arrays, array, named, element);
  }
};

}  // namespace physgen::fem
