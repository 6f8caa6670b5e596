#include "solver_bytes.h"

#include <fem/dynamics/explicit_body.h>
#include <fem/solver/preconditioners/all.h>
#include <fem/solver/solvers/all_arrays.h>
#include <fem/solver/solvers/in_precision.h>
#include <fem/solver/solvers/linear_body.h>
#include <fem/solver/solvers/linear_types.h>
#include <fem/solver/solvers/scene_types.h>

#include <algorithm>
#include <numeric>
#include <string>

namespace physgen::truthcube {

namespace {

/// count.operator()<Group>() of the group that an Optional is of; 0 where a program never has it.
template <class Optional, class Count>
std::int64_t bytes_if_any(const Count& count) {
  if constexpr (fem::may_have<Optional>) {
    return count.template operator()<fem::GroupOf<Optional>>();
  } else {
    return 0;
  }
}

/// The arrays that a preconditioner has beside those of the level.
template <class Types>
std::int64_t extra_bytes(const LevelCounts& c, fem::Preconditioner kind) {
  return bytes_if_any<decltype(Types::Level::extra)>([&]<class Extra> {
    return fem::with_preconditioner(kind,
                                    [&]<class Type>() { return Type::template bytes<Extra>(c.nodes, c.edges).device; });
  });
}

template <class Types>
std::int64_t plane_bytes(const LevelCounts& c, std::int64_t planes, bool solved) {
  if (planes == 0 || c.is_grid) return 0;
  return bytes_if_any<decltype(Types::Level::planes)>(
      [&]<class Planes> { return Planes::bytes(Planes::counts(c.nodes, planes, solved)); });
}

/// @param faces of this level
template <class Types>
std::int64_t surface_bytes(const LevelCounts& c, std::int64_t faces) {
  if (faces == 0) return 0;
  if constexpr (requires { Types::Arrays::surface; }) {
    return bytes_if_any<decltype(Types::Arrays::surface)>(
        [&]<class Surface> { return Surface::bytes(Surface::counts(c.nodes, c.edges, faces)); });
  } else {
    return 0;
  }
}

template <class Types>
std::int64_t inertia_bytes(const LevelCounts& c, bool solved) {
  if (c.is_grid) return 0;
  return bytes_if_any<decltype(Types::Level::inertia)>(
      [&]<class Inertia> { return Inertia::bytes(Inertia::counts(c.nodes, solved)); });
}

/// What kernels over a chunk of tets leave: on several ranks each mesh has its own, on CUDA of all of a rank's tets.
template <class Types>
std::int64_t chunk_bytes(std::int64_t tets, fem::TangentLists lists, bool on_ranks) {
  if constexpr (Types::Space::kind == SpaceKind::cuda) {
    using Chunk = typename decltype(Types::Arrays::chunk_arrays)::element_type;
    if (on_ranks) return Chunk::bytes({.chunk_tet = tets, .kept_tet = tets});
  }
  return Types::Arrays::bytes_for_chunks(tets, lists);
}

template <class Real, class Space>
RunBytes explicit_bytes(const LevelCounts& c, bool fixed_order) {
  using Body = scenes::explicit_dynamics_scene::Body<Space, Real>;
  RunBytes bytes;
  bytes.solver = Body::bytes(fem::explicit_counts<Body>(c.nodes, c.tets, fem::node_sums<Space>(fixed_order)));
  bytes.levels = {bytes.solver};
  bytes.stresses = bytes_of_array<elasticity::StressArray<Real, Space>>(c.tets);
  return bytes;
}

/// @tparam Types AllArrays, or those of a scene
template <class Types>
RunBytes bytes_with(const std::vector<LevelCounts>& levels, const fem::SolverSettings& settings,
                    const RunArrays& arrays) {
  const auto meshes =
      static_cast<std::size_t>(std::ranges::count_if(levels, [](const LevelCounts& level) { return !level.is_grid; }));
  const auto [used, solved] = fem::used_levels(settings, levels.size(), meshes);
  const bool assembled = settings.newton.product == fem::Product::assembled;
  constexpr bool linear_elastic = requires { typename Types::Body; };
  const fem::TangentLists lists = fem::tangent_lists<typename Types::Space>(settings.newton);
  const fem::Preconditioner kind = settings.newton.preconditioner.kind;
  const bool blocks = fem::asks_for(kind, fem::asks::inverses);
  RunBytes bytes;
  for (std::size_t l = 0; l < used; ++l) {
    const LevelCounts* coarser = l + 1 < used ? &levels[l + 1] : nullptr;
    const std::int64_t linear = assembled
                                    ? Types::Level::bytes_for(levels[l], coarser)
                                    : Types::Level::bytes_for(levels[l], fem::MatrixFree{blocks, coarser != nullptr});
    const auto body = [&]() -> std::int64_t {
      if constexpr (linear_elastic) {
        return Types::Body::bytes(fem::linear_counts<typename Types::Body>(levels[l], assembled));
      } else {
        return Types::Arrays::bytes_for(levels[l], l + 1 < solved, lists);
      }
    };
    const std::int64_t vectors = Types::Vectors::bytes({.node = levels[l].nodes});
    bytes.levels.push_back(
        linear + (l < solved ? body() + vectors : 0) + (l < solved ? extra_bytes<Types>(levels[l], kind) : 0) +
        plane_bytes<Types>(levels[l], arrays.planes, l < solved) +
        (l < solved ? surface_bytes<Types>(levels[l], arrays.faces >> (2 * l)) : 0) +
        (arrays.scene == SceneKind::implicit_dynamics ? inertia_bytes<Types>(levels[l], l < solved) : 0));
  }
  if constexpr (!linear_elastic) {
    for (std::size_t l = 0; l < (arrays.on_ranks ? solved : 1); ++l) {
      bytes.levels[l] += chunk_bytes<Types>(levels[l].tets, lists, arrays.on_ranks);
    }
  }
  bytes.solver = std::accumulate(bytes.levels.begin(), bytes.levels.end(), std::int64_t{0});
  bytes.stresses = bytes_of_array<elasticity::StressArray<double, typename Types::Space>>(levels.front().tets);
  return bytes;
}

template <class Space>
RunBytes bytes_on(const std::vector<LevelCounts>& levels, const fem::SolverSettings& settings,
                  const RunArrays& arrays) {
  const std::string& names = arrays.names;
#define PHYSGEN_BYTES_OF_SCENE(scene, ...) \
  if (names == #scene) return bytes_with<fem::SceneArrays<scenes::scene, Space>>(levels, settings, arrays);
  PHYSGEN_EQUILIBRIUM_SCENES(PHYSGEN_BYTES_OF_SCENE)
  PHYSGEN_IMPLICIT_SCENES(PHYSGEN_BYTES_OF_SCENE)
#undef PHYSGEN_BYTES_OF_SCENE
  return fem::in_precision(settings.precision, [&]<class Real, class Stored>() {
    if (names == "explicit_dynamics") return explicit_bytes<Real, Space>(levels.front(), arrays.fixed_order);
    if (names == "linear_elastic") return bytes_with<fem::LinearByTetsArrays<Real, Space>>(levels, settings, arrays);
    if (names == "linear_elastic_assembled") {
      return bytes_with<fem::LinearAssembledArrays<Real, Space, Stored>>(levels, settings, arrays);
    }
    return bytes_with<fem::AllArrays<Real, Space, Stored>>(levels, settings, arrays);
  });
}

}  // namespace

RunBytes solver_bytes(const std::vector<LevelCounts>& levels, const fem::SolverSettings& settings,
                      const RunArrays& arrays) {
  return settings.device == fem::Device::cuda ? bytes_on<Cuda>(levels, settings, arrays)
                                              : bytes_on<Host>(levels, settings, arrays);
}

}  // namespace physgen::truthcube
