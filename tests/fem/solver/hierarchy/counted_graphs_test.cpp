// Graphs that a program makes to count their entries, and hands to the solver: against those that it makes by itself,
// and what becomes of them in its arrays; on 1, 2 and 16 threads.
#include <fem/mesh/stages.h>
#include <fem/solver/hierarchy/background_grid.h>
#include <fem/solver/hierarchy/hierarchy.h>
#include <fem/solver/hierarchy/level_counts.h>
#include <fem/solver/hierarchy/level_graphs.h>
#include <fem/solver/solvers/all_arrays.h>
#include <gtest/gtest.h>
#include <physgen/error.h>
#include <physgen/threads.h>

#include <memory>
#include <set>
#include <span>
#include <string>
#include <utility>

#include "../bodies.h"
#include "../irregular.h"

namespace physgen::fem {
namespace {

using Level = LinearLevel<double, Host, StoredAsComputed>;

/// The terms of coarse blocks, as a solver's arrays have them.
IncidenceList terms_of(const Level& level) {
  const auto& ranges = contents_of(level.edge_term_ranges);
  const auto& entries = contents_of(level.edge_term_entries);
  IncidenceList list{{0}, {}};
  for (index_t e = 0; e < ranges.size(); ++e) {
    EXPECT_EQ(ranges.const_view()[e].begin(), list.first.back());
    list.first.push_back(ranges.const_view()[e].end());
  }
  for (index_t k = 0; k < entries.size(); ++k) {
    const auto entry = entries.const_view()[k];
    list.entries.push_back({static_cast<Index>(EdgeTermEntry::element(entry)), EdgeTermEntry::local(entry)});
  }
  return list;
}

void expect_same(const std::vector<LevelGraph>& graphs, const std::vector<LevelGraph>& expected) {
  ASSERT_EQ(graphs.size(), expected.size());
  for (std::size_t l = 0; l < graphs.size(); ++l) {
    SCOPED_TRACE("level " + std::to_string(l));
    EXPECT_EQ(graphs[l].nodes, expected[l].nodes);
    EXPECT_EQ(graphs[l].is_grid, expected[l].is_grid);
    EXPECT_EQ(graphs[l].edges, expected[l].edges);
    EXPECT_EQ(graphs[l].node_edges, expected[l].node_edges);
    EXPECT_EQ(graphs[l].fixed, expected[l].fixed);
    EXPECT_EQ(graphs[l].parents, expected[l].parents);
    EXPECT_EQ(graphs[l].children, expected[l].children);
    EXPECT_EQ(graphs[l].edge_terms.first, expected[l].edge_terms.first);
    ASSERT_EQ(graphs[l].grid_parents.size(), expected[l].grid_parents.size());
    for (std::size_t n = 0; n < graphs[l].grid_parents.size(); ++n) {
      EXPECT_EQ(graphs[l].grid_parents[n].nodes, expected[l].grid_parents[n].nodes);
      EXPECT_EQ(graphs[l].grid_parents[n].weights, expected[l].grid_parents[n].weights);
    }
  }
}

SolverSettings with_counted_graphs(const std::vector<MeshLevel>& levels) {
  SolverSettings settings;
  settings.graphs = std::make_shared<std::vector<LevelGraph>>(make_counted_graphs(levels));
  return settings;
}

/// Those that a program has counted become those that a solver makes by itself, of all levels and of the first ones.
void expect_counted_graphs(const std::vector<MeshLevel>& levels) {
  const std::vector<LevelGraph> whole = make_level_graphs(levels), counted = make_counted_graphs(levels);
  EXPECT_EQ(count_levels(levels, counted), count_levels(levels, whole));
  for (std::size_t l = 0; l < levels.size(); ++l) {
    EXPECT_EQ(count_levels(levels, counted)[l].edge_terms, std::int64_t(whole[l].edge_terms.entries.size()));
    EXPECT_TRUE(counted[l].edge_terms.entries.empty());
  }
  for (std::size_t l = 0; l + 1 < levels.size(); ++l) {
    EXPECT_EQ(terms_of(Level(counted[l], &counted[l + 1])), whole[l].edge_terms) << "level " << l;
  }
  for (std::size_t used = 1; used <= levels.size(); ++used) {
    SCOPED_TRACE(std::to_string(used) + " levels in use");
    const auto first = std::span(levels).first(used);
    for (const Product product : {Product::assembled, Product::matrix_free}) {
      SolverSettings settings = with_counted_graphs(levels);
      settings.newton.product = product;
      expect_same(graphs_in_use(first, settings), make_level_graphs(first, product == Product::assembled));
      EXPECT_TRUE(settings.graphs->empty()) << "taken";
    }
  }
}

std::uint8_t nothing_held(const Point& /*x*/) { return 0; }

TEST(CountedGraphs, become_those_of_the_levels_in_use) {
  std::vector<std::vector<MeshLevel>> bodies{make_cube_levels(1, 0.08, false), make_cube_levels(12, 0.08, false),
                                             make_cube_levels(8, 0.08, true)};
  bodies.push_back(bodies[1]);
  for (MeshLevel& level : bodies.back()) level.averages_at_nodes = true;
  bodies.push_back(make_levels(shuffled(irregular_box({2, 3, 2}, {1, 1, 1}, 0.2, 7), 8), 2, true, nothing_held));
  bodies.push_back(make_levels(shuffled(irregular_box({9, 10, 8}, {1, 1, 1}, 0.2, 9), 10), 0, true, nothing_held));
  ASSERT_GT(add_background_grid(bodies.back())[0], 0);
  for (const int count : {1, 2, 16}) {
    SCOPED_TRACE(std::to_string(count) + " threads");
    set_threads(count);
    for (const auto& levels : bodies) expect_counted_graphs(levels);
  }
  set_threads(0);
}

TEST(CountedGraphs, are_all_that_a_solver_needs) {
  const Body body = make_truth_cube_body(8, true);
  const auto solve = [&](const SolverSettings& settings, std::set<std::string>& made) {
    Stages stages;
    const Stages::Recording recording(stages);
    const auto solver = make_solver(body.levels, body.loading, settings);
    for (const Stages::Stage& stage : stages.all()) made.insert(stage.name);
    EXPECT_EQ(solver->solve_to(0.05, {}).status, NewtonStatus::converged);
    return solver->positions();
  };
  std::set<std::string> by_itself, of_counted;
  const auto expected = solve(SolverSettings{}, by_itself);
  EXPECT_EQ(solve(with_counted_graphs(body.levels), of_counted), expected);
  for (const char* stage : {"edges of levels", "rows of edges", "children", "coarse pairs"}) {
    EXPECT_TRUE(by_itself.contains(stage)) << stage;
    EXPECT_FALSE(of_counted.contains(stage)) << stage;
  }
}

void expect_graphs_refused(const std::vector<MeshLevel>& levels, const SolverSettings& settings,
                           const std::string& why) {
  try {
    (void)graphs_in_use(levels, settings);
    ADD_FAILURE() << "accepted: " << why;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
  }
}

TEST(CountedGraphs, that_are_not_of_the_levels_are_refused) {
  std::vector<MeshLevel> levels = make_cube_levels(4, 0.08, true);
  const SolverSettings twice = with_counted_graphs(levels);
  (void)graphs_in_use(levels, twice);
  expect_graphs_refused(levels, twice, "has 0 graphs for 2 levels");
  expect_graphs_refused(levels, with_counted_graphs(make_cube_levels(8, 0.08, true)), "level 0 has other nodes");
  const SolverSettings before = with_counted_graphs(levels);
  levels[1].fixed[3] = 7;
  expect_graphs_refused(levels, before, "level 1 has other constraints");
}

TEST(CountedGraphs, with_other_edges_are_refused) {
  const std::vector<MeshLevel> tets = make_cube_levels(4, 0.08, false), patches = make_cube_levels(4, 0.08, true);
  for (const std::size_t l : {std::size_t{0}, std::size_t{1}}) {
    const std::string why = "level " + std::to_string(l) + " has other edges";
    std::vector<MeshLevel> changed = tets;
    changed[l].averages_at_nodes = true;
    expect_graphs_refused(changed, with_counted_graphs(tets), why);
    changed = tets;
    changed[l].patches = patches[l].patches;
    expect_graphs_refused(changed, with_counted_graphs(tets), why);
  }
  std::vector<MeshLevel> turned = tets;  // as many tets and edges, with other diagonals
  turned[0].mesh = make_box_mesh(4, 4, 4);
  ASSERT_EQ(turned[0].mesh.edges.size(), tets[0].mesh.edges.size());
  expect_graphs_refused(turned, with_counted_graphs(tets), "level 0 has other edges");
}

TEST(CountedGraphs, with_other_parents_are_refused) {
  std::vector<MeshLevel> levels = make_cube_levels(4, 0.08, false);
  const SolverSettings nested = with_counted_graphs(levels);
  levels[0].parents[1][1] = levels[0].parents[1][0];
  expect_graphs_refused(levels, nested, "level 0 has other parents");

  levels = make_levels(shuffled(irregular_box({9, 10, 8}, {1, 1, 1}, 0.2, 9), 10), 0, true, nothing_held);
  ASSERT_GT(add_background_grid(levels)[0], 0);
  const SolverSettings over_grid = with_counted_graphs(levels);
  std::swap(levels[0].grid_parents[5].weights[0], levels[0].grid_parents[5].weights[1]);
  ASSERT_NE(levels[0].grid_parents[5].weights[0], levels[0].grid_parents[5].weights[1]);
  expect_graphs_refused(levels, over_grid, "level 0 has other parents");
}

}  // namespace
}  // namespace physgen::fem
