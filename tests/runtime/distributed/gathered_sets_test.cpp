// Steps over sets that all ranks have, from objects of which ranks have parts: what they refuse, and when each rank
// does a part of them. Random graphs have their bits on several ranks.
#include "steps.h"

namespace physgen {
namespace {

/// Groups of nodes, which all ranks have.
class GatheredSets : public Steps {
 protected:
  GatheredSets() {
    make_sets(true);
    arrays.add_replicated_set("group", 10);
    arrays.add("b.totals", "group", totals);
    arrays.add("b.group_ranges", "group", group_ranges);
    arrays.add("b.homes", "node", homes);
    arrays.add("b.anchors", "group", anchors);
    arrays.connect(anchors, "nodes", "node", [](index_t group) { return std::array{10 * group, 10 * group + 9}; });
    arrays.connect(homes, "nodes", "group", [](index_t node) { return std::array{node / 10, node % 10}; });
    arrays.add("b.twins", "node", twins);
    arrays.connect(twins, "nodes", "node", [](index_t node) { return std::array{node, 99 - node}; });
    arrays.connect_rows(group_ranges, "b.members", members, "element", "node", [](index_t group) {
      std::vector<elasticity::Incidence<float>> row(2);
      for (std::size_t k = 0; k < 2; ++k) row[k].element = static_cast<std::int32_t>(10 * group) + static_cast<int>(k);
      return row;
    });
    arrays.cut();
  }
  [[nodiscard]] std::string totals_of(HaloSteps::Way way) {
    return step(
        "Totals",
        {of(group_ranges.const_view()), of(members.const_view()), of(positions.const_view()), of(totals.view())}, 10,
        way);
  }
  elasticity::NodeForceArray<float> totals;
  elasticity::IncidenceRangeArray<float> group_ranges;
  elasticity::IncidenceArray<float> members;
  elasticity::EdgeArray<float> homes, anchors, twins;
};

TEST_F(GatheredSets, are_computed_in_parts_where_a_kernel_reads_parts) {
  EXPECT_EQ(totals_of(HaloSteps::Way::run), "0 to 10");
  EXPECT_EQ(arrays.transport().traffic().gathers, 0);
  // One gather of what was written; also where no more than the lengths of rows is asked for, which a rank has of those
  // groups alone that it computes; and none where groups read groups alone.
  HaloSteps steps(arrays, true);
  const auto gathers_of = [&](const std::string& name, std::vector<KernelView> views) {
    const HaloSteps::Kernel kernel{&name, std::move(views)};
    const index_t before = arrays.transport().traffic().gathers;
    (void)steps.begin(std::span(&kernel, 1), 10, HaloSteps::Way::run);
    steps.end();
    return arrays.transport().traffic().gathers - before;
  };
  const std::string totals_kernel = "Totals", lengths = "Lengths", settles = "Settles";
  EXPECT_EQ(gathers_of(totals_kernel, {of(group_ranges.const_view()), of(members.const_view()),
                                       of(positions.const_view()), of(totals.view())}),
            1);
  EXPECT_EQ(gathers_of(lengths, {of(group_ranges.const_view()), of(totals.view())}), 1);
  EXPECT_EQ(gathers_of(settles, {of(totals.view())}), 0);
}

TEST_F(GatheredSets, are_not_reduced_and_not_done_by_code_that_is_not_split) {
  const std::string remedy =
      " over set group, which all ranks have, and reads others of which ranks have parts; let a kernel that is run "
      "write what it reads of these into an array of the set";
  EXPECT_EQ(totals_of(HaloSteps::Way::reduce), "physgen: Totals is reduced" + remedy);
  EXPECT_EQ(totals_of(HaloSteps::Way::at_once), "physgen: Totals is done by code of the program's own" + remedy);
}

TEST_F(GatheredSets, are_not_computed_by_kernels_of_which_the_table_does_not_say_all) {
  const std::string refused =
      " runs over the objects of set group, which all ranks have, and uses others of which ranks have parts; give all "
      "its views rows in the table of kernels";
  EXPECT_EQ(step("not in the table", {of(group_ranges.const_view()), of(totals.view())}, 10),
            "physgen: not in the table" + refused);
  EXPECT_EQ(step("not in the table", {of(positions.const_view()), of(totals.view())}, 10),
            "physgen: not in the table" + refused);
  EXPECT_EQ(step("Settles", {of(totals.view()), of(positions.const_view())}, 10), "physgen: Settles" + refused);
}

TEST_F(GatheredSets, give_their_rows_to_no_other_set) {
  EXPECT_EQ(step("Asks", {of(homes.const_view()), of(group_ranges.const_view())}, 100),
            "physgen: Asks reads b.group_ranges.end of other objects, which a rank has of those objects of set group "
            "alone that it computes; let a kernel over this set read it of its own objects");
  EXPECT_EQ(step("AddsTotals", {of(group_ranges.const_view()), of(totals.view())}, 10),
            "physgen: AddsTotals writes b.totals.f of other objects than that of its call, which all ranks have: they "
            "would differ; reduce instead");
}

TEST_F(GatheredSets, are_named_by_ghosts_as_by_others) {
  EXPECT_EQ(step("NamesOfEnds", {of(edges.const_view()), of(homes.const_view())}, 60), "0 to 60");
  EXPECT_EQ(step("NamesOfEnds", {of(edges.const_view()), of(twins.const_view())}, 60),
            "physgen: NamesOfEnds reads b.twins.nodes of other objects, whose set node follows no set, so that ranks "
            "have neither their rows nor all that they name; let it follow one");
}

TEST_F(GatheredSets, give_out_no_numbers_that_one_rank_knows) {
  EXPECT_EQ(message_of([&] { (void)arrays.whole(anchors); }),
            "physgen: b.anchors.nodes is known of those objects alone that this rank computes, so that no array of all "
            "objects can have it; take another array, and these from what they were connected with");
  EXPECT_EQ(arrays.whole(homes)[index_t{99}].nodes()[0], 9);
}

TEST_F(GatheredSets, are_one_set) {
  EXPECT_EQ(step("Beside groups", {of(totals.view()), of(positions.const_view()), of(positions.const_view())}, 10),
            "physgen: Beside groups uses own objects of two sets, node and group; correct its rows in the table of "
            "kernels, or say same_set() where they have the same objects");
  EXPECT_EQ(step("Beside both", {of(totals.view()), of(state.const_view()), of(positions.const_view())}, 10),
            "physgen: Beside both uses own objects of two sets, group and one; correct its rows in the table of "
            "kernels, or say same_set() where they have the same objects");
}

}  // namespace
}  // namespace physgen
