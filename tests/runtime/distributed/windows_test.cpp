// Arrays of a window of a set, which steps fill and read a window at a time.
#include "steps.h"

namespace physgen {
namespace {

class Windows : public Steps {
 protected:
  void cut_with_window(bool follows, index_t most) {
    make_sets(follows);
    arrays.add_window("b.pulls", "edge", pulls, most);
    arrays.add("b.means", "node", means);
    arrays.cut();
    pull.views = {of(edges.const_view()), of(positions.const_view()), of(pulls.view())};
    sum.views = {of(ranges.const_view()), of(ends.const_view()), of(pulls.const_view()), of(means.view())};
    move.views = {of(ranges.const_view()), of(ends.const_view()), of(pulls.const_view()), of(positions.view())};
    other.views = {of(edges.const_view()), of(positions.const_view())};
  }
  /// "accepted", or why a step is not.
  std::string run(HaloSteps& steps, const HaloSteps::Kernel& kernel, index_t size,
                  HaloSteps::Way way = HaloSteps::Way::run) {
    return message_of([&] {
      const HaloSteps::Objects objects = steps.begin(std::span(&kernel, 1), size, way);
      EXPECT_EQ(objects.begin, 0);
      EXPECT_EQ(objects.end, size);
      steps.end();
    });
  }
  std::string part(HaloSteps& steps, const HaloSteps::Kernel& kernel, const PartOfReduction& part) {
    return message_of([&] {
      (void)steps.begin_part(std::span(&kernel, 1), part);
      steps.end_part(part);
    });
  }

  elasticity::NodeForceArray<double> pulls;
  elasticity::NodePositionArray<double> means;
  const std::string pulls_name = "Pulls", sums_name = "SumsPulls", other_name = "Gathers", without_rows = "NoRows";
  HaloSteps::Kernel pull{&pulls_name, {}}, sum{&sums_name, {}}, move{&sums_name, {}}, other{&other_name, {}};
};

TEST_F(Windows, have_so_many_objects_and_steps_over_them_no_more) {
  cut_with_window(true, 20);
  EXPECT_EQ(pulls.size(), 20);
  HaloSteps steps(arrays, true);
  for (const index_t size : {20, 7, 0}) EXPECT_EQ(run(steps, pull, size), "accepted") << size;
  for (const index_t size : {100, 3}) EXPECT_EQ(run(steps, sum, size), "accepted") << size;
  EXPECT_NE(run(steps, pull, 61), "accepted") << "more than there are edges";
  EXPECT_EQ(
      run(steps, pull, 21),
      "physgen: Pulls writes a window of set edge, which has 20 objects, and is run over 21; run it over a window at "
      "a time");
  EXPECT_EQ(run(steps, other, 20),
            "physgen: Gathers is run over 20 objects, and set edge has 60 here; run it over all, array.size()");
}

TEST_F(Windows, are_no_larger_than_their_set) {
  cut_with_window(true, 2048);
  EXPECT_EQ(pulls.size(), 60);
}

TEST_F(Windows, are_reduced_in_parts_between_which_steps_read_them) {
  cut_with_window(true, 20);
  HaloSteps steps(arrays, true);
  EXPECT_EQ(run(steps, pull, 20, HaloSteps::Way::reduce),
            "physgen: Pulls has a view of a window of a set, and is reduced at once; reduce it in parts of a window, "
            "reduce_part()");
  EXPECT_EQ(
      run(steps, pull, 20, HaloSteps::Way::at_once),
      "physgen: Pulls has a view of a window of a set, and is done by code that is not split; let a kernel be run");
  EXPECT_EQ(part(steps, pull, {0, 21, 60}),
            "physgen: a part of the reduction of Pulls has 21 objects, and a window 20; make parts no larger than the "
            "window");
  EXPECT_EQ(part(steps, pull, {0, 0, 60}), "accepted") << "an empty one, where another rank has more";
  EXPECT_EQ(run(steps, sum, 0), "accepted");
  EXPECT_EQ(part(steps, pull, {0, 20, 60}), "accepted");
  EXPECT_EQ(run(steps, sum, 100), "accepted");
  EXPECT_NE(run(steps, other, 60), "accepted") << "it has no window, so ranks may run it another number of times";
  EXPECT_EQ(part(steps, pull, {20, 20, 60}), "accepted");
  EXPECT_EQ(run(steps, sum, 50), "accepted");
  EXPECT_EQ(part(steps, pull, {40, 20, 60}), "accepted");
  EXPECT_EQ(run(steps, sum, 50), "accepted");
  EXPECT_EQ(run(steps, other, 60), "accepted");
  // A reduction without a window lets nothing run between its parts.
  EXPECT_EQ(part(steps, other, {0, 20, 60}), "accepted");
  EXPECT_NE(run(steps, sum, 100), "accepted");
}

TEST_F(Windows, are_not_reduced_further_behind_a_step_that_wrote_what_is_read_of_others) {
  cut_with_window(true, 20);
  HaloSteps steps(arrays, true);
  EXPECT_EQ(part(steps, pull, {0, 20, 60}), "accepted");
  EXPECT_EQ(run(steps, move, 100), "accepted");
  EXPECT_EQ(
      part(steps, pull, {20, 20, 60}),
      "physgen: a step between two parts of the reduction of Pulls wrote b.positions.x, which later parts read of "
      "other ranks' objects; write it behind the last part");
}

TEST_F(Windows, are_computed_for_ghosts_or_refused) {
  cut_with_window(true, 20);
  const HaloSteps::Kernel unknown{&without_rows, pull.views};
  HaloSteps steps(arrays, true);
  const std::string of_part = run(steps, unknown, 20), said = run(steps, unknown, 60);
  EXPECT_NE(of_part.find("it is not known over which set NoRows is run"), std::string::npos) << of_part;
  EXPECT_NE(said.find("writes a window of set edge, and what it reads is not here for ghosts, too"), std::string::npos)
      << said;
}

TEST_F(Windows, of_sets_that_follow_none_are_refused) {
  cut_with_window(false, 20);
  HaloSteps steps(arrays, true);
  const std::string said = run(steps, pull, 20);
  EXPECT_NE(said.find("let the set follow the one that its objects name"), std::string::npos) << said;
}

TEST_F(Windows, are_not_filled_and_not_handed_out) {
  cut_with_window(true, 20);
  const std::string has = "physgen: b.pulls has a window of set edge";
  const auto value = [](index_t /*edge*/) { return elasticity::NodeForce<double>{}; };
  EXPECT_EQ(message_of([&] { arrays.fill(pulls, value); }).find(has), 0U);
  EXPECT_EQ(message_of([&] { arrays.owned_changed(pulls); }).find(has), 0U);
  EXPECT_EQ(message_of([&] { (void)arrays.whole(pulls); }).find(has), 0U);
  EXPECT_EQ(message_of([&] { (void)arrays.objects_of(pulls); }).find(has), 0U);
  EXPECT_EQ(message_of([&] { (void)arrays.global_numbers(pulls); }).find(has), 0U);
}

}  // namespace
}  // namespace physgen
