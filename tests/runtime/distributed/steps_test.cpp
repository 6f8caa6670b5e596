// What steps of several ranks refuse, each with the place and the remedy; and over which objects they run.
#include "steps.h"

namespace physgen {
namespace {

TEST_F(Steps, run_over_the_set_of_their_own_objects) {
  cut(true);
  EXPECT_EQ(step("Gathers", {of(edges.const_view()), of(positions.const_view())}, 60), "0 to 60");
  EXPECT_EQ(step("not in the table", {of(edges.const_view()), of(positions.const_view())}, 60), "0 to 60");
  EXPECT_EQ(step("not in the table", {of(positions.view())}, 100), "0 to 100");
  EXPECT_EQ(step("of a number alone", {of(state.view())}, 1), "0 to 1");
  EXPECT_EQ(step("OfEntries", {of(ends.const_view())}, 60), "0 to 60");
  EXPECT_EQ(step("Known", {of(positions.const_view())}, 60),
            "physgen: Known is run over 60 objects, and set node has 100 here; run it over all, array.size()");
  EXPECT_EQ(
      step("not in the table", {of(positions.const_view())}, 61),
      "physgen: it is not known over which set not in the table is run: the size 61 is that of 0 sets of its views; "
      "give it rows in the table of kernels");
}

TEST_F(Steps, refuse_writes_to_objects_that_another_rank_may_own) {
  cut(true);
  EXPECT_EQ(
      step("Adds", {of(edges.const_view()), of(positions.view())}, 60),
      "physgen: Adds writes b.positions.x of other objects than that of its call, which another rank may own; gather "
      "over rows instead");
  EXPECT_EQ(
      step("not in the table", {of(edges.const_view()), of(positions.view())}, 60),
      "physgen: not in the table writes b.positions.x of other objects than that of its call, which another rank may "
      "own; gather over rows instead, or give the kernel a const_view() or rows in the table of kernels");
  EXPECT_EQ(
      step("not in the table", {of(positions.view()), of(state.view())}, 100),
      "physgen: not in the table writes b.state.f of other objects than that of its call, which all ranks have: they "
      "would differ; reduce instead, or give the kernel a const_view() or rows in the table of kernels");
  elasticity::NodeForceArray<double> number(1);
  EXPECT_EQ(
      step("not in the table", {of(positions.view()), of(number.view())}, 100),
      "physgen: not in the table may write numbers that all ranks keep, in a step of which each rank does a part; "
      "reduce instead, or give the kernel a const_view() or rows in the table of kernels");
  EXPECT_EQ(step("Renumbers", {of(edges.view())}, 60),
            "physgen: Renumbers writes b.edges.nodes, which names objects by the numbers of this rank; connect other "
            "arrays instead");
}

TEST_F(Steps, refuse_what_they_cannot_reach_or_attribute) {
  cut(false);
  EXPECT_EQ(
      step("Far", {of(ranges.const_view()), of(positions.const_view())}, 100),
      "physgen: Far reads b.positions.x through b.edges.nodes of other objects, whose set follows no set, so that "
      "what they name may be on other ranks; let it follow one");
  EXPECT_EQ(step("Beside", {of(ranges.const_view()), of(positions.const_view())}, 100),
            "physgen: Beside reads b.positions.x of other objects by numbers that no connected index field has, and "
            "which of them are on this rank is not known; let an index field name them, and connect() it");
  EXPECT_EQ(
      step("not in the table", {of(ranges.const_view()), of(edges.const_view())}, 100),
      "physgen: not in the table may read through b.edges.nodes of other objects, whose set follows no set, so that "
      "what they name may be on other ranks; give the kernel rows in the table of kernels, or let the set follow one");
  EXPECT_EQ(step("OfTwo", {of(positions.const_view()), of(edges.const_view())}, 100),
            "physgen: OfTwo uses own objects of two sets, node and edge; correct its rows in the table of kernels, "
            "or say same_set() where they have the same objects");
  EXPECT_EQ(
      step("OfOne", {of(state.const_view()), of(positions.const_view())}, 1),
      "physgen: OfOne runs over the objects of b.state, which all ranks have, and uses b.positions, of which "
      "ranks have parts of set node; connect an index field of set one by which it finds these, or reduce what is "
      "wanted of them");
  EXPECT_EQ(
      step("OfEntries", {of(ends.const_view())}, 60, HaloSteps::Way::reduce),
      "physgen: OfEntries is reduced over the entries of rows, b.ends, which have no blocks that all numbers of ranks "
      "have; reduce over the objects that have the rows");
  EXPECT_EQ(step("RowsOfOthers", {of(edges.const_view()), of(ranges.const_view())}, 60),
            "physgen: RowsOfOthers reads b.ranges.begin of other objects, whose set node follows no set, so that ranks "
            "have neither their rows nor all that they name; let it follow one");
  elasticity::NodeForceArray<double> other(7);
  EXPECT_EQ(
      step("not in the table", {of(positions.const_view()), of(other.const_view())}, 100),
      "physgen: not in the table uses an array of 7 elasticity::NodeForce that is none of the distributed arrays; "
      "add() it before cut()");
  HaloSteps steps(arrays, true);
  const KernelView view = of(positions.const_view());
  EXPECT_EQ(message_of([&] { steps.require_replicated(std::span(&view, 1), "StoreSquare"); }),
            "physgen: StoreSquare uses b.positions, of which ranks have parts of set node; let a kernel reduce what is "
            "wanted into an array that all ranks have");
}

TEST_F(Steps, leave_stale_what_they_may_write_in_part) {
  cut(true);
  EXPECT_TRUE(is_fresh_behind("Sets", {of(positions.view())}, positions));
  arrays.owned_changed(positions);
  EXPECT_FALSE(is_fresh_behind("Sets", {of(positions.view())}, positions));
}

TEST_F(Steps, are_not_done_for_ghosts_that_have_no_rows) {
  cut(true);
  EXPECT_FALSE(is_fresh_behind("Degree", {of(ranges.const_view()), of(positions.view())}, positions));
}

TEST_F(Steps, refuse_numbers_of_objects_that_may_be_those_of_a_rank) {
  cut(true);
  EXPECT_EQ(step("Counts", {}, 1, HaloSteps::Way::reduce),
            "physgen: it is not known over which set Counts is run: the size 1 is that of no array that it uses and "
            "all ranks have; let it read its own object of an array that has so many, array.size()");
  for (const auto way : {HaloSteps::Way::run, HaloSteps::Way::reduce, HaloSteps::Way::at_once}) {
    EXPECT_EQ(step("OfOne", {of(state.const_view())}, 100, way),
              "physgen: it is not known over which set OfOne is run: the size 100 is that of no array that it uses and "
              "all ranks have; let it read its own object of an array that has so many, array.size()");
    EXPECT_EQ(step("OfOne", {of(state.const_view())}, 1, way), "0 to 1");
  }
}

TEST_F(Steps, refuse_a_step_that_is_begun_inside_of_another) {
  cut(true);
  const std::string outer = "Sets", inner = "Known";
  const HaloSteps::Kernel sets{&outer, {of(positions.view())}}, known{&inner, {of(positions.const_view())}};
  HaloSteps steps(arrays, true);
  const auto begin = [&](const HaloSteps::Kernel& one) {
    return message_of([&] { (void)steps.begin(std::span(&one, 1), 100, HaloSteps::Way::run); });
  };
  EXPECT_EQ(begin(sets), "accepted");
  EXPECT_EQ(
      begin(known),
      "physgen: Known is begun inside of the step of Sets, behind which it is not known yet what is fresh; run it "
      "behind that step");
  steps.end();
  EXPECT_EQ(begin(known), "accepted");
}

TEST_F(Steps, follow_arrays_that_a_program_moves_and_swaps) {
  cut(true);
  const int number = arrays.find(positions.untyped().base);
  elasticity::NodePositionArray<float> moved = std::move(positions);
  EXPECT_EQ(arrays.find(moved.untyped().base), number);
  EXPECT_EQ(step("Known", {of(moved.const_view())}, 100), "0 to 100");
}

TEST_F(Steps, know_which_array_was_changed_behind_a_swap) {
  make_sets(true);
  elasticity::NodePositionArray<float> before;
  arrays.add("b.before", "node", before);
  arrays.cut();
  std::swap(positions, before);
  arrays.owned_changed(positions);
  EXPECT_FALSE(is_fresh(positions));
  EXPECT_TRUE(is_fresh(before));
  arrays.fill(positions, [](index_t) { return elasticity::NodePosition<float>{}; });
  EXPECT_TRUE(is_fresh(positions));
  before = elasticity::NodePositionArray<float>(100);
  EXPECT_EQ(message_of([&] { arrays.owned_changed(before); }),
            "physgen: an array has other memory than cut() gave the distributed arrays; fill the array that has this "
            "memory, and resize or assign none behind cut()");
}

TEST_F(Steps, refuse_sets_and_arrays_that_cannot_be) {
  make_sets(true);
  EXPECT_EQ(message_of([&] { arrays.add_set("node", 5); }),
            "physgen: there are two sets node; give each a name of its own");
  EXPECT_EQ(message_of([&] { arrays.add_set("tet", -5); }),
            "physgen: set tet has -5 objects; give a number that is not negative");
  EXPECT_EQ(
      message_of([&] { arrays.follow("node", "edge"); }),
      "physgen: set node follows edge, and one of them follows another set or is followed; let a set follow one that "
      "follows none");
  EXPECT_EQ(message_of([&] { arrays.follow("node", "one"); }),
            "physgen: set node cannot follow one, since all ranks have all objects of one of them; remove follow()");
  EXPECT_EQ(message_of([&] { arrays.add("again", "node", positions); }),
            "physgen: array again is added a second time, before as b.positions; add each array once");
  EXPECT_EQ(message_of([&] { (void)arrays.set("tet"); }),
            "physgen: there is no set tet; there are: node edge one b.ends");
  EXPECT_EQ(message_of([&] { (void)arrays.set("node"); }),
            "physgen: set node has no local numbers; call cut() first, and ask for sets of objects");
  EXPECT_NE(message_of([&] {
              arrays.connect(positions, "x", "node", [](index_t) { return std::array{0}; });
            }).find("there is no field of indices \"x\"; the object has none"),
            std::string::npos);
}

TEST_F(Steps, refuse_numbers_of_objects_that_are_not_there) {
  make_sets(true);
  elasticity::EdgeArray<float> wrong;
  arrays.add("b.wrong", "edge", wrong);
  arrays.connect(wrong, "nodes", "node", [](index_t e) { return std::array<index_t, 2>{e, e == 40 ? 100 : 0}; });
  EXPECT_EQ(message_of([&] { arrays.cut(); }),
            "physgen: object 40 names object 100 of set node, which has 100; name one of 0 .. size-1, or -1 for none");
}

TEST_F(Steps, refuse_a_field_that_is_given_too_few_numbers) {
  make_sets(true);
  elasticity::TetArray<float> tets;
  arrays.add("b.tets", "edge", tets);
  arrays.connect(tets, "nodes", "node", [](index_t e) { return std::array{e, e + 1, e + 2}; });
  EXPECT_EQ(message_of([&] { arrays.cut(); }),
            "physgen: b.tets.nodes of object 0 has 4 elements, and 3 numbers were given; give one for each");
}

TEST_F(Steps, hand_out_objects_by_blocks_in_order) {
  cut(true);
  arrays.fill(positions, [](index_t node) {
    elasticity::NodePosition<float> value{};
    value.x[1] = static_cast<float>(node);
    return value;
  });
  index_t next = 0;
  arrays.each_block(positions, [&](index_t first, auto view) {
    for (index_t i = 0; i < view.size(); ++i) EXPECT_EQ(float(view[i].x()[1]), float(next++)) << first;
  });
  EXPECT_EQ(next, 100);
}

TEST_F(Steps, take_whole_arrays_in_other_layouts_and_give_them_back) {
  cut(true);
  elasticity::NodePositionArray<double, Host, Soa> whole(100);
  for (index_t i = 0; i < 100; ++i) whole[i].x()[2] = static_cast<double>(i) / 4;
  arrays.fill(positions, whole);
  const auto back = arrays.whole(positions);
  ASSERT_EQ(back.size(), 100);
  for (index_t i = 0; i < 100; ++i) EXPECT_EQ(back.getdata(i, 2), static_cast<double>(i) / 4);
  whole.resize(99);
  EXPECT_EQ(message_of([&] { arrays.fill(positions, whole); }),
            "physgen: elasticity::NodePosition: an array of 99 objects is given for a set of 100; give all objects");
}

TEST_F(Steps, leave_connected_fields_of_filled_arrays_as_they_are) {
  cut(true);
  arrays.fill(edges, [](index_t) { return elasticity::Edge<float>{}; });
  elasticity::EdgeArray<float> of_all(60);
  arrays.fill(edges, of_all);
  arrays.fill(ranges, [](index_t) { return elasticity::IncidenceRange<float>{}; });
  const auto back = arrays.whole(edges);
  for (index_t e = 0; e < 60; ++e) {
    EXPECT_EQ(edges[e].nodes()[1], e + 1);
    EXPECT_EQ(back[e].nodes()[1], e + 1);
    EXPECT_EQ(ranges[e].end() - ranges[e].begin(), 1);
  }
}

TEST_F(Steps, give_out_no_numbers_of_one_rank_and_take_no_entries_of_rows) {
  cut(true);
  EXPECT_EQ(message_of([&] { (void)arrays.whole(ranges); }),
            "physgen: b.ranges.begin is a place among the entries of this rank, so that no array of all objects can "
            "have it; take another array, and these from what they were connected with");
  EXPECT_EQ(message_of([&] { arrays.owned_changed(ends); }),
            "physgen: b.ends has entries of rows, which a rank has of ghosts, too, and which never cross; write them "
            "by a kernel that is run over them, or write an array of objects");
}

TEST_F(Steps, refuse_an_array_that_was_not_added_where_a_number_was_before) {
  cut(true);
  HaloSteps steps(arrays, true);
  const std::string name = "Known";
  const auto run = [&](const KernelView& numbers) {
    const HaloSteps::Kernel kernel{&name, {of(positions.const_view()), numbers}};
    return message_of([&] {
      (void)steps.begin(std::span(&kernel, 1), 100, HaloSteps::Way::run);
      steps.end();
    });
  };
  elasticity::NodeForceArray<double> number(1), others(100);
  EXPECT_EQ(run(of(number.const_view())), "accepted");
  EXPECT_EQ(
      run(of(others.const_view())),
      "physgen: Known uses an array of 100 elasticity::NodeForce that is none of the distributed arrays; add() it "
      "before cut()");
}

}  // namespace
}  // namespace physgen
