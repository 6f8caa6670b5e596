// Checks of meshes: every defect is put in on purpose, at random places, and found there and nowhere else.
#include <fem/mesh/at.h>
#include <fem/mesh/check.h>
#include <gtest/gtest.h>
#include <physgen/error.h>
#include <physgen/threads.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "mesh_cases.h"

namespace physgen::fem {
namespace {

using reference::MeshCase;
using Tets = std::vector<std::array<Index, 4>>;

// `count` different numbers below `limit`, ascending.
std::vector<std::size_t> drawn(std::size_t count, std::size_t limit, std::uint64_t stream) {
  std::vector<std::size_t> all(limit);
  std::iota(all.begin(), all.end(), std::size_t{0});
  auto random = reference::random_stream(stream);
  std::ranges::shuffle(all, random);
  all.resize(count);
  std::ranges::sort(all);
  return all;
}

void expect_found(const Finding& finding, const std::vector<std::size_t>& places) {
  EXPECT_EQ(finding.count, places.size());
  const auto shown = static_cast<std::ptrdiff_t>(std::min(places.size(), Finding::shown));
  EXPECT_EQ(finding.first, std::vector(places.begin(), places.begin() + shown));
}

TEST(MeshCheck, finds_nothing_in_good_meshes_of_any_size) {
  for (const double scale : {1e-6, 1., 1e6}) {
    for (const auto& [name, mesh, given] : reference::mesh_cases()) {
      SCOPED_TRACE(name);
      std::vector<Point> rest = given;
      for (Point& x : rest) {
        for (double& coordinate : x) coordinate *= scale;
      }
      const MeshReport report = check_mesh(rest, mesh.tets);
      EXPECT_TRUE(report.errors().empty()) << report.describe();
      EXPECT_EQ(report.nodes, rest.size());
      EXPECT_EQ(report.tets, mesh.tets.size());
    }
  }
}

TEST(MeshCheck, finds_inverted_tets) {
  MeshCase given = reference::shuffled(reference::jittered(reference::box(4, 4, 4), 0.1, 40), 41);
  const auto places = drawn(7, given.mesh.tets.size(), 42);
  for (const std::size_t t : places) std::swap(given.mesh.tets[t][1], given.mesh.tets[t][3]);
  const MeshReport report = check_mesh(given.rest, given.mesh.tets);
  expect_found(report.inverted, places);
  EXPECT_EQ(report.errors().size(), 1u) << report.describe();
}

TEST(MeshCheck, finds_tets_without_volume_at_any_scale) {
  for (const double scale : {1e-5, 1., 1e5}) {
    std::vector<Point> rest{{0, 0, 0},         {1, 0, 0},        {0, 1, 0},         {0.3, 0.3, 1},
                            {0.2, 0.2, 1e-12}, {0.2, 0.2, 1e-6}, {0.2, 0.2, -1e-12}};
    for (Point& x : rest) {
      for (double& coordinate : x) coordinate *= scale;
    }
    const MeshReport report =
        check_mesh(rest, Tets{{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 2, 5}, {0, 1, 2, 6}, {0, 1, 1, 2}});
    expect_found(report.flat, {1, 3, 4});
    EXPECT_EQ(report.inverted.count, 0u);
  }
}

TEST(MeshCheck, finds_duplicates_whatever_the_order_of_their_corners_and_names_the_first) {
  const MeshCase given = reference::shuffled(reference::box(3, 3, 3), 43);
  Tets tets = given.mesh.tets;
  const std::size_t count = tets.size();
  tets.push_back({tets[9][1], tets[9][2], tets[9][0], tets[9][3]});
  tets.push_back({tets[50][0], tets[50][2], tets[50][3], tets[50][1]});
  tets.push_back(tets[9]);
  const MeshReport report = check_mesh(given.rest, tets);
  expect_found(report.duplicates, {count, count + 1, count + 2});
  EXPECT_EQ(report.originals, (std::vector<std::size_t>{9, 50, 9}));
  EXPECT_EQ(report.errors(),
            std::vector<std::string>{"3 elements with the same four nodes as another (162 as 9, 163 as "
                                     "50, 164 as 9); remove one of each"});
}

TEST(MeshCheck, finds_faces_of_three_tets) {
  const std::vector<Point> rest{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {0, 0, 2}};
  const MeshReport report = check_mesh(rest, Tets{{0, 1, 2, 3}, {0, 2, 1, 4}, {0, 1, 2, 5}});
  expect_found(report.crowded, {0});
  EXPECT_EQ(report.duplicates.count, 0u);
}

TEST(MeshCheck, finds_nodes_of_no_tet_and_those_that_are_no_numbers) {
  MeshCase given = reference::box(3, 3, 3);
  const auto places = drawn(9, 64 + 8, 44);
  Tets tets = given.mesh.tets;
  std::vector<Point> rest;  // with loose nodes at the places
  std::vector<Index> number;
  for (std::size_t n = 0; n < 64 + 9; ++n) {
    if (std::ranges::binary_search(places, n)) {
      rest.push_back({5, 5, 5});
    } else {
      number.push_back(static_cast<Index>(n));
      rest.push_back(given.rest[number.size() - 1]);
    }
  }
  for (auto& tet : tets) {
    for (Index& corner : tet) corner = number[at(corner)];
  }
  expect_found(check_mesh(rest, tets).unreferenced, places);
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    given.rest[17][1] = bad;
    const MeshReport report = check_mesh(given.rest, given.mesh.tets);
    expect_found(report.not_finite, {17});
    EXPECT_EQ(report.errors().size(), 1u) << report.describe();
  }
}

TEST(MeshCheck, finds_tets_of_nodes_that_do_not_exist) {
  const MeshCase given = reference::box(2, 2, 2);
  Tets tets = given.mesh.tets;
  tets.push_back({0, 1, 2, 27});
  tets.insert(tets.begin(), {-1, 0, 1, 2});
  const MeshReport report = check_mesh(given.rest, tets);
  expect_found(report.out_of_range, {0, tets.size() - 1});
  EXPECT_EQ(report.errors().size(), 1u) << report.describe();
}

TEST(MeshCheck, names_the_parts_of_a_mesh) {
  const MeshCase one = reference::box(2, 1, 1), other = reference::box(1, 1, 1);
  const MeshReport report = check_mesh(reference::beside(one, other).rest, reference::beside(one, other).mesh.tets);
  EXPECT_EQ(report.components, (std::vector<Component>{{12, 12, 0, 0}, {8, 6, 12, 12}}));
  EXPECT_TRUE(report.errors().empty());
  EXPECT_EQ(report.warnings(),
            std::vector<std::string>{"the mesh has 2 parts that share no node; each needs supports of its own: 12 "
                                     "elements and 12 nodes from element 0 and node 0, 6 elements and 8 nodes from "
                                     "element 12 and node 12"});
}

// Random tets over many nodes: a graph in pieces of all sizes. The oracle spreads the lowest number until nothing
// moves.
TEST(MeshCheck, counts_the_parts_of_random_graphs) {
  auto random = reference::random_stream(45);
  for (const std::size_t count : {5, 30, 60, 120}) {
    constexpr std::size_t nodes = 200;
    Tets tets;
    for (std::size_t t = 0; t < count; ++t) {
      const auto corners = drawn(4, nodes, random());
      tets.push_back({static_cast<Index>(corners[0]), static_cast<Index>(corners[1]), static_cast<Index>(corners[2]),
                      static_cast<Index>(corners[3])});
    }
    std::vector<Index> lowest(nodes);
    std::iota(lowest.begin(), lowest.end(), Index{0});
    for (bool moved = true; moved;) {
      moved = false;
      for (const auto& tet : tets) {
        Index low = lowest[at(tet[0])];
        for (const Index n : tet) low = std::min(low, lowest[at(n)]);
        for (const Index n : tet) {
          moved = moved || lowest[at(n)] != low;
          lowest[at(n)] = low;
        }
      }
    }
    std::vector<std::size_t> sizes(nodes), loose;
    for (const Index low : lowest) ++sizes[at(low)];
    for (std::size_t n = 0; n < nodes; ++n) {
      if (sizes[n] == 1) loose.push_back(n);
    }
    const MeshReport report = check_mesh(std::vector<Point>(nodes), tets);
    EXPECT_EQ(report.component_count,
              at(static_cast<Index>(std::ranges::count_if(sizes, [](auto s) { return s > 1; }))));
    expect_found(report.unreferenced, loose);
    EXPECT_LE(report.components.size(), Finding::shown);
    for (const Component& component : report.components) {
      const auto low = at(component.lowest_node);
      EXPECT_EQ(component.nodes, sizes[low]);
      const auto own = [&](const auto& tet) { return at(lowest[at(tet[0])]) == low; };
      EXPECT_EQ(component.tets, at(static_cast<Index>(std::ranges::count_if(tets, own))));
      EXPECT_EQ(component.lowest_tet, std::ranges::find_if(tets, own) - tets.begin());
    }
  }
}

TEST(MeshCheck, lets_nothing_pass_that_make_tet_mesh_refuses) {
  auto random = reference::random_stream(46);
  int refused = 0;
  for (int repeat = 0; repeat < 300; ++repeat) {
    const MeshCase given = reference::box(2, 1, 1);
    Tets tets = given.mesh.tets;
    for (int change = 0; change < 2; ++change) {
      tets[random() % tets.size()][random() % 4] = static_cast<Index>(random() % 16) - 2;
    }
    try {
      static_cast<void>(make_tet_mesh(given.mesh.nodes, tets));
    } catch (const Error&) {
      ++refused;
      EXPECT_FALSE(check_mesh(given.rest, tets).errors().empty());
    }
  }
  EXPECT_GT(refused, 100);
}

TEST(MeshCheck, says_what_is_wrong_where_in_the_file_s_own_numbers_and_what_to_do) {
  MeshCase given = reference::box(2, 1, 1);
  for (std::size_t t = 0; t < 7; ++t) std::swap(given.mesh.tets[t][1], given.mesh.tets[t][2]);
  given.rest.push_back({9, 9, 9});
  std::vector<std::size_t> node_tags(given.rest.size()), tet_tags(given.mesh.tets.size());
  std::iota(node_tags.begin(), node_tags.end(), std::size_t{100});
  std::iota(tet_tags.begin(), tet_tags.end(), std::size_t{5000});
  EXPECT_EQ(check_mesh(given.rest, given.mesh.tets).describe(node_tags, tet_tags),
            "13 nodes, 12 elements\n"
            "error: 7 elements of negative volume (elements 5000, 5001, 5002, 5003, 5004, ...); exchange two of their "
            "corners, or mesh again without overlaps\n"
            "error: 1 node of no element (node 112); remove what no element uses (in Gmsh: save the volumes alone)\n");
}

TEST(MeshCheck, takes_a_node_with_thousands_of_tets) {
  for (const MeshCase& given : {reference::star(5000), reference::shuffled(reference::star(5000), 47)}) {
    const MeshReport report = check_mesh(given.rest, given.mesh.tets);
    EXPECT_TRUE(report.errors().empty()) << report.describe();
    EXPECT_EQ(report.component_count, 1u);
    Tets tets = given.mesh.tets;
    tets.push_back(tets[1234]);
    expect_found(check_mesh(given.rest, tets).duplicates, {5000});
  }
}

TEST(MeshCheck, finds_the_same_on_any_number_of_threads) {
  MeshCase given = reference::shuffled(reference::beside(reference::box(20, 20, 20), reference::box(9, 9, 9)), 48);
  Tets tets = given.mesh.tets;
  for (const std::size_t t : drawn(40, tets.size(), 49)) std::swap(tets[t][0], tets[t][1]);
  for (const std::size_t t : drawn(30, tets.size(), 50)) tets.push_back(tets[t]);
  for (const std::size_t t : drawn(20, tets.size(), 51)) tets[t][0] = tets[t][1];
  for (const std::size_t t : drawn(10, tets.size(), 52)) tets[t][2] = -1;
  set_threads(1);
  const std::string alone = check_mesh(given.rest, tets).describe();
  for (const int threads : {2, 16}) {
    set_threads(threads);
    EXPECT_EQ(check_mesh(given.rest, tets).describe(), alone) << threads << " threads";
  }
  set_threads(0);
}

TEST(MeshCheck, refuses_a_mesh_without_tets) {
  EXPECT_EQ(check_mesh({}, {}).errors(),
            std::vector<std::string>{"the mesh has no tetrahedra; mesh the volume, not only its surface"});
}

TEST(MeshCheck, knows_what_32_bit_numbers_hold) {
  EXPECT_TRUE(fits_32_bits(2147483647, 178956970));
  EXPECT_FALSE(fits_32_bits(2147483648, 1));
  EXPECT_FALSE(fits_32_bits(1, 178956971));
  MeshReport report;
  report.nodes = 3;
  report.tets = 178956971;
  report.too_large = true;
  EXPECT_EQ(report.errors(),
            std::vector<std::string>{"3 nodes and 178956971 elements are more than 32-bit numbers can count; mesh more "
                                     "coarsely, or solve parts of the body"});
}

}  // namespace
}  // namespace physgen::fem
