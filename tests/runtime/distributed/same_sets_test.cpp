// Sets that are the same, and reductions in parts: what is refused, each with the place and the remedy.
#include "steps.h"

namespace physgen {
namespace {

TEST_F(Steps, are_of_own_objects_of_sets_that_are_the_same) {
  make_sets(true);
  elasticity::NodeForceArray<float> forces, lengths;
  arrays.add_set("edge_node", 100);
  arrays.add_set("window", 60);
  arrays.same_set("window", "edge");
  arrays.add("b.forces", "edge_node", forces);
  arrays.add("b.lengths", "window", lengths);
  arrays.same_set("edge_node", "node");
  arrays.same_set("edge_node", "node");  // said twice
  arrays.cut();
  EXPECT_EQ(&arrays.set("edge_node"), &arrays.set("node"));
  EXPECT_EQ(forces.size(), 100);
  EXPECT_EQ(lengths.size(), 60);
  EXPECT_EQ(step("OfOne", {of(forces.view()), of(positions.const_view())}, 100),
            "physgen: OfOne reads b.positions.x of other objects by numbers that no connected index field has, and "
            "which of them are on this rank is not known; let an index field name them, and connect() it");
  EXPECT_EQ(step("OfTwoNames", {of(positions.const_view()), of(forces.view())}, 100), "0 to 100");
  EXPECT_EQ(message_of([&] { arrays.same_set("one", "node"); }),
            "physgen: set one cannot be the same as node, since cut() was called; say so before it");
}

TEST_F(Steps, are_of_sets_with_equal_numbers_of_objects) {
  make_sets(true);
  arrays.add_set("edge_node", 99);
  arrays.add_set("tet", 60);
  arrays.add_set("chunk_tet", 60);
  arrays.add_set("corner", 60);
  arrays.follow("chunk_tet", "node");
  arrays.follow("corner", "tet");
  EXPECT_EQ(message_of([&] { arrays.same_set("edge_node", "node"); }),
            "physgen: set edge_node cannot be the same as node, since they have 99 and 100 objects; give both the same "
            "number, or remove same_set()");
  EXPECT_EQ(message_of([&] { arrays.same_set("one", "node"); }),
            "physgen: set one cannot be the same as node, since ranks own parts of only one of them; remove "
            "same_set()");
  for (const char* other : {"tet", "corner"}) {
    EXPECT_EQ(message_of([&] { arrays.same_set("chunk_tet", other); }),
              "physgen: set chunk_tet cannot be the same as " + std::string(other) +
                  ", since together they would follow two sets, or follow one and be followed; correct follow()");
  }
  EXPECT_EQ(message_of([&] { arrays.same_set("chunk_tet", "edge"); }), "accepted");
  EXPECT_EQ(message_of([&] { arrays.same_set("tets", "edge"); }).find("physgen: there is no set tets"), 0U);
}

TEST_F(Steps, refuse_parts_of_reductions_that_do_not_follow_each_other) {
  cut(true);
  const std::string known = "Known", other = "Gathers";
  const HaloSteps::Kernel kernel{&known, {of(positions.const_view())}};
  const HaloSteps::Kernel beside{&other, {of(edges.const_view()), of(positions.const_view())}};
  HaloSteps steps(arrays, true);
  const auto begin = [&](const HaloSteps::Kernel& one, PartOfReduction part) {
    return message_of([&] {
      (void)steps.begin_part(std::span(&one, 1), part);
      steps.end_part(part);
    });
  };
  EXPECT_EQ(begin(kernel, {50, 50, 100}),
            "physgen: a part of the reduction of Known begins at object 50 of 100, where no reduction is done up to "
            "object 0; give all parts, in ascending order, and without others between them");
  EXPECT_EQ(begin(kernel, {0, 50, 100}), "accepted");
  EXPECT_EQ(message_of([&] { (void)steps.begin(std::span(&beside, 1), 60, HaloSteps::Way::run); }),
            "physgen: Gathers runs between two parts of the reduction of Known, of which ranks may have other numbers; "
            "run it behind the last part, or reduce all in one part");
  EXPECT_EQ(begin(beside, {50, 10, 60}),
            "physgen: a part of the reduction of Gathers begins at object 50 of 60, where one of Known is done up to "
            "object 50; give all parts, in ascending order, and without others between them");
  EXPECT_EQ(begin(kernel, {50, 50, 100}), "accepted");
  EXPECT_EQ(message_of([&] { (void)steps.begin(std::span(&beside, 1), 60, HaloSteps::Way::run); }), "accepted");
}

}  // namespace
}  // namespace physgen
