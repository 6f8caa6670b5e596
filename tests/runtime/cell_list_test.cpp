// Cell lists against every pair of objects, on 1, 2 and 16 threads, and what they refuse.
#include <physgen/threads.h>

#include <limits>
#include <numeric>

#include "cell_list_checks.h"
#include "cell_rules.h"

namespace physgen::test {
namespace {

/// The difference of two coordinates as the contract has it.
template <class Real>
Real difference(Real a, Real b, Real lower, Real upper, bool periodic) {
  const Real d = a - b, length = upper - lower;
  if (!periodic) return d;
  return d > length / 2 ? d - length : d < -length / 2 ? d + length : d;
}

/// The neighbours by all pairs, ordered by `place`. Fused sums are avoided by volatile.
template <class Real, int kDimensions>
Lists neighbours_by_pairs(const Points<Real, kDimensions>& points, const CellBox<Real, kDimensions>& box, Real reach,
                          bool with_itself, const std::vector<std::int32_t>& place) {
  Lists lists(points.size());
  const volatile Real square_of_reach = reach * reach;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (i == j && !with_itself) continue;
      volatile Real sum = 0;
      for (std::size_t k = kDimensions; k-- > 0;) {
        const Real d = difference(points[i][k], points[j][k], box.lower[k], box.upper[k], box.periodic[k]);
        const volatile Real product = d * d;
        sum = k + 1 == kDimensions ? product : product + sum;
      }
      if (sum < square_of_reach) lists[i].push_back(static_cast<std::int32_t>(j));
    }
    std::ranges::sort(lists[i], {}, [&](std::int32_t j) { return place[static_cast<std::size_t>(j)]; });
  }
  return lists;
}

/// The neighbours as a device finds them, object by object, with its arithmetic.
template <class Real, int kDimensions>
Lists neighbours_one_by_one(const Points<Real, kDimensions>& points, const CellBox<Real, kDimensions>& box, Real reach,
                            bool with_itself) {
  const auto grid = detail::cells::grid_for(box, reach, std::ssize(points));
  std::vector<std::int32_t> members(points.size()), cells(points.size());
  std::iota(members.begin(), members.end(), 0);
  const auto cell_of = [&](std::int32_t i) { return grid.cell_of(points[static_cast<std::size_t>(i)].data()); };
  std::ranges::stable_sort(members, {}, cell_of);
  std::ranges::transform(members, cells.begin(), cell_of);
  std::vector<std::int32_t> begin_of_cell;
  for (std::int32_t cell = 0; cell <= grid.cells(); ++cell) {
    begin_of_cell.push_back(static_cast<std::int32_t>(std::ranges::lower_bound(cells, cell) - cells.begin()));
  }
  detail::PlacedObjects<Real, kDimensions> objects{grid, begin_of_cell.data(), members.data(), cells.data(), {}};
  std::array<std::vector<Real>, kDimensions> places;
  for (std::size_t k = 0; k < kDimensions; ++k) {
    for (const std::int32_t i : members) places[k].push_back(points[static_cast<std::size_t>(i)][k]);
    objects.places[k] = places[k].data();
  }
  Lists lists(points.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    auto& list = lists[static_cast<std::size_t>(members[p])];
    objects.for_each_near(static_cast<index_t>(p), with_itself, [&](std::int32_t number) { list.push_back(number); });
  }
  return lists;
}

template <class Real, int kDimensions>
void expect_neighbours(const Points<Real, kDimensions>& points, const CellBox<Real, kDimensions>& box, Real reach) {
  const auto size = static_cast<index_t>(points.size());
  CellList<Real, kDimensions> cells(box, reach);
  const auto build = [&] { cells.build(Host{}, size, [&](index_t i) { return points[static_cast<std::size_t>(i)]; }); };
  build();
  const HostList<index_t> order = cells.order();
  std::vector<std::int32_t> place(points.size(), -1);
  for (std::size_t p = 0; p < order.size(); ++p) place[static_cast<std::size_t>(order[p])] = static_cast<int>(p);
  ASSERT_EQ(cells.size(), size);
  ASSERT_EQ(std::ranges::count(place, -1), 0);
  index_t count = 1;
  for (std::size_t k = 0; k < kDimensions; ++k) {
    count *= cells.cells()[k];
    const Real width = (box.upper[k] - box.lower[k]) / static_cast<Real>(cells.cells()[k]);
    EXPECT_TRUE(width >= reach || cells.cells()[k] == 1);
  }
  EXPECT_LE(count, 2 * size + 4096);
  Neighbours rows;
  for (const OwnEntry own : {OwnEntry::left_out, OwnEntry::included}) {
    const Lists expected = neighbours_by_pairs<Real, kDimensions>(points, box, reach, own == OwnEntry::included, place);
    EXPECT_EQ((neighbours_one_by_one<Real, kDimensions>(points, box, reach, own == OwnEntry::included)), expected);
    for (const int threads : {1, 2, 16}) {
      SCOPED_TRACE(threads);
      set_threads(threads);
      build();
      EXPECT_EQ(cells.order(), order);
      cells.find_neighbours(rows, own);
      rows.check();
      EXPECT_EQ(rows.targets().field, "patch");
      EXPECT_EQ(rows.targets().count, size);
      EXPECT_EQ(lists_of(rows), expected);
    }
    set_threads(0);
  }
}

template <class Real, int kDimensions>
void expect_neighbours_in_boxes() {
  std::uint32_t use = 0;
  for_boxes<Real, kDimensions>([&](const auto& box, Real reach) {
    for (const index_t size : {0, 1, 2, 300}) {
      expect_neighbours<Real, kDimensions>(random_points<Real, kDimensions>(size, box, reach, use++), box, reach);
    }
  });
}

TEST(CellList, finds_the_neighbours_of_all_pairs_on_any_number_of_threads) {
  expect_neighbours_in_boxes<float, 1>();
  expect_neighbours_in_boxes<float, 2>();
  expect_neighbours_in_boxes<float, 3>();
  expect_neighbours_in_boxes<double, 2>();
  expect_neighbours_in_boxes<double, 3>();
}

TEST(CellList, of_several_blocks_finds_the_same) {
  const CellBox<float> box{.lower = {0, 0, 0}, .upper = {1, 1, 1}, .periodic = {true, false, true}};
  expect_neighbours<decltype(0.1F), 3>(random_points<decltype(0.1F), 3>(3000, box, 0.1F, 1000), box, 0.1F);
}

TEST(CellList, whose_reach_exceeds_an_open_box_has_one_cell) {
  const CellBox<float> box{.lower = {0, 0, 0}, .upper = {1, 1, 1}};
  expect_neighbours<decltype(10.0F), 3>(random_points<decltype(10.0F), 3>(100, box, 10.0F, 2000), box, 10.0F);
}

TEST(CellList, of_a_vast_box_has_hardly_more_cells_than_objects) {
  const CellBox<double> box{.lower = {0, 0, 0}, .upper = {1e9, 1e6, 1e9}, .periodic = {true, true, true}};
  expect_neighbours<decltype(1.0), 3>(random_points<decltype(1.0), 3>(300, box, 1.0, 3000), box, 1.0);
}

TEST(CellList, is_built_and_searched_again_in_the_same_memory) {
  const CellBox<float> box{.lower = {0, 0, 0}, .upper = {1, 1, 1}};
  CellList<float> cells(box, 0.1F);
  Neighbours rows;
  const void *ranges = nullptr, *entries = nullptr;
  for (const index_t size : {2000, 1900, 0, 1950}) {
    const auto points = random_points<float, 3>(size, box, 0.1F, 4000);
    cells.build(Host{}, size, [&](index_t i) { return points[static_cast<std::size_t>(i)]; });
    cells.find_neighbours(rows);
    EXPECT_EQ(rows.size(), size);
    if (size == 2000) {
      ranges = rows.ranges().view().data();
      entries = rows.entries().view().data();
    }
    EXPECT_EQ(rows.ranges().view().data(), ranges);
    EXPECT_EQ(rows.entries().view().data(), entries);
  }
}

TEST(CellList, takes_positions_of_a_view) {
  elasticity::NodePositionArray<float> nodes(3);
  nodes[0].x() = Eigen::Vector3f(0.1F, 0.2F, 0.3F);
  nodes[1].x() = Eigen::Vector3f(0.9F, 0.9F, 0.9F);
  nodes[2].x() = Eigen::Vector3f(0.1F, 0.2F, 0.35F);
  CellList<float> cells({.lower = {0, 0, 0}, .upper = {1, 1, 1}}, 0.1F);
  Neighbours rows;
  for (const bool by_value : {true, false}) {
    const auto view = nodes.const_view();
    if (by_value) {
      cells.build(Host{}, nodes.size(), [view](index_t i) { return view[i].x().get(); });
    } else {
      cells.build(Host{}, nodes.size(), [view](index_t i) { return view[i].x(); });
    }
    cells.find_neighbours(rows);
    EXPECT_EQ(lists_of(rows), (Lists{{2}, {}, {0}}));
  }
}

std::string refusal_of(const CellBox<float>& box, float reach) {
  return message_of([&] { CellList<float>(box, reach); });
}

TEST(CellList, refuses_boxes_and_reaches_with_their_numbers_and_what_to_give) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  const CellBox<float> box{.lower = {0, 0, 0}, .upper = {1, 1, 1}};
  for (const auto& [reach, text] : {std::pair(0.0F, "0"), {-2.0F, "-2"}, {nan, "nan"}, {inf, "inf"}}) {
    EXPECT_EQ(refusal_of(box, reach),
              "physgen: CellList: the reach is " + std::string(text) + "; give a positive number");
  }
  EXPECT_EQ(refusal_of(box, 1e-30F),
            "physgen: CellList: the reach is 1e-30, whose square, 0, cannot be compared with; choose a unit of length "
            "in which it is nearer to 1");
  const std::string ends = "; give finite ends, the lower one less than the upper one";
  EXPECT_EQ(refusal_of({.lower = {0, 0, 0}, .upper = {1, 0, 1}}, 1),
            "physgen: CellList: the box goes from 0 to 0 along y" + ends);
  EXPECT_EQ(refusal_of({.lower = {0, 0, nan}, .upper = {1, 1, 1}}, 1),
            "physgen: CellList: the box goes from nan to 1 along z" + ends);
  EXPECT_EQ(refusal_of({.lower = {-inf, 0, 0}, .upper = {1, 1, 1}}, 1),
            "physgen: CellList: the box goes from -inf to 1 along x" + ends);
  EXPECT_EQ(refusal_of({.lower = {0, 0, 0}, .upper = {1, 1, 1}, .periodic = {false, true, false}}, 0.625F),
            "physgen: CellList: the box goes from 0 to 1 along y and is periodic, which is less than twice the reach "
            "of 0.625, so that an object could be a neighbour of another twice; give a longer box, in which the "
            "objects are repeated, or a shorter reach");
}

TEST(CellList, names_the_first_object_outside_and_stays_as_it_was) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  Points<float, 3> points(5000, {0.5F, 0.25F, 0.125F});
  const auto message = [&](CellList<float>& cells) {
    return message_of([&] {
      cells.build(Host{}, std::ssize(points), [&](index_t i) { return points[static_cast<std::size_t>(i)]; });
    });
  };
  for (const int threads : {1, 16}) {
    set_threads(threads);
    CellList<float> cells({.lower = {0, 0, 0}, .upper = {1, 1, 1}}, 0.1F);
    cells.build(Host{}, 2, [&](index_t) { return points[0]; });
    points[3] = {0.5F, -0.25F, 0};
    points[4999] = {0, nan, 0};
    EXPECT_EQ(message(cells),
              "physgen: CellList: object 3 is at (0.5, -0.25, 0), outside the box from (0, 0, 0) to (1, 1, 1); give a "
              "box with room for all objects, or keep objects in it");
    points[3] = points[0];
    EXPECT_EQ(message(cells),
              "physgen: CellList: object 4999 is at (0, nan, 0), which is nowhere; look at what computed its position, "
              "such as a time step that is too long");
    Neighbours rows;
    cells.find_neighbours(rows);
    EXPECT_EQ(lists_of(rows), (Lists{{1}, {0}}));
  }
  set_threads(0);
  CellList<float> cells({.lower = {0, 0, 0}, .upper = {1, 1, 1}, .periodic = {true, true, true}}, 0.1F);
  points[4999] = {0, 1.5F, 0};
  EXPECT_EQ(message(cells),
            "physgen: CellList: object 4999 is at (0, 1.5, 0), outside the box from (0, 0, 0) to (1, 1, 1); move it by "
            "whole lengths of the box where that is periodic, and elsewhere keep objects in it");
  EXPECT_EQ(message_of([&] { cells.build(Host{}, index_t{1} << 31, [&](index_t) { return points[0]; }); }),
            "physgen: CellList: there cannot be 2147483648 objects; give a number from 0 to 2147483647");
}

TEST(CellList, refuses_more_neighbours_than_wanted_and_leaves_the_rows_as_they_were) {
  CellList<float> cells({.lower = {0, 0, 0}, .upper = {1, 1, 1}}, 0.5F);
  const auto build = [&](index_t size) {
    cells.build(Host{}, size, [](index_t) { return std::array{0.5F, 0.5F, 0.5F}; });
  };
  Neighbours rows;
  build(3);
  cells.find_neighbours(rows, OwnEntry::included, 9);
  build(70000);  // all pairs are more than 2^31 - 1
  for (const index_t most : {index_t{1000}, index_t{0}}) {
    EXPECT_EQ(message_of([&] { cells.find_neighbours(rows, OwnEntry::left_out, most); }),
              "physgen: CellList: 70000 objects have more than " + std::to_string(most) +
                  " neighbours within a reach of 0.5; give a shorter reach, or look at whether the objects have fallen "
                  "together");
  }
  EXPECT_EQ(lists_of(rows), (Lists{{0, 1, 2}, {0, 1, 2}, {0, 1, 2}}));
}

}  // namespace
}  // namespace physgen::test
