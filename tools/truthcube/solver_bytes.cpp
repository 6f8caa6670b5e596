#include "solver_bytes.h"

#include <fem/dynamics/explicit_body.h>
#include <fem/solver/conjugate_gradients.h>
#include <fem/solver/equilibrium_arrays.h>
#include <fem/solver/linear_body.h>
#include <fem/solver/linear_level.h>

#include <algorithm>
#include <numeric>

namespace physgen::truthcube {

namespace {

template <class Array>
std::int64_t bytes_of(std::int64_t objects) {
  return fem::LayoutOf<Array>::padded(objects) * Array::record_bytes;
}
template <class Rows>
std::int64_t bytes_of_rows(std::int64_t rows, std::int64_t entries) {
  return bytes_of<typename Rows::Ranges>(rows) + bytes_of<typename Rows::Entries>(entries);
}

/// As LinearLevel::bytes().
template <class Real, class Space, class Stored>
std::int64_t linear_bytes(const LevelCounts& c, const LevelCounts* coarser) {
  using Level = fem::LinearLevel<Real, Space, Stored>;
  const std::int64_t n = c.nodes;
  // EdgeSums, which on CUDA holds nothing, and EdgeSlices.
  std::int64_t sums = 0;
  if (Space::kind == SpaceKind::host) {
    sums = (2 * (n + 1) + c.edges) * std::int64_t{sizeof(fem::Index)} +
           c.edges * std::int64_t{sizeof(fem::Contribution<Real>)};
  } else if (n <= fem::EdgeSlices::most_nodes) {
    sums = fem::EdgeSlices::bytes_for(n, c.edges);
  }
  std::int64_t bytes = bytes_of<decltype(Level::constraints)>(n) + bytes_of<decltype(Level::edges)>(c.edges) +
                       bytes_of_rows<decltype(Level::node_edges)>(n, 2 * c.edges) +
                       bytes_of<decltype(Level::node_stiffness)>(n) +
                       bytes_of<decltype(Level::edge_stiffness)>(c.edges) + bytes_of<decltype(Level::scales)>(n) +
                       bytes_of<decltype(Level::scaled_nodes)>(n) + bytes_of<decltype(Level::scaled_edges)>(c.edges) +
                       bytes_of<decltype(Level::inverse)>(n) + bytes_of<decltype(Level::smoother)>(1) +
                       bytes_of<decltype(Level::residual)>(n) + bytes_of<decltype(Level::correction)>(n) +
                       bytes_of<decltype(Level::direction)>(n) + bytes_of<decltype(Level::power)>(n) +
                       bytes_of<decltype(Level::translations)>(c.tets == 0 ? n : c.grid_parents) + sums;
  if (coarser == nullptr) {
    return bytes + (n <= fem::most_coarse_nodes ? bytes_of<decltype(Level::coarse_inverse)>(n * n) : 0);
  }
  bytes += bytes_of<decltype(Level::parents)>(n - c.grid_parents);
  bytes += bytes_of<decltype(Level::grid_parents)>(c.grid_parents);
  bytes += bytes_of_rows<decltype(Level::children)>(coarser->nodes, c.children);
  return bytes + bytes_of_rows<decltype(Level::edge_terms)>(coarser->edges, c.edge_terms);
}

/// As LinearLevel::bytes() of one whose stiffness is not assembled.
template <class Real, class Space, class Stored>
std::int64_t matrix_free_bytes(const LevelCounts& c, fem::MatrixFree needs) {
  using Level = fem::LinearLevel<Real, Space, Stored>;
  const std::int64_t n = c.nodes;
  return bytes_of<decltype(Level::constraints)>(n) + bytes_of<decltype(Level::scales)>(n) +
         bytes_of<decltype(Level::residual)>(n) + bytes_of<decltype(Level::correction)>(n) +
         (needs.blocks ? bytes_of<decltype(Level::node_stiffness)>(n) + bytes_of<decltype(Level::inverse)>(n) : 0) +
         (needs.coarser ? bytes_of<decltype(Level::parents)>(n) : 0);
}

/// As SchwarzArrays::bytes(), from above: blocks follow a curve through the nodes, so their number is not known before;
/// what stands here of supernodes and edges is what cubes have.
template <class Real, class Space, class Stored>
std::int64_t schwarz_bytes(const LevelCounts& c) {
  using Arrays = typename decltype(fem::LinearLevel<Real, Space, Stored>::schwarz)::element_type;
  const std::int64_t blocks = (c.nodes + fem::schwarz_slots - 1) / fem::schwarz_slots;  // if none were prescribed
  const std::int64_t coarse = blocks > 1 ? 1 + blocks / 18 : 0, all = blocks + coarse;
  const std::int64_t supernodes = fem::schwarz_slots * coarse, pairs = supernodes * c.edges / c.nodes;
  const std::int64_t inside = c.edges * 9 / 20, between = c.edges - inside;
  return bytes_of<decltype(Arrays::nodes)>(c.nodes) + bytes_of<decltype(Arrays::slots)>(fem::schwarz_slots * all) +
         bytes_of<decltype(Arrays::blocks)>(all) +
         bytes_of_rows<decltype(Arrays::supernode_terms)>(supernodes, c.nodes + inside) +
         bytes_of_rows<decltype(Arrays::pair_terms)>(pairs, between) +
         bytes_of_rows<decltype(Arrays::block_edges)>(all, inside) +
         bytes_of<decltype(Arrays::supernodes)>(supernodes) + bytes_of<decltype(Arrays::pair_stiffness)>(pairs) +
         bytes_of<decltype(Arrays::residual)>(supernodes) + bytes_of<decltype(Arrays::correction)>(supernodes) +
         bytes_of<decltype(Arrays::factors)>(fem::schwarz_factors * all);
}

/// As EquilibriumArrays::bytes() and KrylovVectors::bytes().
template <class Real, class Space>
std::int64_t equilibrium_bytes(const LevelCounts& c, bool injects, fem::TangentLists lists) {
  using Arrays = fem::EquilibriumArrays<Real, Space>;
  using Patches = fem::PatchArrays<Real, Space>;
  using Vectors = fem::KrylovVectors<Real, Space>;
  const std::int64_t n = c.nodes;
  std::int64_t bytes = bytes_of<decltype(Arrays::tets)>(c.tets) +
                       bytes_of_rows<decltype(Arrays::node_tets)>(n, 4 * c.tets) + bytes_of<decltype(Arrays::rest)>(n) +
                       bytes_of<decltype(Arrays::positions)>(n) + bytes_of<decltype(Arrays::trial)>(n) +
                       bytes_of<decltype(Arrays::kept)>(n) + bytes_of<decltype(Arrays::loads)>(n) +
                       bytes_of<decltype(Arrays::motion)>(n) + bytes_of<decltype(Arrays::forces)>(n) +
                       bytes_of<decltype(Arrays::trial_forces)>(n) + bytes_of<decltype(Arrays::increment)>(n) +
                       bytes_of<decltype(Arrays::state)>(1);
  bytes += bytes_of<decltype(Vectors::step)>(n) + bytes_of<decltype(Vectors::residual)>(n) +
           bytes_of<decltype(Vectors::direction)>(n) + bytes_of<decltype(Vectors::product)>(n) +
           bytes_of<decltype(Vectors::state)>(1);
  const bool edges = lists == fem::TangentLists::of_edges;
  if (edges) bytes += bytes_of_rows<decltype(Arrays::edge_tets)>(c.edges, 6 * c.tets);
  if (c.ring_nodes > 0) {
    using Rings = fem::RingArrays<Real, Space>;
    return bytes + bytes_of_rows<typename Rings::Rows>(n, c.ring_nodes) + bytes_of<decltype(Rings::tangent)>(n) +
           bytes_of<decltype(Arrays::volumes)>(n);
  }
  if (c.patches == 0) return bytes;
  if (edges) bytes += bytes_of_rows<decltype(Patches::edge_patches)>(c.edges, c.edge_patches);
  if (lists == fem::TangentLists::of_nodes) {
    bytes += bytes_of_rows<decltype(Patches::node_patches)>(n, c.node_patches);
    if (Space::kind == SpaceKind::host) bytes += bytes_of<decltype(Patches::changes)>(c.patches);
  }
  bytes += bytes_of<decltype(Patches::tet_patches)>(c.tets) + bytes_of<decltype(Patches::nodes)>(c.patches) +
           bytes_of_rows<decltype(Patches::patch_tets)>(c.patches, c.tets) +
           bytes_of<decltype(Arrays::volumes)>(c.patches) + bytes_of<decltype(Patches::tangent)>(c.patches);
  return bytes + (injects ? bytes_of<decltype(Patches::parents)>(c.patches) : 0);
}

/// As ChunkArrays::bytes().
template <class Real, class Space>
std::int64_t chunk_bytes(const LevelCounts& finest, bool assembled) {
  using Arrays = fem::ChunkArrays<Real, Space>;
  const std::int64_t chunk = std::min(finest.tets, std::int64_t{fem::most_chunk_tets(Space::kind)});
  return bytes_of<decltype(Arrays::corners)>(chunk) +
         bytes_of<decltype(Arrays::tangent)>(assembled ? chunk : finest.tets);
}

/// As PlaneArrays::bytes().
template <class Real, class Space>
std::int64_t plane_bytes(const LevelCounts& c, std::int64_t planes, bool solved) {
  using Planes = fem::PlaneArrays<Real, Space>;
  if (planes == 0 || c.tets == 0) return 0;  // or of a background grid
  const std::int64_t bytes = bytes_of<decltype(Planes::stiffness)>(c.nodes);
  return !solved ? bytes
                 : bytes + bytes_of<decltype(Planes::areas)>(c.nodes) + bytes_of<decltype(Planes::planes)>(planes) +
                       bytes_of<decltype(Planes::contact)>(1);
}

/// As InertiaArrays::bytes().
template <class Space>
std::int64_t inertia_bytes(const LevelCounts& c, bool solved) {
  using Arrays = fem::InertiaArrays<Space>;
  if (c.tets == 0) return 0;  // of a background grid
  const std::int64_t bytes = bytes_of<decltype(Arrays::masses)>(c.nodes);
  return !solved ? bytes
                 : bytes + bytes_of<decltype(Arrays::centres)>(c.nodes) +
                       bytes_of<decltype(Arrays::velocities)>(c.nodes) + bytes_of<decltype(Arrays::measured)>(1);
}

/// As LinearBody::bytes() and KrylovVectors::bytes().
template <class Real, class Space>
std::int64_t linear_body_bytes(const LevelCounts& c, bool assembled) {
  using Body = fem::LinearBody<Real, Space>;
  using Vectors = fem::KrylovVectors<Real, Space>;
  const std::int64_t n = c.nodes;
  return bytes_of<decltype(Body::tets)>(c.tets) + bytes_of<decltype(Body::rest)>(c.tets) +
         bytes_of<decltype(Body::node_tet_ranges)>(n) + bytes_of<decltype(Body::node_tets)>(4 * c.tets) +
         (assembled
              ? bytes_of<decltype(Body::edge_tet_ranges)>(c.edges) + bytes_of<decltype(Body::edge_tets)>(6 * c.tets)
              : 0) +
         bytes_of<decltype(Body::displacements)>(n) + bytes_of<decltype(Body::motion)>(n) +
         bytes_of<decltype(Body::loads)>(n) + bytes_of<decltype(Body::forces)>(n) + bytes_of<decltype(Body::state)>(1) +
         bytes_of<decltype(Vectors::step)>(n) + bytes_of<decltype(Vectors::residual)>(n) +
         bytes_of<decltype(Vectors::direction)>(n) + bytes_of<decltype(Vectors::product)>(n) +
         bytes_of<decltype(Vectors::state)>(1);
}

template <class Real, class Space>
RunBytes explicit_bytes(const LevelCounts& c) {
  using Body = scenes::explicit_dynamics_scene::Body<Space, Real>;
  RunBytes bytes;
  bytes.solver = Body::bytes(fem::explicit_counts<Body>(c.nodes, c.tets));
  bytes.levels = {bytes.solver};
  bytes.stresses = bytes_of<elasticity::StressArray<Real, Space>>(c.tets);
  return bytes;
}

template <class Real, class Space, class Stored>
RunBytes bytes_in(const std::vector<LevelCounts>& levels, const fem::SolverSettings& settings, std::int64_t planes,
                  SceneKind scene) {
  const auto meshes = static_cast<std::size_t>(
      std::ranges::count_if(levels, [](const LevelCounts& level) { return level.tets > 0; }));  // the rest are grids
  const auto [used, solved] = fem::used_levels(settings, levels.size(), meshes);
  const bool assembled = settings.newton.product == fem::Product::assembled;
  const bool linear_elastic = scene == SceneKind::linear_elastic;
  const fem::TangentLists lists = fem::tangent_lists<Space>(settings.newton);
  const bool blocks = settings.newton.preconditioner.kind != fem::Preconditioner::none;
  const bool schwarz = settings.newton.preconditioner.kind == fem::Preconditioner::schwarz;
  RunBytes bytes;
  for (std::size_t l = 0; l < used; ++l) {
    const std::int64_t linear =
        assembled ? linear_bytes<Real, Space, Stored>(levels[l], l + 1 < used ? &levels[l + 1] : nullptr)
                  : matrix_free_bytes<Real, Space, Stored>(levels[l], {blocks, l + 1 < used});
    const auto body = [&] {
      return linear_elastic ? linear_body_bytes<Real, Space>(levels[l], assembled)
                            : equilibrium_bytes<Real, Space>(levels[l], l + 1 < solved, lists);
    };
    bytes.levels.push_back(linear + (l < solved ? body() : 0) +
                           (l < solved && schwarz ? schwarz_bytes<Real, Space, Stored>(levels[l]) : 0) +
                           plane_bytes<Real, Space>(levels[l], planes, l < solved) +
                           (scene == SceneKind::implicit_dynamics ? inertia_bytes<Space>(levels[l], l < solved) : 0));
  }
  if (!linear_elastic) bytes.levels.front() += chunk_bytes<Real, Space>(levels.front(), assembled);
  bytes.solver = std::accumulate(bytes.levels.begin(), bytes.levels.end(), std::int64_t{0});
  bytes.stresses = bytes_of<elasticity::StressArray<double, Space>>(levels.front().tets);
  return bytes;
}

template <class Space>
RunBytes bytes_in(const std::vector<LevelCounts>& levels, const fem::SolverSettings& settings, std::int64_t planes,
                  SceneKind scene) {
  if (scene == SceneKind::explicit_dynamics) {
    return settings.precision == fem::TangentPrecision::float64 ? explicit_bytes<double, Space>(levels.front())
                                                                : explicit_bytes<float, Space>(levels.front());
  }
  switch (settings.precision) {
    case fem::TangentPrecision::half:
      return bytes_in<float, Space, fem::StoredInHalf>(levels, settings, planes, scene);
    case fem::TangentPrecision::float32:
      return bytes_in<float, Space, fem::StoredAsComputed>(levels, settings, planes, scene);
    case fem::TangentPrecision::float64:
      break;
  }
  return bytes_in<double, Space, fem::StoredAsComputed>(levels, settings, planes, scene);
}

}  // namespace

RunBytes solver_bytes(const std::vector<LevelCounts>& levels, const fem::SolverSettings& settings, std::int64_t planes,
                      SceneKind scene) {
  return settings.device == fem::Device::cuda ? bytes_in<Cuda>(levels, settings, planes, scene)
                                              : bytes_in<Host>(levels, settings, planes, scene);
}

}  // namespace physgen::truthcube
