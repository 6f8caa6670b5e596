// Rows on the CPU: packs of all widths and single objects; and what wrong rows are told.
#include <physgen/parallel_for.h>
#include <physgen/threads.h>

#include "rows_checks.h"

namespace physgen::test {
namespace {

template <class Case>
class HostRows : public ::testing::Test {};
using Cases =
    ::testing::Types<RowsCase<float, Host, Aos, detail::pack_lanes<float>()>, RowsCase<float, Host, Aosoa<32>, 8>,
                     RowsCase<float, Host, AosPadded, 1>, RowsCase<double, Host, Soa, detail::pack_lanes<double>()>,
                     RowsCase<double, Host, Aosoa<8>, 4>>;
TYPED_TEST_SUITE(HostRows, Cases);

TYPED_TEST(HostRows, are_visited_as_by_a_plain_loop_bit_for_bit) { check_visits<TypeParam>(); }
TYPED_TEST(HostRows, are_made_of_lists_of_unsorted_pairs_and_of_offsets) { check_construction<TypeParam>(); }
TYPED_TEST(HostRows, follow_changes_of_both_sets) { check_row_topology<TypeParam>(); }
TYPED_TEST(HostRows, refuse_wrong_changes_and_stay_as_they_were) { check_refused_changes<TypeParam>(); }

using Rows = RowArrays<elasticity::IncidenceRangeArray<float>, elasticity::IncidenceArray<float>>;
using Entry = Rows::Value;
using Pairs = std::vector<std::pair<index_t, Entry>>;
using Offsets = std::vector<std::int32_t>;

std::size_t at(index_t i) { return static_cast<std::size_t>(i); }

void expect_said(const std::string& said, const std::string& wanted) {
  EXPECT_NE(said.find(wanted), std::string::npos) << said << "\nwithout: " << wanted;
}

TEST(RowArrays, name_the_first_entry_that_names_nothing) {
  const std::vector<std::vector<Entry>> lists{{{0, 0}}, {}, {{3, 0}, {-1, 0}}, {{4, 0}}};
  expect_said(
      message_of([&] { (void)Rows::from_lists({"element", 3}, lists); }),
      "rows of elasticity::Incidence: entry 0 of row 2 has element = 3, of 3 objects; give a number from 0 to 2");
  expect_said(message_of([&] { (void)Rows::from_lists({"element", 4}, lists); }),
              "entry 1 of row 2 has element = -1, of 4 objects; give a number from 0 to 3");
  expect_said(message_of([&] { (void)Rows::from_lists({"element", 0}, lists); }),
              "entry 0 of row 0 has element = 0, of 0 objects; there are no objects");
  expect_said(message_of([&] { (void)Rows::from_lists({"element", -4}, lists); }),
              "there cannot be -4 objects to name");
  expect_said(message_of([&] { (void)Rows::from_lists({"elements", 9}, lists); }),
              "there is no field of indices \"elements\"; there are: element local");
}

TEST(RowArrays, name_the_pair_of_no_row) {
  const Pairs pairs{{0, {0, 0}}, {2, {0, 0}}};
  expect_said(message_of([&] { (void)Rows::from_pairs({"element", 1}, 2, pairs); }),
              "pair 1 is one of row 2, of 2; give a number from 0 to 1");
  expect_said(message_of([&] { (void)Rows::from_pairs({"element", 1}, 0, pairs); }), "there are no rows");
  expect_said(message_of([&] { (void)Rows::from_pairs({"element", 1}, -1, pairs); }), "there cannot be -1 rows");
}

TEST(RowArrays, name_the_offset_that_is_wrong) {
  const std::vector<Entry> entries{{0, 0}, {0, 0}};
  const auto made_of = [&](const Offsets& first) {
    return message_of([&] { (void)Rows::from_offsets({"element", 1}, first, entries); });
  };
  expect_said(made_of({}), "there are no offsets; give one more than there are rows, the first being 0");
  expect_said(made_of({1, 2}), "offset 0 is 1; the first must be 0");
  expect_said(made_of({0, 2, 1}), "offset 2 is 1, less than the one before; they must not descend");
  expect_said(made_of({0, 1}), "offset 1 is 1, the last; it must be the number of entries, 2");
  EXPECT_EQ(made_of({0, 2}), "nothing was thrown");
}

TEST(RowArrays, of_many_objects_are_those_of_vectors_on_any_number_of_threads) {
  const index_t size = 40000;
  std::vector<std::vector<Entry>> lists(at(size), {{0, 0}});
  Pairs pairs(at(size), {0, {0, 0}});
  Offsets first(at(size), 0);
  std::vector<Entry> none;
  for (const index_t i : {12345, 12346, 39998}) {
    lists[at(i)].push_back({1, 0});
    pairs[at(i)].first = -1;
    first[at(i)] = 1;
  }
  for (const int threads : {1, 2, 16}) {
    SCOPED_TRACE(threads);
    set_threads(threads);
    check_construction<RowsCase<float, Host, AosPadded, 1>>({size});
    check_row_topology<RowsCase<float, Host, AosPadded, 1>>(size, 30000, 10);
    expect_said(message_of([&] { (void)Rows::from_lists({"element", 1}, lists); }), "entry 1 of row 12345 has");
    expect_said(message_of([&] { (void)Rows::from_pairs({"element", 1}, 1, pairs); }), "pair 12345 is one of row -1");
    expect_said(message_of([&] { (void)Rows::from_offsets({"element", 1}, first, none); }), "offset 12347 is 0, less");
  }
  set_threads(0);
}

TEST(RowArrays, refuse_more_entries_than_an_index_names) {
  constexpr index_t most = std::numeric_limits<std::int32_t>::max();
  EXPECT_EQ(detail::rows_of_lengths("md::Neighbour", std::vector<index_t>{most - 1, 0, 1}).back().end, most);
  expect_said(
      message_of([] { (void)detail::rows_of_lengths("md::Neighbour", std::vector<index_t>{5, most - 4}); }),
      "rows of md::Neighbour: row 1 would end at entry 2147483648, and an Index counts to 2147483647; spread the "
      "rows over several arrays");
}

TEST(RowArrays, refuse_arrays_whose_ranges_are_none) {
  const auto taken = [](std::int32_t begin, std::int32_t end) {
    Rows::Ranges ranges(2);
    ranges.view().put(1, {begin, end});
    return message_of([&] { (void)Rows({"element", 1}, ranges, Rows::Entries(4)); });
  };
  EXPECT_EQ(taken(0, 4), "nothing was thrown");
  expect_said(taken(3, 2), "row 1 has begin 3 and end 2, of 4 entries; give 0 <= begin <= end <= 4");
  expect_said(taken(3, 5), "row 1 has begin 3 and end 5, of 4 entries");
  expect_said(taken(-1, 0), "row 1 has begin -1 and end 0");
  Rows::Entries entries(4);
  entries.view()[2].element() = 9;
  Rows::Ranges ranges(1);
  ranges.view().put(0, {1, 4});
  expect_said(message_of([&] { (void)Rows({"element", 1}, ranges, entries); }),
              "entry 1 of row 0 has element = 9, of 1 objects");
}

TEST(RowArrays, are_checked_anew_when_a_kernel_has_written_them) {
  Rows rows = Rows::from_lists({"element", 5}, std::vector<std::vector<Entry>>{{{0, 0}, {4, 0}}});
  rows.view().entries()[1].element() = 5;
  expect_said(message_of([&] { rows.check(); }), "entry 1 of row 0 has element = 5");
}

TEST(RowArrays, refuse_to_renumber_entries_that_name_nothing_since_a_kernel_wrote_them) {
  for (const std::int32_t wrong : {5, 1000000, -1}) {
    Rows rows = Rows::from_lists({"element", 5}, std::vector<std::vector<Entry>>{{{0, 0}, {4, 0}}});
    rows.view().entries()[1].element() = wrong;
    expect_said(message_of([&] { rows.renumber(std::vector<index_t>{4, 3, 2, 1, 0}, 5); }),
                "entry 1 has element = " + std::to_string(wrong) + ", of 5 objects");
    EXPECT_EQ(std::int32_t{rows.view().entries()[0].element()}, 0);
  }
}

TEST(RowArrays, of_one_set_follow_its_order_on_both_sides) {
  // A ring of 50 objects, each a neighbour of two.
  Pairs pairs;
  for (std::int32_t i = 0; i < 50; ++i) {
    pairs.push_back({i, {(i + 1) % 50, 0}});
    pairs.push_back({i, {(i + 49) % 50, 0}});
  }
  Rows rows = Rows::from_pairs({"element", 50}, 50, pairs);
  std::mt19937 random(seed());
  const auto order = random_order(50, random);
  rows.permute(order);
  rows.renumber(inverse(order), 50);
  const auto model = objects_of_rows(rows);
  for (std::size_t i = 0; i < 50; ++i) {
    const auto old = [&](std::int32_t now) { return order[static_cast<std::size_t>(now)]; };
    EXPECT_EQ(old(model[i][0].element), (order[i] + 1) % 50);
    EXPECT_EQ(old(model[i][1].element), (order[i] + 49) % 50);
  }
}

TEST(Rows, count_what_names_a_target_by_adding_in_active_lanes) {
  std::mt19937 random(seed());
  const auto model = random_rows<Entry>(1003, 8, 50, random);
  const Rows rows = Rows::from_lists({"element", 50}, model);
  elasticity::RestShapeArray<float> targets(50);
  parallel_for(Host{}, 3, 1002, over<float>([rows = rows.view(), targets = targets.view()](auto i) {
                 using S = lanes_t<float, decltype(i)>;
                 using math::select;
                 rows.for_each(i, [&](const auto& entry, const auto& active) {
                   const lanes_t<std::int32_t, decltype(i)> target = entry.element();
                   add(i, targets[target].volume(), select(active, S(1), S(0)));
                 });
               }));
  std::vector<float> expected(50, 0);
  for (std::size_t i = 3; i < 1002; ++i) {
    for (const Entry& entry : model[i]) ++expected[static_cast<std::size_t>(entry.element)];
  }
  for (index_t t = 0; t < 50; ++t) EXPECT_EQ(targets.view()[t].volume(), expected[static_cast<std::size_t>(t)]);
}

TEST(Rows, show_entries_that_are_not_written) {
  Rows rows = Rows::from_lists({"element", 5}, std::vector<std::vector<Entry>>{{{0, 0}, {4, 7}}});
  std::int32_t last = 0;
  rows.view().for_each(0, [&](const auto& entry, bool /*active*/) {
    static_assert(std::is_same_v<decltype(entry.local()), const std::int32_t&>);
    last = entry.local();
  });
  EXPECT_EQ(last, 7);
}

TEST(Rows, tell_a_kernel_that_was_given_those_of_other_sets) {
  const Rows rows = Rows::from_lists({"element", 5}, std::vector<std::vector<Entry>>(3));
  rows.view().require("Gather: node_tets", 3, 5);
  for (const auto& [size, targets] : {std::pair<index_t, index_t>{3, 6}, {4, 5}}) {
    expect_said(message_of([&] { rows.view().require("Gather: node_tets", size, targets); }),
                "Gather: node_tets has 3 rows of entries that name one of 5 objects; here there are " +
                    std::to_string(size) + " objects with rows and " + std::to_string(targets) +
                    " to be named. Give the rows that were made for these two sets");
  }
}

}  // namespace
}  // namespace physgen::test
