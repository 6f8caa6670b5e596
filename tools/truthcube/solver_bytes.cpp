#include "solver_bytes.h"

#include <fem/dynamics/explicit_body.h>
#include <fem/solver/preconditioners/all.h>
#include <fem/solver/solvers/all_arrays.h>
#include <fem/solver/solvers/in_precision.h>
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

/// As LevelOver::bytes(), of arrays and the lists of products. @tparam Types AllArrays, or those of a scene
template <class Types>
std::int64_t level_bytes(const LevelCounts& c, const LevelCounts* coarser) {
  using Level = typename Types::Level;
  const std::int64_t n = c.nodes;
  // EdgeSums, which on CUDA holds nothing, and EdgeRows, with each block of an edge twice.
  std::int64_t sums = 0;
  if (Types::Space::kind == SpaceKind::host) {
    sums = (2 * (n + 1) + c.edges) * std::int64_t{sizeof(fem::Index)} +
           c.edges * std::int64_t{sizeof(fem::Contribution<typename Types::Real>)};
  } else if (n <= fem::EdgeRows::most_nodes) {
    using Blocks = decltype(Level::scaled_edges);
    sums = fem::EdgeRows::bytes_for(n, c.edges) + bytes_of_array<Blocks>(2 * c.edges) - bytes_of_array<Blocks>(c.edges);
  }
  const bool last = coarser == nullptr;
  return sums + Level::Own::bytes({.node = n,
                                   .edge = c.edges,
                                   .edge_node = n,
                                   .edge_end = 2 * c.edges,
                                   .block_node = n,
                                   .smoother = 1,
                                   .child = last ? 0 : n - c.grid_parents,
                                   .grid_child = last ? 0 : c.grid_parents,
                                   .parent = last ? 0 : coarser->nodes,
                                   .child_entry = last ? 0 : c.children,
                                   .coarse_edge = last ? 0 : coarser->edges,
                                   .edge_term = last ? 0 : c.edge_terms,
                                   .grid_node = c.tets == 0 ? n : c.grid_parents,
                                   .coarse_pair = last && n <= fem::most_coarse_nodes ? n * n : 0});
}

/// The same of one whose stiffness is not assembled.
template <class Types>
std::int64_t matrix_free_bytes(const LevelCounts& c, fem::MatrixFree needs) {
  return Types::Level::Own::bytes(
      {.node = c.nodes, .block_node = needs.blocks ? c.nodes : 0, .child = needs.coarser ? c.nodes : 0});
}

/// The arrays that a preconditioner has beside those of the level.
template <class Types>
std::int64_t extra_bytes(const LevelCounts& c, fem::Preconditioner kind) {
  return bytes_if_any<decltype(Types::Level::extra)>([&]<class Extra> {
    return fem::with_preconditioner(kind,
                                    [&]<class Type>() { return Type::template bytes<Extra>(c.nodes, c.edges).device; });
  });
}

/// As EquilibriumOver::bytes().
template <class Types>
std::int64_t equilibrium_bytes(const LevelCounts& c, bool injects, fem::TangentLists lists) {
  using Arrays = typename Types::Arrays;
  const std::int64_t n = c.nodes;
  const bool edges = lists == fem::TangentLists::of_edges, nodes = lists == fem::TangentLists::of_nodes;
  const bool rings = c.ring_nodes > 0, patches = !rings && c.patches > 0;
  std::int64_t bytes = Arrays::Own::bytes({.tet = c.tets,
                                           .node = n,
                                           .corner = 4 * c.tets,
                                           .edge = edges ? c.edges : 0,
                                           .tet_edge = edges ? 6 * c.tets : 0,
                                           .volume = rings ? n : c.patches});
  if (rings) {
    bytes += bytes_if_any<decltype(Arrays::rings)>(
        [&]<class Rings> { return Rings::bytes({.node = n, .neighbour = c.ring_nodes}); });
  }
  if (!patches) return bytes;
  return bytes + bytes_if_any<decltype(Arrays::patches)>([&]<class Patches> {
           return Patches::bytes({.tet = c.tets,
                                  .patch = c.patches,
                                  .child = injects ? c.patches : 0,
                                  .edge = edges ? c.edges : 0,
                                  .edge_patch = edges ? c.edge_patches : 0,
                                  .node = nodes ? n : 0,
                                  .node_patch = nodes ? c.node_patches : 0,
                                  .change = nodes && Types::Space::kind == SpaceKind::host ? c.patches : 0});
         });
}

template <class Types>
std::int64_t chunk_bytes(const LevelCounts& finest, bool assembled) {
  const std::int64_t chunk = std::min(finest.tets, std::int64_t{fem::most_chunk_tets(Types::Space::kind)});
  return fem::GroupOf<decltype(Types::Arrays::chunk_arrays)>::bytes(
      {.chunk_tet = chunk, .kept_tet = assembled ? chunk : finest.tets});
}

template <class Types>
std::int64_t plane_bytes(const LevelCounts& c, std::int64_t planes, bool solved) {
  if (planes == 0 || c.tets == 0) return 0;  // or of a background grid
  return bytes_if_any<decltype(Types::Level::planes)>([&]<class Planes> {
    return solved ? Planes::bytes({.plane = planes, .surface_node = c.nodes, .node = c.nodes, .contact = 1})
                  : Planes::bytes({.node = c.nodes});
  });
}

template <class Types>
std::int64_t inertia_bytes(const LevelCounts& c, bool solved) {
  if (c.tets == 0) return 0;  // of a background grid
  return bytes_if_any<decltype(Types::Level::inertia)>([&]<class Inertia> {
    return Inertia::bytes({.node = c.nodes, .moving_node = solved ? c.nodes : 0, .measure = solved ? 1 : 0});
  });
}

template <class Types>
std::int64_t linear_body_bytes(const LevelCounts& c, bool assembled) {
  return Types::Body::bytes({.tet = c.tets,
                             .node = c.nodes,
                             .corner = 4 * c.tets,
                             .edge = assembled ? c.edges : 0,
                             .tet_edge = assembled ? 6 * c.tets : 0});
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
  const auto meshes = static_cast<std::size_t>(
      std::ranges::count_if(levels, [](const LevelCounts& level) { return level.tets > 0; }));  // the rest are grids
  const auto [used, solved] = fem::used_levels(settings, levels.size(), meshes);
  const bool assembled = settings.newton.product == fem::Product::assembled;
  constexpr bool linear_elastic = requires { typename Types::Body; };
  const fem::TangentLists lists = fem::tangent_lists<typename Types::Space>(settings.newton);
  const fem::Preconditioner kind = settings.newton.preconditioner.kind;
  const bool blocks = fem::asks_for(kind, fem::asks::inverses);
  RunBytes bytes;
  for (std::size_t l = 0; l < used; ++l) {
    const std::int64_t linear = assembled ? level_bytes<Types>(levels[l], l + 1 < used ? &levels[l + 1] : nullptr)
                                          : matrix_free_bytes<Types>(levels[l], {blocks, l + 1 < used});
    const auto body = [&]() -> std::int64_t {
      if constexpr (linear_elastic) {
        return linear_body_bytes<Types>(levels[l], assembled);
      } else {
        return equilibrium_bytes<Types>(levels[l], l + 1 < solved, lists);
      }
    };
    const std::int64_t vectors = Types::Vectors::bytes({.node = levels[l].nodes});
    bytes.levels.push_back(
        linear + (l < solved ? body() + vectors : 0) + (l < solved ? extra_bytes<Types>(levels[l], kind) : 0) +
        plane_bytes<Types>(levels[l], arrays.planes, l < solved) +
        (arrays.scene == SceneKind::implicit_dynamics ? inertia_bytes<Types>(levels[l], l < solved) : 0));
  }
  if constexpr (!linear_elastic) bytes.levels.front() += chunk_bytes<Types>(levels.front(), assembled);
  bytes.solver = std::accumulate(bytes.levels.begin(), bytes.levels.end(), std::int64_t{0});
  bytes.stresses = bytes_of_array<elasticity::StressArray<double, typename Types::Space>>(levels.front().tets);
  return bytes;
}

template <class Space>
RunBytes bytes_on(const std::vector<LevelCounts>& levels, const fem::SolverSettings& settings,
                  const RunArrays& arrays) {
  const std::string& names = arrays.names;
  if (names == "quasistatic") return bytes_with<fem::QuasistaticArrays<Space>>(levels, settings, arrays);
  if (names == "quasistatic_matrix_free") return bytes_with<fem::MatrixFreeArrays<Space>>(levels, settings, arrays);
  if (names == "quasistatic_fixed_corotated") {
    return bytes_with<fem::FixedCorotatedArrays<Space>>(levels, settings, arrays);
  }
  if (names == "implicit_dynamics") return bytes_with<fem::ImplicitDynamicsArrays<Space>>(levels, settings, arrays);
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
