// The fields that are drawn of a state: of a tet whose stress is known; and by windows, against sums by hand.
#include <fem/mesh/follow_numbers.h>
#include <gtest/gtest.h>
#include <truthcube/fields.h>
#include <truthcube/surface.h>

#include <Eigen/Dense>
#include <cmath>
#include <iostream>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <vector>

namespace physgen::truthcube {
namespace {

using fem::Index;
using fem::Point;
using Stresses = std::vector<std::array<double, 9>>;

WholeState state_of(const std::vector<Point>& positions, const Stresses& stresses) {
  return WholeState({.positions = [&] { return std::vector<WholeState::Points>{positions}; },
                     .forces = [] { return WholeState::Points(); },
                     .stresses = [&] { return stresses; }});
}

/// The rows of a file.
struct Rows {
  PointFields points;
  CellFields cells;
  std::size_t windows_of_points = 0, windows_of_cells = 0;
};

Rows rows_of(const DrawnFields& drawn, BodyState& state) {
  Rows rows;
  const auto add = [](std::vector<double>& all, const std::vector<double>& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  drawn.each_points(state, [&](const PointFields& fields) {
    ++rows.windows_of_points;
    add(rows.points.displacement, fields.displacement);
    add(rows.points.pressure, fields.pressure);
  });
  drawn.each_cells(state, [&](const CellFields& fields) {
    ++rows.windows_of_cells;
    add(rows.cells.stress, fields.stress);
    add(rows.cells.von_mises, fields.von_mises);
    add(rows.cells.volume_ratio, fields.volume_ratio);
  });
  return rows;
}

Rows rows_of(const fem::TetMesh& mesh, const std::vector<Point>& rest, const std::vector<Point>& positions,
             const Stresses& stresses, Strain strain) {
  WholeState state = state_of(positions, stresses);
  return rows_of(DrawnFields(mesh, rest, strain), state);
}

const std::vector<Point> rest{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const std::vector<Point> compressed{{0, 0, 0}, {1.25, 0, 0}, {0, 1, 0}, {0, 0, 0.5}};  // F = diag(1.25, 1, 0.5)
const Stresses stresses{{1, 2, 3, 2, 4, 5, 3, 5, 6}};                                  // symmetric

TEST(Fields, of_finite_strain_have_the_cauchy_stress_of_the_first_piola_kirchhoff_stress) {
  const fem::TetMesh mesh = fem::make_tet_mesh(4, {{0, 1, 2, 3}});
  const Rows rows = rows_of(mesh, rest, compressed, stresses, Strain::finite);
  constexpr double J = 0.625;
  EXPECT_EQ(rows.cells.volume_ratio, std::vector{J});
  EXPECT_EQ(rows.cells.stress, (std::vector{1 * 1.25 / J, 4 / J, 6 * 0.5 / J, 2 / J, 5 * 0.5 / J, 3 * 0.5 / J}));
  for (const double pressure : rows.points.pressure) EXPECT_NEAR(pressure, -(1.25 + 4 + 3) / J / 3, 1e-14);
  EXPECT_EQ(rows.points.displacement, (std::vector<double>{0, 0, 0, 0.25, 0, 0, 0, 0, 0, 0, 0, -0.5}));
}

TEST(Fields, of_small_strain_have_the_stress_as_it_is) {
  const fem::TetMesh mesh = fem::make_tet_mesh(4, {{0, 1, 2, 3}});
  const Rows rows = rows_of(mesh, rest, compressed, stresses, Strain::small);
  EXPECT_EQ(rows.cells.volume_ratio, std::vector{0.625});
  EXPECT_EQ(rows.cells.stress, (std::vector<double>{1, 4, 6, 2, 5, 3}));
  for (const double pressure : rows.points.pressure) EXPECT_NEAR(pressure, -11.0 / 3, 1e-14);
  const double deviator = (1 - 4) * (1 - 4) + (4 - 6) * (4 - 6) + (6 - 1) * (6 - 1) + 6 * (2 * 2 + 5 * 5 + 3 * 3);
  EXPECT_NEAR(rows.cells.von_mises.at(0), std::sqrt(deviator / 2), 1e-13);
}

/// Else equal forces on a body would have averages that depend on how far it has moved.
TEST(Fields, of_small_strain_are_averaged_by_volumes_at_rest) {
  const std::vector<Point> two{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
  auto moved = two;
  moved[4][2] = -3;
  const fem::TetMesh mesh = fem::make_tet_mesh(5, {{0, 1, 2, 3}, {0, 2, 1, 4}});
  const Stresses pressures{{-3, 0, 0, 0, -3, 0, 0, 0, -3}, {-5, 0, 0, 0, -5, 0, 0, 0, -5}};
  EXPECT_NEAR(rows_of(mesh, two, moved, pressures, Strain::small).points.pressure[0], 4, 1e-14);
}

/// A body whose nodes and tets have numbers in any order, at a random state.
struct RandomBody {
  unsigned seed = std::random_device()();
  fem::TetMesh mesh;
  std::vector<Point> at_rest, positions;
  Stresses random_stresses;

  RandomBody() {
    std::cout << "seed " << seed << '\n';
    std::mt19937 random(seed);
    const auto number = [&random] { return std::uniform_real_distribution(-0.2, 0.2)(random); };
    const std::array<Index, 3> cells{23, 7, 5};
    const fem::TetMesh box = fem::make_box_mesh(cells[0], cells[1], cells[2]);
    std::vector<Index> numbers(static_cast<std::size_t>(box.nodes));
    std::iota(numbers.begin(), numbers.end(), Index{0});
    std::ranges::shuffle(numbers, random);
    at_rest.resize(numbers.size());
    for (Index n = 0; n < box.nodes; ++n) {
      const Index x = n % (cells[0] + 1), y = n / (cells[0] + 1) % (cells[1] + 1),
                  z = n / (cells[0] + 1) / (cells[1] + 1);
      at_rest[static_cast<std::size_t>(numbers[static_cast<std::size_t>(n)])] = {x + number(), y + number(),
                                                                                 z + number()};
    }
    std::vector<std::array<Index, 4>> tets = box.tets;
    for (auto& tet : tets) {
      for (Index& n : tet) n = numbers[static_cast<std::size_t>(n)];
    }
    std::ranges::shuffle(tets, random);
    mesh = fem::make_tet_mesh(box.nodes, tets);
    positions = at_rest;
    for (Point& x : positions) {
      for (double& component : x) component += 0.5 * number();
    }
    random_stresses.resize(tets.size());
    for (auto& stress : random_stresses) {
      for (double& component : stress) component = number();
    }
  }
};

/// A state of which no more than a window is asked at once, and all of it.
class AskedByWindows final : public BodyState {
 public:
  AskedByWindows(BodyState& state, std::size_t nodes, std::size_t tets) : state_(state), nodes_(nodes), tets_(tets) {}
  [[nodiscard]] bool is_here() const override { return true; }
  [[nodiscard]] std::vector<Index> nodes_of_levels() const override { return state_.nodes_of_levels(); }
  [[nodiscard]] std::vector<Point> positions(std::size_t level, std::span<const Index> nodes) override {
    EXPECT_LE(nodes.size(), nodes_);
    return state_.positions(level, nodes);
  }
  [[nodiscard]] std::vector<Point> forces(std::size_t level, std::span<const Index> nodes) override {
    return state_.forces(level, nodes);
  }
  [[nodiscard]] Stresses stresses(std::span<const Index> tets) override {
    EXPECT_LE(tets.size(), tets_);
    asked_.insert(tets.begin(), tets.end());
    return state_.stresses(tets);
  }
  [[nodiscard]] std::optional<std::vector<fem::PlaneContact>> coarser_contacts() override { return std::nullopt; }
  [[nodiscard]] std::size_t asked() const { return asked_.size(); }

 private:
  BodyState& state_;
  std::size_t nodes_, tets_;
  std::set<Index> asked_;
};

void expect_same(const Rows& found, const Rows& wanted) {
  EXPECT_TRUE(found.points.displacement == wanted.points.displacement);
  EXPECT_TRUE(found.points.pressure == wanted.points.pressure);
  EXPECT_TRUE(found.cells.stress == wanted.cells.stress);
  EXPECT_TRUE(found.cells.von_mises == wanted.cells.von_mises);
  EXPECT_TRUE(found.cells.volume_ratio == wanted.cells.volume_ratio);
}

TEST(Fields, by_windows_have_the_bits_of_one_window_and_ask_for_no_more) {
  const RandomBody body;
  for (const Strain strain : {Strain::finite, Strain::small}) {
    WholeState state = state_of(body.positions, body.random_stresses);
    const Rows wanted = rows_of(DrawnFields(body.mesh, body.at_rest, strain), state);
    EXPECT_EQ(wanted.windows_of_points, 1U);
    EXPECT_EQ(wanted.windows_of_cells, 1U);
    for (const std::size_t bytes : {1, 20'000, 300'000}) {
      const WindowSizes sizes(bytes);
      AskedByWindows asked(state, std::max(sizes.nodes(), 4 * sizes.tets()), sizes.tets());
      const Rows found = rows_of(DrawnFields(body.mesh, body.at_rest, strain, {}, bytes), asked);
      expect_same(found, wanted);
      EXPECT_EQ(asked.asked(), body.mesh.tets.size());
      EXPECT_EQ(found.windows_of_points, (body.at_rest.size() + sizes.nodes() - 1) / sizes.nodes());
      EXPECT_EQ(found.windows_of_cells, (body.mesh.tets.size() + sizes.tets() - 1) / sizes.tets());
    }
  }
}

/// Each node has all of its tets, and rows are those of these nodes and tets.
TEST(Fields, of_rows_are_those_of_their_nodes_and_tets) {
  const RandomBody body;
  WholeState state = state_of(body.positions, body.random_stresses);
  const Rows all = rows_of(DrawnFields(body.mesh, body.at_rest, Strain::small), state);
  const Surface surface = surface_of(body.mesh);
  DrawnRows rows{surface.nodes, surface.tets, std::vector<Index>(body.at_rest.size(), -1)};
  std::mt19937 random(body.seed);
  std::ranges::shuffle(rows.nodes, random);
  for (std::size_t r = 0; r < rows.nodes.size(); ++r) {
    rows.row_of_node[static_cast<std::size_t>(rows.nodes[r])] = static_cast<Index>(r);
  }
  for (const std::size_t bytes : {std::size_t{1}, std::size_t{20'000}, window_bytes}) {
    const Rows found = rows_of(DrawnFields(body.mesh, body.at_rest, Strain::small, rows, bytes), state);
    ASSERT_EQ(found.points.pressure.size(), rows.nodes.size());
    ASSERT_EQ(found.cells.von_mises.size(), rows.tets.size());
    for (std::size_t r = 0; r < rows.nodes.size(); ++r) {
      const auto node = static_cast<std::size_t>(rows.nodes[r]);
      EXPECT_EQ(found.points.pressure[r], all.points.pressure[node]);
      EXPECT_EQ(found.points.displacement[3 * r + 1], body.positions[node][1] - body.at_rest[node][1]);
    }
    for (std::size_t r = 0; r < rows.tets.size(); ++r) {
      const auto tet = static_cast<std::size_t>(rows.tets[r]);
      EXPECT_EQ(found.cells.von_mises[r], all.cells.von_mises[tet]);
      EXPECT_EQ(found.cells.volume_ratio[r], all.cells.volume_ratio[tet]);
      EXPECT_EQ(found.cells.stress[6 * r + 5], body.random_stresses[tet][6]);
    }
  }
}

TEST(Fields, of_pressure_are_averages_over_all_tets_at_a_node) {
  const RandomBody body;
  const Rows rows = rows_of(body.mesh, body.at_rest, body.positions, body.random_stresses, Strain::small);
  std::vector<double> pressure(body.at_rest.size(), 0), volume(body.at_rest.size(), 0);
  for (std::size_t t = 0; t < body.mesh.tets.size(); ++t) {
    Eigen::Matrix4d corners;
    for (int c = 0; c < 4; ++c) {
      const Point& x = body.at_rest[static_cast<std::size_t>(body.mesh.tets[t][static_cast<std::size_t>(c)])];
      corners.col(c) << x[0], x[1], x[2], 1;
    }
    const double own = std::abs(corners.determinant());
    const auto& stress = body.random_stresses[t];
    for (const Index n : body.mesh.tets[t]) {
      pressure[static_cast<std::size_t>(n)] -= own * (stress[0] + stress[4] + stress[8]) / 3;
      volume[static_cast<std::size_t>(n)] += own;
    }
  }
  for (std::size_t n = 0; n < pressure.size(); ++n) {
    ASSERT_NEAR(rows.points.pressure[n], pressure[n] / volume[n], 1e-12) << n;
  }
}

}  // namespace
}  // namespace physgen::truthcube
