// The halos of scenes with uses that are written by hand: the table, what crosses, and what is refused.
#include "scenes/halos.h"

#include <gtest/gtest.h>

#include "by_hand.h"
#include "scenes/needs.h"
#include "scenes/report_halos.h"

namespace physgen::test {
namespace {

using scenes::Issue;
using scenes::Scene;
using usage::FieldUse;
using usage::KernelUse;
using usage::Usage;

enum class Of { own, others, unknown };

FieldUse use(const std::string& array, const std::string& field, bool reads, Of objects) {
  FieldUse use = test::use(array, field, reads, {{"kernel.h", 7, 3}});
  use.own = objects == Of::own;
  use.gathered = objects == Of::others;
  (reads ? use.reads_own : use.writes_own) = use.own;
  (reads ? use.reads_others : use.writes_others) = use.gathered;
  return use;
}
FieldUse read(const std::string& array, const std::string& field, Of objects) {
  return use(array, field, true, objects);
}
FieldUse write(const std::string& array, const std::string& field, Of objects) {
  return use(array, field, false, objects);
}

/// Springs between nodes: edges name nodes, and rows of ends name edges.
Scene springs() {
  Scene scene;
  scene.name = "springs";
  scene.scope = "scenes";
  scene.include = "scenes/springs.h";
  scenes::Group body{"Body", "body", "", {}, {}};
  body.arrays = {array("x", "m::Position", "node", {{"x", "float32", 3, 12, false}}),
                 array("edges", "m::Edge", "edge", {{"nodes", "int32", 2, 8, false}}),
                 array("pulls", "m::Force", "edge", {{"f", "float32", 3, 12, false}}),
                 array("ranges", "m::Range", "node", {{"begin", "int32", 1, 4, false}, {"end", "int32", 1, 4, false}}),
                 array("ends", "m::End", "end", {{"edge", "int32", 1, 4, false}}),
                 array("state", "m::State", "", {{"sum", "float64", 1, 8, false}})};
  body.arrays[1].names = {{"nodes", "node", 0, {}}};
  body.arrays[1].follows = "node";
  body.arrays[4].names = {{"edge", "edge", 0, {}}};
  body.arrays[5].count = 1;
  scene.groups.push_back(std::move(body));
  return scene;
}

usage::StepUse step_of(KernelUse kernel) {
  usage::StepUse result = step(kernel.name, kernel.fields);
  result.kernels.push_back(std::move(kernel));
  return result;
}
KernelUse pull() {
  return {"m::Pull",
          {{"body.edges", "body.x", "body.pulls"}, {}},
          {read("body.edges", "nodes", Of::own), read("body.x", "x", Of::others), write("body.pulls", "f", Of::own)}};
}
KernelUse sum_pulls() {
  return {"m::SumPulls",
          {{"body.ranges", "body.ends", "body.pulls", "body.x"}, {{"body.ranges", "body.ends"}}},
          {read("body.ranges", "begin", Of::own), read("body.ranges", "end", Of::own),
           read("body.ends", "edge", Of::others), read("body.pulls", "f", Of::others), write("body.x", "x", Of::own)}};
}

struct Found {
  scenes::Halos halos;
  std::vector<Issue> errors;
};
Found find(const Scene& scene, std::vector<KernelUse> kernels) {
  Usage usage;
  for (KernelUse& kernel : kernels) usage.steps.push_back(step_of(std::move(kernel)));
  Found found;
  found.halos = scenes::find_halos(scene, usage, found.errors);
  return found;
}

TEST(Halos, are_what_kernels_read_through_index_fields_and_rows) {
  const Found found = find(springs(), {pull(), sum_pulls()});
  EXPECT_EQ(found.errors, std::vector<Issue>());
  EXPECT_EQ(scenes::halos_text(found.halos),
            "\nHalos:\n"
            "  m::Pull: body.x.x gathered through body.edges.nodes: exchanged if stale\n"
            "  m::SumPulls: body.ends.edge gathered through body.ranges.begin, body.ranges.end: none (rows of node)\n"
            "  m::SumPulls: body.pulls.f gathered through body.ends.edge: none (edge follows node)\n");
  EXPECT_EQ(
      scenes::halos_header(springs(), found.halos),
      R"(// What each kernel of the scene scenes::springs uses of its own objects and of others. Written by physgen from
// scenes/springs.h: change that, not this file.
#pragma once

#include <physgen/distributed/halo_uses.h>

namespace scenes::springs_scene {

inline constexpr ::physgen::HaloUse halos[] = {
    {"m::Pull", 0, "nodes", {.reads_own = true}},
    {"m::Pull", 1, "x", {.reads_others = true}, "body.edges.nodes"},
    {"m::Pull", 2, "f", {.writes_own = true}},
    {"m::SumPulls", 0, "begin", {.reads_own = true}},
    {"m::SumPulls", 0, "end", {.reads_own = true}},
    {"m::SumPulls", 1, "edge", {.reads_others = true}, "body.ranges.begin, body.ranges.end"},
    {"m::SumPulls", 2, "f", {.reads_others = true}, "body.ends.edge"},
    {"m::SumPulls", 3, "x", {.writes_own = true}},
};

}  // namespace scenes::springs_scene
)");
}

TEST(Halos, are_said_of_a_field_that_is_asked_for) {
  Found found = find(springs(), {pull(), sum_pulls()});
  EXPECT_EQ(scenes::why_text(found.halos, "body.x", "x"),
            "  crosses, if stale, before m::Pull(body.edges), which reads it through body.edges.nodes\n");
  EXPECT_EQ(
      scenes::why_text(found.halos, "body.pulls", "f"),
      "  does not cross before m::SumPulls(body.ranges), which reads it through body.ends.edge: edge follows node\n");
  EXPECT_EQ(scenes::why_text(found.halos, "body.edges", "nodes"),
            "  crosses before no step: none reads it of other objects\n");
}

TEST(Halos, are_not_looked_for_where_a_scene_states_no_names) {
  Scene scene = springs();
  for (auto& array : scene.groups[0].arrays) array.names.clear(), array.follows.clear();
  const Found found = find(scene, {pull(), sum_pulls()});
  EXPECT_EQ(found.halos, scenes::Halos());
  EXPECT_EQ(found.errors, std::vector<Issue>());
  EXPECT_EQ(scenes::halos_text(found.halos), "");
}

TEST(Halos, name_no_index_field_where_a_kernel_calculates_numbers_so_that_several_ranks_refuse_it) {
  KernelUse kernel = pull();
  kernel.calculated = {"body.x"};
  const Found found = find(springs(), {kernel});
  EXPECT_EQ(found.errors, std::vector<Issue>()) << "one process runs it";
  EXPECT_EQ(scenes::halos_text(found.halos),
            "\nHalos:\n  m::Pull: body.x.x gathered by numbers that it forms: exchanged if stale\n");
  ASSERT_EQ(found.halos.table.size(), 3U);
  EXPECT_EQ(found.halos.table[1], (scenes::HaloRow{"m::Pull", 1, "x", false, true, false, false, {}}));
}

TEST(Halos, are_not_all_where_the_program_itself_uses_what_ranks_have_parts_of) {
  Usage usage;
  usage.steps.push_back(step_of(pull()));
  usage.unattributed = {read("body.state", "sum", Of::others)};
  std::vector<Issue> errors;
  EXPECT_EQ(scenes::find_halos(springs(), usage, errors).outside, "") << "which every rank has";
  usage.unattributed.push_back(read("body.x", "x", Of::others));
  EXPECT_EQ(scenes::find_halos(springs(), usage, errors).outside, "body.x.x at kernel.h:7:3");
  EXPECT_EQ(errors, std::vector<Issue>());
}

TEST(Halos, count_a_use_that_types_do_not_tell_as_one_of_others_and_say_so) {
  KernelUse kernel = pull();
  kernel.fields[1] = read("body.x", "x", Of::unknown);
  kernel.fields[2] = write("body.pulls", "f", Of::unknown);
  const Found found = find(springs(), {kernel});
  EXPECT_EQ(found.errors, std::vector<Issue>());
  ASSERT_EQ(found.halos.unknown.size(), 1U);
  EXPECT_EQ(found.halos.unknown[0].fields, (std::vector<std::string>{"body.x.x", "body.pulls.f"}));
  ASSERT_EQ(found.halos.table.size(), 3U);
  const scenes::HaloRow &x = found.halos.table[1], &f = found.halos.table[2];
  EXPECT_TRUE(x.reads_own && x.reads_others && !x.writes_own && !x.writes_others);
  EXPECT_TRUE(f.writes_own && f.writes_others && !f.reads_own && !f.reads_others);
  ASSERT_EQ(found.halos.reads.size(), 1U);
  EXPECT_EQ(found.halos.reads[0].local, "") << "it crosses";
}

TEST(Halos, unite_the_steps_of_a_kernel_and_name_views_of_which_nothing_is_used) {
  KernelUse once = pull(), again = pull();
  again.fields[1] = read("body.x", "x", Of::own);
  once.views.arrays.push_back("body.ranges");
  const Found found = find(springs(), {once, again});
  ASSERT_EQ(found.halos.table.size(), 4U);
  EXPECT_TRUE(found.halos.table[1].reads_own && found.halos.table[1].reads_others);
  EXPECT_EQ(found.halos.table[3], (scenes::HaloRow{"m::Pull", 3, "", false, false, false, false, {}}));
}

TEST(Halos, refuse_a_read_through_an_index_field_that_does_not_say_what_it_names) {
  Scene scene = springs();
  scene.groups[0].arrays[1].names.clear();
  const Found found = find(scene, {pull()});
  ASSERT_EQ(found.errors.size(), 1U);
  EXPECT_EQ(found.errors[0].place, scene.groups[0].arrays[1].location);
  EXPECT_EQ(found.errors[0].message,
            "m::Pull(body.edges) reads body.x.x of other objects, and index field body.edges.nodes does not say whose "
            "they are; write names(\"nodes\", \"node\") at body.edges, or no_index(\"nodes\")");
  scene.groups[0].arrays[1].names = {{"nodes", "", 0, {}}};
  EXPECT_EQ(find(scene, {pull()}).errors, std::vector<Issue>()) << "it is said to be none";
}

TEST(Halos, refuse_a_write_to_other_objects_which_the_own_ones_do_not_follow) {
  KernelUse kernel = pull();
  kernel.fields.push_back(write("body.x", "x", Of::others));
  EXPECT_EQ(find(springs(), {kernel}).errors, std::vector<Issue>()) << "edges follow nodes, so owners' sums are whole";
  Scene scene = springs();
  scene.groups[0].arrays[1].follows.clear();
  const Found found = find(scene, {kernel});
  ASSERT_EQ(found.errors.size(), 1U);
  EXPECT_EQ(found.errors[0].place, (scenes::Location{"kernel.h", 7, 3}));
  EXPECT_EQ(found.errors[0].message,
            "m::Pull writes body.x.x of other objects than its own, over edge, so that ranks would write each other's; "
            "declare follows(\"node\") of the set that it runs over, or gather at each node");
}

TEST(Halos, know_what_a_kernel_runs_over_whose_own_fields_are_those_of_kernels_fused_with_it) {
  const KernelUse add{"m::Add", {{"body.x"}, {}}, {write("body.x", "x", Of::others)}};
  EXPECT_NE(find(springs(), {add}).errors, std::vector<Issue>()) << "by itself it may run over anything";
  Usage usage;
  usage.steps.push_back(step_of(pull()));
  usage.steps.back().kernels.push_back(add);
  std::vector<Issue> errors;
  (void)scenes::find_halos(springs(), usage, errors);
  EXPECT_EQ(errors, std::vector<Issue>());
}

TEST(Halos, are_none_of_what_every_rank_has) {
  KernelUse kernel{
      "m::Add", {{"body.state"}, {}}, {read("body.state", "sum", Of::others), write("body.state", "sum", Of::others)}};
  const Found found = find(springs(), {kernel});
  EXPECT_EQ(found.errors, std::vector<Issue>());
  EXPECT_TRUE(found.halos.reads.empty());
}

}  // namespace
}  // namespace physgen::test
