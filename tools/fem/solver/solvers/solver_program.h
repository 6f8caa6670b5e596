// The quasistatic solver as the program of a scene: over groups of arrays that the caller has made and filled, on one
// mesh, or on several that are nested, in one material.
#pragma once

#include <fem/solver/newton/implicit_step.h>
#include <fem/solver/preconditioners/extra_arrays.h>
#include <fem/solver/solvers/nested_newton.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace physgen::fem {

namespace detail {
template <class Groups>
struct EachGroup {
  using type = Groups;
};
template <class Group>
struct EachGroup<std::vector<Group>> {
  using type = Group;
};
/// Calls body(l, group) with each, or with the one that there is.
template <class Group, class Body>
void for_each_group(Group& group, const Body& body) {
  body(std::size_t{0}, group);
}
template <class Group, class Body>
void for_each_group(std::vector<Group>& groups, const Body& body) {
  for (std::size_t l = 0; l < groups.size(); ++l) body(l, groups[l]);
}
}  // namespace detail

/// References to the groups of arrays of a scene, or to NoArrays; solver_groups.h says what is in each. Levels are one
/// group, or a vector of them, finest first, on the first of which equilibrium is solved; so are planes and inertia,
/// which then have a group for each level of a mesh.
template <class Body_, class Patches_, class Rings_, class Chunk_, class Level_, class Extra_, class Planes_,
          class Surface_, class Inertia_, class Krylov_>
struct SolverGroups {
  using Body = Body_;
  using Patches = Patches_;
  using Rings = Rings_;
  using Chunk = Chunk_;
  using Levels = Level_;
  using Level = typename detail::EachGroup<Level_>::type;
  using Extra = Extra_;
  using AllPlanes = Planes_;
  using Planes = typename detail::EachGroup<Planes_>::type;
  using Surface = Surface_;
  using Inertias = Inertia_;
  using Inertia = typename detail::EachGroup<Inertia_>::type;
  using Krylov = Krylov_;
  Body& body;
  Patches& patches;
  Rings& rings;
  Chunk& chunk;
  Levels& levels;
  Extra& extra;
  AllPlanes& planes;
  Surface& surface;
  Inertias& inertia;
  Krylov& krylov;
};

/// `Over<Group>`, or NoArrays.
template <template <class> class Over, class Group>
using OverGroup = typename std::conditional_t<std::is_same_v<Group, NoArrays>, std::type_identity<NoArrays>,
                                              std::type_identity<Over<Group>>>::type;

/// The types of a solver over a scene's groups: see SolverTypes.
/// @tparam Choices AnyChoice, or a struct of its names
template <class On, class Real_, class Stored, class Choices, class Material_, class Groups>
struct ProgramTypes {
  using Real = Real_;
  using Space = typename On::Space;
  using Patches = OverGroup<PatchesOver, typename Groups::Patches>;
  using Rings = OverGroup<RingsOver, typename Groups::Rings>;
  using Extra = OverGroup<ExtraOver, typename Groups::Extra>;
  using Planes = OverGroup<PlanesOver, typename Groups::Planes>;
  using Surface = OverGroup<SurfaceOver, typename Groups::Surface>;
  using Inertia = OverGroup<InertiaOver, typename Groups::Inertia>;
  using Arrays = EquilibriumOver<Real, typename Groups::Body, Patches, Rings, typename Groups::Chunk, Surface>;
  using Level = LevelOver<Real, Space, Stored, Choices, typename Groups::Level, Extra, Planes, Inertia>;
  using Vectors = typename Groups::Krylov;
  using Material = MaterialSteps<Material_>;
};

/// The facts that the host knows of a mesh.
struct MeshFacts {
  std::vector<TetChunk> chunks;
  std::vector<EdgeSums> sums;                  ///< of each level, where the stiffness is assembled
  std::vector<EdgeRows> rows;                  ///< of each level, of several ranks on CUDA
  ExtraFacts extra;                            ///< where a preconditioner has arrays beside those of levels
  double plane_stiffness = 0;                  ///< of rigid planes, per area [Pa/m]
  double rounding_force = 0;                   ///< see NewtonSettings
  double node_stiffness = 0;                   ///< of a node, elastic and by inertia, for bodies that move [N/m]
  std::size_t meshes = 0;                      ///< how many levels are not of a background grid; 0: all
  index_t nodes = 0;                           ///< of all ranks, for bodies that move; 0: those of the arrays
  bool moves = false, all_prescribed = false;  ///< any component or plane is moved by the load; every component is
};

/// One of the coarser meshes on which equilibrium is solved first. Its level is among those of SolverGroups, and has
/// the sums.
template <class Body, class Chunk, class Krylov>
struct CoarserMesh {
  Body body;
  Chunk chunk;
  Krylov krylov;
  MeshFacts facts;
};

/// Takes the arrays of the groups and the sums of the facts, and gives them back when it ends.
template <class On, class Types, class Groups>
class SolverProgram : private NestedNewton<On, Types> {
  using Nested = NestedNewton<On, Types>;
  using Nested::arrays_;
  using Nested::linear_;
  using Nested::on_;
  using Nested::vectors_;

 public:
  /// Those of the level below the finest first.
  using Coarser = std::vector<CoarserMesh<typename Groups::Body, typename Groups::Chunk, typename Groups::Krylov>>;

  /// @param coarser on how many coarser meshes equilibrium is solved first, without patches, rings and surface; or null
  template <class Material>
  SolverProgram(On& on, const SolverSettings& settings, const Material& material, MeshFacts& facts, Groups groups,
                Coarser* coarser = nullptr)
      : Nested(
            on, settings,
            std::make_unique<typename Types::Material>(material, averages<typename Groups::Patches>(groups.patches) ||
                                                                     averages<typename Groups::Rings>(groups.rings)),
            coarser == nullptr ? 1 : 1 + coarser->size()),
        groups_(groups),
        facts_(facts),
        coarser_(coarser) {
    take_mesh(groups.body, groups.chunk, groups.krylov, facts);
    if (coarser != nullptr) {
      for (auto& mesh : *coarser) take_mesh(mesh.body, mesh.chunk, mesh.krylov, mesh.facts);
    }
    auto& a = *arrays_.front();
    take(a.patches, groups.patches);
    take(a.rings, groups.rings);
    take(a.surface, groups.surface);
    detail::for_each_group(groups.levels, [&](std::size_t l, auto& group) {
      linear_.push_back(std::make_unique<typename Types::Level>(std::move(group)));
      auto& level = *linear_.back();
      level.is_grid = facts.meshes > 0 && l >= facts.meshes;
      level.lies_in_grid = l + 1 == facts.meshes;
      level.assembled = settings.newton.product == Product::assembled;
      if (level.assembled) level.sums = std::move(facts.sums.at(l));
    });
    auto& level = *linear_.front();
    take(level.extra, groups.extra);
    where(level.extra, [&](auto& extra) { static_cast<ExtraFacts&>(extra) = facts.extra; });
    detail::for_each_group(groups.planes, [&](std::size_t l, auto& group) {
      auto& planes = linear_.at(l)->planes;
      take(planes, group);
      where(planes, [&](auto& over) { over.per_area = facts_of(l).plane_stiffness; });
    });
    detail::for_each_group(groups.inertia, [&](std::size_t l, auto& group) { take(linear_.at(l)->inertia, group); });
    for (auto& each : linear_) {
      if (each->is_grid) break;
      require_of_each(linear_.front()->planes, each->planes, "planes");
      require_of_each(linear_.front()->inertia, each->inertia, "inertia");
    }
    this->reached_ = false;
  }
  SolverProgram(const SolverProgram&) = delete;
  SolverProgram& operator=(const SolverProgram&) = delete;
  ~SolverProgram() {
    on_->wait();
    auto& a = *arrays_.front();
    auto& level = *linear_.front();
    give_back_mesh(0, groups_.body, groups_.chunk, groups_.krylov);
    for (std::size_t k = 1; k < arrays_.size(); ++k) {
      auto& mesh = (*coarser_)[k - 1];
      give_back_mesh(k, mesh.body, mesh.chunk, mesh.krylov);
    }
    give_back(a.patches, groups_.patches);
    give_back(a.rings, groups_.rings);
    give_back(a.surface, groups_.surface);
    detail::for_each_group(groups_.planes, [&](std::size_t l, auto& group) { give_back(linear_[l]->planes, group); });
    detail::for_each_group(groups_.inertia, [&](std::size_t l, auto& group) { give_back(linear_[l]->inertia, group); });
    give_back(level.extra, groups_.extra);
    detail::for_each_group(groups_.levels, [&](std::size_t l, auto& group) {
      if (linear_[l]->assembled) facts_.sums[l] = std::move(linear_[l]->sums);
      group = std::move(static_cast<typename Groups::Level&>(*linear_[l]));
    });
  }

  using Nested::evaluate_stresses;
  using Nested::plane_contacts_of;
  using Nested::solve_to;
  using Nested::state_now;

  /// One step of backward Euler. @pre there is inertia
  NewtonResult step(const TimeStep& step) {
    auto& newton = this->settings_.newton;
    const double farthest = largest_coordinate(*on_, *arrays_.front(), *linear_.front());
    const index_t nodes = facts_.nodes > 0 ? facts_.nodes : arrays_.front()->nodes();
    newton.rounding_force = rounding_force(facts_.node_stiffness, farthest, std::size_t(nodes));
    return implicit_step(*on_, this->loops_.front(), *arrays_.front(), linear_, *vectors_.front(), *this->evaluator_,
                         this->settings_.newton, step, this->moves_.front());
  }
  /// dynamics::Motion as it is. @pre there is inertia
  [[nodiscard]] auto motion() { return measure_motion(*on_, *arrays_.front(), *linear_.front()); }

 private:
  template <class Group>
  static constexpr bool averages(const Group& /*group*/) {
    return !std::is_same_v<Group, NoArrays>;
  }
  /// Of a level; where equilibrium is not solved on it, those of the finest.
  const MeshFacts& facts_of(std::size_t l) const {
    return l > 0 && l < arrays_.size() ? (*coarser_)[l - 1].facts : facts_;
  }
  /// @throw Error when the finest level has arrays that another has not
  template <class Arrays>
  static void require_of_each(const Arrays& finest, const Arrays& of_level, const char* what) {
    if constexpr (may_have<Arrays>) {
      if ((finest == nullptr) == (of_level == nullptr)) return;
      throw Error(std::string("some levels have ") + what +
                  ", and others have none; give a group of them for each level");
    }
  }
  void take_mesh(typename Groups::Body& body, typename Groups::Chunk& chunk, typename Groups::Krylov& krylov,
                 const MeshFacts& facts) {
    arrays_.push_back(std::make_unique<typename Types::Arrays>(std::move(body)));
    arrays_.back()->chunks = facts.chunks;
    arrays_.back()->chunk_arrays = std::make_shared<typename Groups::Chunk>(std::move(chunk));
    vectors_.push_back(std::make_unique<typename Types::Vectors>(std::move(krylov)));
    this->loops_.emplace_back();
    this->rounding_forces_.push_back(facts.rounding_force);
    this->moves_.push_back(facts.moves);
    this->all_prescribed_.push_back(facts.all_prescribed);
  }
  void give_back_mesh(std::size_t l, typename Groups::Body& body, typename Groups::Chunk& chunk,
                      typename Groups::Krylov& krylov) {
    body = std::move(static_cast<typename Groups::Body&>(*arrays_[l]));
    chunk = std::move(*arrays_[l]->chunk_arrays);
    krylov = std::move(*vectors_[l]);
  }
  template <class Over, class Group>
  static void take(std::unique_ptr<Over>& to, Group& from) {
    to = std::make_unique<Over>(std::move(from));
  }
  static void take(NoArrays& /*to*/, NoArrays& /*from*/) {}
  template <class Over, class Group>
  static void give_back(std::unique_ptr<Over>& from, Group& to) {
    to = std::move(static_cast<Group&>(*from));
  }
  static void give_back(NoArrays& /*from*/, NoArrays& /*to*/) {}

  Groups groups_;
  MeshFacts& facts_;
  Coarser* coarser_;
};

/// @tparam Real of tangents
template <class Real, class Stored, class Choices, class On, class Material, class Groups>
[[nodiscard]] auto solver_program(On& on, const SolverSettings& settings, const Material& material, MeshFacts& facts,
                                  const Groups& groups) {
  return SolverProgram<On, ProgramTypes<On, Real, Stored, Choices, Material, Groups>, Groups>(on, settings, material,
                                                                                              facts, groups);
}
/// The same, which solves on coarser meshes first: where volumes are not averaged, and no pressures follow the surface.
template <class Real, class Stored, class Choices, class On, class Material, class Groups, class Mesh>
  requires(std::is_same_v<typename Groups::Patches, NoArrays> && std::is_same_v<typename Groups::Rings, NoArrays> &&
           std::is_same_v<typename Groups::Surface, NoArrays>)
[[nodiscard]] auto solver_program(On& on, const SolverSettings& settings, const Material& material, MeshFacts& facts,
                                  const Groups& groups, std::vector<Mesh>& coarser) {
  return SolverProgram<On, ProgramTypes<On, Real, Stored, Choices, Material, Groups>, Groups>(on, settings, material,
                                                                                              facts, groups, &coarser);
}

}  // namespace physgen::fem
