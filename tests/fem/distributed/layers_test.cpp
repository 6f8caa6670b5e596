// What ranks have lists of: the rows that a rank knows of the layers of a box are those of the whole.
#include <fem/solver/hierarchy/cube_levels.h>
#include <fem/solver/hierarchy/galerkin_block.h>
#include <fem/solver/hierarchy/hierarchy.h>
#include <fem/solver/levels/layers_of_levels.h>
#include <gtest/gtest.h>
#include <physgen/distributed/runs.h>
#include <physgen/error.h>

#include <random>
#include <string>
#include <utility>

namespace physgen::fem {
namespace {

std::size_t at(index_t i) { return static_cast<std::size_t>(i); }

/// Those of known objects. @param before before(local) is what to add to the element of an entry
template <class Before>
void expect_rows(const char* name, const IncidenceList& part, const IncidenceList& whole, const ListedObjects& rows,
                 const Before& before) {
  const index_t first = rows.known.first, last = std::min(rows.known.last, rows.size);
  ASSERT_EQ(static_cast<index_t>(whole.first.size()), rows.size + 1) << name;
  index_t differences = 0;
  for (index_t i = first; i < last; ++i) {
    const Index begin = part.first[at(rows.here(i))], of_whole = whole.first[at(i)];
    const Index count = part.first[at(rows.here(i)) + 1] - begin;
    bool is_same = count == whole.first[at(i) + 1] - of_whole;
    for (Index k = 0; is_same && k < count; ++k) {
      IncidenceEntry entry = part.entries[at(begin + k)];
      entry.element += before(entry.local);
      is_same = entry == whole.entries[at(of_whole + k)];
    }
    differences += is_same ? 0 : 1;
  }
  EXPECT_EQ(differences, 0) << name;
}

auto all_by(const ListedObjects& elements) {
  return [offset = static_cast<Index>(elements.offset)](Index /*local*/) { return offset; };
}

template <std::size_t kCount>
std::array<Index, kCount> moved(std::array<Index, kCount> nodes, const ListedObjects& of) {
  for (Index& node : nodes) node += static_cast<Index>(of.offset);
  return nodes;
}

/// @param given levels with or without lists @param whole the same with lists, and their graphs
void expect_part(const std::vector<MeshLevel>& given, const std::vector<MeshLevel>& whole,
                 const std::vector<LevelGraph>& graphs, std::size_t cut, int rank, int ranks) {
  const PartOfLevels part = part_of_levels(given, cut, rank, ranks);
  ASSERT_EQ(part.graphs.size(), graphs.size());
  for (std::size_t l = 0; l < graphs.size(); ++l) {
    SCOPED_TRACE("level " + std::to_string(l));
    const ListedLevel& own = part.listed.levels[l];
    EXPECT_EQ(own.nodes.size, graphs[l].nodes);
    EXPECT_EQ(own.edges.size, static_cast<index_t>(graphs[l].edges.size()));
    EXPECT_EQ(own.tets.size, static_cast<index_t>(whole[l].mesh.tets.size()));
    EXPECT_EQ(own.patches.size, static_cast<index_t>(whole[l].patches.nodes.size()));
    // A rank knows the nodes that it owns, of levels that are cut.
    const Runs runs = Runs::of_blocks(l < cut ? own.nodes.size : 0, ranks);
    if (runs.begin(rank) < runs.end(rank)) {
      EXPECT_TRUE(own.nodes.known.has(runs.begin(rank)) && own.nodes.known.has(runs.end(rank) - 1));
    }
    index_t differences = 0;
    for (index_t e = own.edges.known.first; e < std::min(own.edges.known.last, own.edges.size); ++e) {
      differences += moved(part.graphs[l].edges[at(own.edges.here(e))], own.nodes) == graphs[l].edges[at(e)] ? 0 : 1;
    }
    EXPECT_EQ(differences, 0) << "edges";
    expect_rows("edges of nodes", part.graphs[l].node_edges, graphs[l].node_edges, own.nodes, all_by(own.edges));
    const index_t nodes_here = part.graphs[l].nodes;
    for (index_t n = 0; n < nodes_here; ++n) {
      ASSERT_EQ(part.graphs[l].fixed[at(n)], graphs[l].fixed[at(n + own.nodes.offset)]);
    }
    if (l + 1 < graphs.size()) {
      const ListedLevel& coarser = part.listed.coarser[l];
      for (index_t n = 0; n < nodes_here; ++n) {
        ASSERT_EQ(moved(part.graphs[l].parents[at(n)], coarser.nodes), graphs[l].parents[at(n + own.nodes.offset)]);
      }
      expect_rows("children", part.graphs[l].children, graphs[l].children, coarser.nodes, all_by(own.nodes));
      expect_rows("terms of edges", part.graphs[l].edge_terms, graphs[l].edge_terms, coarser.edges, [&](Index local) {
        return static_cast<Index>(galerkin_block(local) == GalerkinBlock::node ? own.nodes.offset : own.edges.offset);
      });
    }
    if (l >= part.levels.size()) continue;
    const MeshLevel &here = part.levels[l], &all = whole[l];
    for (std::size_t t = 0; t < here.mesh.tets.size(); ++t) {
      ASSERT_EQ(moved(here.mesh.tets[t], own.nodes), all.mesh.tets[t + at(own.tets.offset)]);
    }
    expect_rows("tets of nodes", here.mesh.node_tets, all.mesh.node_tets, own.nodes, all_by(own.tets));
    const EdgeParts parts = make_edge_parts(here, part.graphs[l]), all_parts = make_edge_parts(all, graphs[l]);
    const auto list_of = [](const MeshRows& rows) {
      return IncidenceList{rows.first, {rows.entries.begin(), rows.entries.end()}};
    };
    expect_rows("tets of edges", list_of(parts.edge_tets), list_of(all_parts.edge_tets), own.edges, all_by(own.tets));
    if (all.patches.nodes.empty()) continue;
    expect_rows("patches of edges", parts.edge_patches, all_parts.edge_patches, own.edges, all_by(own.patches));
    expect_rows("patches of nodes", make_node_patches(here), make_node_patches(all), own.nodes, all_by(own.patches));
    expect_rows("tets of patches", here.patches.patch_tets, all.patches.patch_tets, own.patches, all_by(own.tets));
    for (std::size_t p = 0; p < here.patches.nodes.size(); ++p) {
      ASSERT_EQ(moved(here.patches.nodes[p], own.nodes), all.patches.nodes[p + at(own.patches.offset)]);
      if (here.patch_parents.empty()) continue;
      ASSERT_EQ(here.patch_parents[p] + part.listed.coarser[l].patches.offset,
                all.patch_parents[p + at(own.patches.offset)]);
    }
    EXPECT_TRUE(std::ranges::equal(here.rest, std::span(all.rest).subspan(at(own.nodes.offset), here.rest.size())));
  }
}

TEST(PartOfLevels, has_the_rows_of_the_whole_on_all_ranks) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  for (const Index cells : {48, 24, 12, 5}) {
    const bool patches = random() % 2 == 0;
    std::vector<MeshLevel> whole = make_cube_levels(cells, 1, patches);
    for (std::size_t l = whole.size(); l-- > 0;) {  // nodes are held where their parents are
      const auto at_coarser = [&](Index n) { return whole[l + 1].fixed[at(n)]; };
      for (std::size_t n = 0; n < whole[l].rest.size(); ++n) {
        const auto any = static_cast<std::uint8_t>(random() % 8);
        const auto both = [&](const auto& p) { return static_cast<std::uint8_t>(at_coarser(p[0]) & at_coarser(p[1])); };
        whole[l].fixed[n] = l + 1 == whole.size() ? any : both(whole[l].parents[n]);
        whole[l].rest[n][2] += 1e-3 * static_cast<double>(random() % 100);
      }
    }
    const std::vector<LevelGraph> graphs = make_level_graphs(whole);
    for (std::size_t cut = 1; cut <= std::min(whole.size(), std::size_t{3}); ++cut) {
      std::vector<MeshLevel> given = make_cube_levels_without_lists(cells, 1, patches, 2, cut);
      for (std::size_t l = 0; l < given.size(); ++l) {
        given[l].fixed = whole[l].fixed;
        given[l].rest = whole[l].rest;
      }
      const int ranks = 1 + static_cast<int>(random() % 8);
      for (int rank = 0; rank < ranks; ++rank) {
        SCOPED_TRACE(std::to_string(cells) + " cells, " + std::to_string(cut) + " levels cut, rank " +
                     std::to_string(rank) + " of " + std::to_string(ranks));
        expect_part(given, whole, graphs, cut, rank, ranks);
      }
    }
  }
}

TEST(PartOfLevels, of_a_large_box_is_a_part) {
  const std::vector<MeshLevel> levels = make_cube_levels_without_lists(48, 1, true, 2, 1);
  for (int rank = 0; rank < 4; ++rank) {
    const PartOfLevels part = part_of_levels(levels, 1, rank, 4);
    EXPECT_LE(part.levels.front().mesh.tets.size() * 2, levels.front().mesh.tets.size()) << "rank " << rank;
  }
}

TEST(PartOfLevels, without_edges_has_the_same_nodes_and_parents) {
  const std::vector<MeshLevel> levels = make_cube_levels_without_lists(16, 1, true, 2, 2);
  for (int rank = 0; rank < 3; ++rank) {
    const PartOfLevels part = part_of_levels(levels, 2, rank, 3, false),
                       with_edges = part_of_levels(levels, 2, rank, 3);
    ASSERT_EQ(part.graphs.size(), levels.size());
    for (std::size_t l = 0; l < levels.size(); ++l) {
      const ListedLevel &own = part.listed.levels[l], &wanted = with_edges.listed.levels[l];
      EXPECT_EQ(own.edges.size, 0);
      EXPECT_TRUE(part.graphs[l].edges.empty());
      for (const auto& [a, b] : {std::pair(own.nodes, wanted.nodes), std::pair(own.tets, wanted.tets),
                                 std::pair(own.patches, wanted.patches)}) {
        EXPECT_EQ(a.size, b.size);
        EXPECT_EQ(a.offset, b.offset);
        EXPECT_EQ(a.known.first, b.known.first);
        EXPECT_EQ(a.known.last, b.known.last);
      }
      EXPECT_EQ(part.graphs[l].parents, with_edges.graphs[l].parents);
      EXPECT_EQ(part.graphs[l].fixed, with_edges.graphs[l].fixed);
    }
  }
}

TEST(PartOfLevels, of_a_box_needs_the_lists_of_levels_that_are_not_cut) {
  EXPECT_THROW((void)part_of_levels(make_cube_levels_without_lists(8, 1, true, 2, 2), 1, 0, 2), Error);
}

TEST(PartOfLevels, of_other_meshes_is_the_whole_and_needs_lists) {
  std::vector<MeshLevel> levels = make_cube_levels(8, 1, true);
  std::swap(levels[0].mesh.tets[3], levels[0].mesh.tets[40]);
  const PartOfLevels part = part_of_levels(levels, 1, 1, 2);
  EXPECT_TRUE(part.levels.empty());
  EXPECT_EQ(part.listed.levels.front().tets.size, 6 * 8 * 8 * 8);
  EXPECT_EQ(part.listed.levels.front().nodes.offset, 0);
  std::vector<MeshLevel> plain = make_cube_levels_without_lists(8, 1, true, 2, 1);
  std::swap(plain[0].mesh.tets[3], plain[0].mesh.tets[40]);
  EXPECT_THROW((void)part_of_levels(plain, 1, 1, 2), Error);
}

}  // namespace
}  // namespace physgen::fem
