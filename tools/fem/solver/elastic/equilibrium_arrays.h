// The arrays of one mesh on which equilibrium is sought, by name: in double what decides the result, in Real the
// tangent.
#pragma once

#include <fem/solver/arrays/over_groups.h>
#include <fem/solver/arrays/solver_arrays.h>
#include <fem/solver/elastic/rest_shapes.h>
#include <fem/solver/elastic/ring_arrays.h>
#include <fem/solver/elastic/tet_chunks.h>
#include <fem/solver/hierarchy/level_counts.h>
#include <fem/solver/loads/surface_arrays.h>

#include <algorithm>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace physgen::fem {

/// Those of volumes averaged over patches.
/// @tparam Group with the arrays of Patches in solver_groups.h
template <class Group>
struct PatchesOver : Group {
  RowsOf<decltype(Group::patch_tet_ranges), decltype(Group::patch_tet_entries)> patch_tets{this->patch_tet_ranges,
                                                                                           this->patch_tet_entries};
  // As TangentLists says, the other without rows.
  RowsOf<decltype(Group::edge_patch_ranges), decltype(Group::edge_patch_entries)> edge_patches{
      this->edge_patch_ranges, this->edge_patch_entries};
  RowsOf<decltype(Group::node_patch_ranges), decltype(Group::node_patch_entries)> node_patches{
      this->node_patch_ranges, this->node_patch_entries};

  explicit PatchesOver(Group&& arrays) : Group(std::move(arrays)) {}
  /// @param mesh the level's
  PatchesOver(const MeshLevel& level, const LevelCounts& mesh, const EdgeParts& parts, bool injects,
              TangentLists lists) {
    const index_t patches = mesh.patches;
    this->allocate(counts(mesh, injects, lists));
    const VolumePatches& of = level.patches;
    put_each(this->tet_patches, [&](index_t t, auto&& tet) { tet.patch() = of.tet_patch[std::size_t(t)]; });
    put_each(this->nodes, [&](index_t p, auto&& patch) {
      for (int k = 0; k < 8; ++k) patch.nodes()[k] = of.nodes[std::size_t(p)][std::size_t(k)];
    });
    put_each(this->parents, [&](index_t p, auto&& parent) { parent.patch() = level.patch_parents[std::size_t(p)]; });
    put_each(this->patch_tet_ranges, [&](index_t p, auto&& range) {
      range.begin() = of.patch_tets.first[std::size_t(p)];
      range.end() = of.patch_tets.first[std::size_t(p) + 1];
    });
    put_each(this->patch_tet_entries, [&](index_t k, auto&& entry) {
      const Index tet = of.patch_tets.entries[std::size_t(k)].element;
      const auto& slots = of.tet_slots[std::size_t(tet)];
      entry.tet() = tet;
      entry.slots() = slots[0] | slots[1] << 3 | slots[2] << 6 | slots[3] << 9;
    });
    if (lists == TangentLists::of_edges) {
      put_packed<EdgePatchEntry>(this->edge_patch_ranges, this->edge_patch_entries, parts.edge_patches, patches,
                                 "patches");
    } else if (lists == TangentLists::of_nodes) {
      put_packed<NodePatchEntry>(this->node_patch_ranges, this->node_patch_entries, make_node_patches(level), patches,
                                 "patches");
    }
  }

  [[nodiscard]] static auto counts(const LevelCounts& mesh, bool injects, TangentLists lists) {
    const bool edges = lists == TangentLists::of_edges, nodes = lists == TangentLists::of_nodes;
    return typename Group::Counts{.tet = mesh.tets,
                                  .patch = mesh.patches,
                                  .child = injects ? mesh.patch_parents : 0,
                                  .edge = edges ? mesh.edges : 0,
                                  .edge_patch = edges ? mesh.edge_patches : 0,
                                  .node = nodes ? mesh.nodes : 0,
                                  .node_patch = nodes ? mesh.node_patches : 0,
                                  .change = nodes && Group::Space::kind == SpaceKind::host ? mesh.patches : 0};
  }
};

/// @tparam Real_ of the tangent
/// @tparam Body with the arrays of Body in solver_groups.h
/// @tparam Patches PatchesOver, or NoArrays
/// @tparam Rings RingsOver, or NoArrays
/// @tparam Chunk with the arrays of Chunk in solver_groups.h
/// @tparam Surface SurfaceOver, or NoArrays
template <class Real_, class Body, class Patches, class Rings, class Chunk, class Surface = NoArrays>
struct EquilibriumOver : Body {
  using Real = Real_;
  using Own = Body;  ///< without what it may have besides

  std::vector<TetChunk> chunks;
  std::vector<MaterialRange> materials;  ///< where there are several
  Optional<Patches> patches;             ///< where volumes are averaged over them
  Optional<Rings> rings;                 ///< where volumes are averaged at nodes
  Optional<Surface> surface;             ///< where pressures follow it
  std::shared_ptr<Chunk> chunk_arrays;   ///< meshes of one solver share them; not in bytes()
  double spacing = 0;                    ///< the mean distance of neighbours at rest, or about that [m]
  RowsOf<decltype(Body::node_tet_ranges), decltype(Body::node_tet_entries)> node_tets{this->node_tet_ranges,
                                                                                      this->node_tet_entries};
  /// Where TangentLists are of edges.
  RowsOf<decltype(Body::edge_tet_ranges), decltype(Body::edge_tet_entries)> edge_tets{this->edge_tet_ranges,
                                                                                      this->edge_tet_entries};

  explicit EquilibriumOver(Body&& arrays) : Body(std::move(arrays)) {}
  /// @param injects whether equilibrium is solved on the next coarser mesh, too, whose pressures patches begin with
  /// @param lists where they are not of edges, the tangents of all tets are kept
  /// @param shared arrays of another mesh, which has as many tets at least; or none
  EquilibriumOver(const MeshLevel& level, const LevelGraph& graph, bool injects, TangentLists lists,
                  const std::shared_ptr<Chunk>& shared)
      : chunks(make_tet_chunks(level.mesh, graph.edges, most_chunk_tets(Body::Space::kind), level.material_ends)),
        materials(material_ranges(level)),
        chunk_arrays(shared),
        spacing(mean_spacing(level.mesh, level.rest)) {
    const EdgeParts parts = lists == TangentLists::of_edges ? make_edge_parts(level, graph) : EdgeParts{};
    const LevelCounts mesh = counts_of(level, graph);
    fill(level, mesh, lists, parts);
    if (mesh.patches > 0) make(patches, level, mesh, parts, injects, lists);
    if (mesh.ring_nodes > 0) make(rings, level.mesh, mesh);
    if (shared != nullptr) return;
    chunk_arrays = std::make_shared<Chunk>();
    const index_t most = std::ranges::max(chunks, {}, &TetChunk::tets).tets();
    chunk_arrays->allocate(chunk_counts(most, tet_count(), lists));
  }

  /// The bytes() of such arrays before they are made.
  [[nodiscard]] static index_t bytes_for(const LevelCounts& mesh, bool injects, TangentLists lists) {
    index_t bytes = Body::bytes(counts(mesh, lists));
    if constexpr (!std::is_same_v<Patches, NoArrays>) {
      if (mesh.patches > 0) bytes += Patches::bytes(Patches::counts(mesh, injects, lists));
    }
    if constexpr (!std::is_same_v<Rings, NoArrays>) {
      if (mesh.ring_nodes > 0) bytes += Rings::bytes(Rings::counts(mesh));
    }
    return bytes;
  }
  /// The same of chunk_arrays.
  [[nodiscard]] static index_t bytes_for_chunks(index_t tets, TangentLists lists) {
    return Chunk::bytes(chunk_counts(std::min(tets, most_chunk_tets(Body::Space::kind)), tets, lists));
  }

  [[nodiscard]] index_t nodes() const { return this->rest.size(); }
  [[nodiscard]] index_t tet_count() const { return this->tets.size(); }
  /// Calls body(m, range) for each material m.
  template <class Visit>
  void each_material(const Visit& visit) const {
    for (std::size_t m = 0; m < std::max(materials.size(), std::size_t{1}); ++m) visit(m, material_range(m));
  }
  [[nodiscard]] MaterialRange material_range(std::size_t m) const {
    return materials.empty() ? MaterialRange{0, tet_count(), 0, this->volumes.size()} : materials[m];
  }
  /// As one chunk. @pre the tangents of all tets are kept
  [[nodiscard]] TetChunk all_tets() const { return {0, tet_count(), 0, nodes(), 0, 0}; }
  [[nodiscard]] index_t bytes() const {
    return Body::bytes() + bytes_where(patches) + bytes_where(rings) + bytes_where(surface);
  }

 private:
  static auto counts(const LevelCounts& mesh, TangentLists lists) {
    const bool edges = lists == TangentLists::of_edges;
    return typename Body::Counts{.tet = mesh.tets,
                                 .node = mesh.nodes,
                                 .corner = 4 * mesh.tets,
                                 .edge = edges ? mesh.edges : 0,
                                 .tet_edge = edges ? 6 * mesh.tets : 0,
                                 .volume = mesh.ring_nodes > 0 ? mesh.nodes : mesh.patches};
  }
  static auto chunk_counts(index_t chunk, index_t tets, TangentLists lists) {
    return typename Chunk::Counts{.chunk_tet = chunk, .kept_tet = lists == TangentLists::of_edges ? chunk : tets};
  }
  void fill(const MeshLevel& level, const LevelCounts& mesh, TangentLists lists, const EdgeParts& parts) {
    const index_t tets = mesh.tets;
    this->allocate(counts(mesh, lists));
    put_each(this->tets, [&](index_t t, auto&& tet) {
      for (int k = 0; k < 4; ++k) tet.nodes()[k] = level.mesh.tets[std::size_t(t)][std::size_t(k)];
    });
    put_packed<NodeTetEntry>(this->node_tet_ranges, this->node_tet_entries, level.mesh.node_tets, tets, "tets");
    if (lists == TangentLists::of_edges) {
      put_packed<EdgeTetEntry>(this->edge_tet_ranges, this->edge_tet_entries, parts.edge_tets, tets, "tets");
    }
    put_each(this->rest, [&](index_t n, auto&& node) {
      for (int k = 0; k < 3; ++k) node.x()[k] = level.rest[std::size_t(n)][std::size_t(k)];
    });
    for (auto* positions : {&this->positions, &this->trial, &this->kept}) put(*positions, this->rest);
  }
};

}  // namespace physgen::fem
