// The rules of what a scene needs, over uses that are written by hand: each with the fault that it is there for.
#include "scenes/needs.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "by_hand.h"
#include "scenes/report.h"

namespace physgen::test {
namespace {

using scenes::find_needs;
using scenes::Needs;
using scenes::Scene;
using usage::Usage;

/// The issues of the scene and of the program, in one line each.
std::string issues(const Scene& scene, const Usage& usage) {
  std::string text;
  for (const auto& issue : find_needs(scene, usage).issues) text += scenes::text_of(issue);
  return text;
}

std::vector<std::string> kept(const Needs& needs) {
  std::vector<std::string> names;
  for (const auto& array : needs.arrays)
    for (const auto& field : array.fields)
      if (field.kept) names.push_back(array.array + "." + field.field.name);
  return names;
}

using Names = std::vector<std::string>;

TEST(SceneNeeds, keep_what_outputs_depend_on_and_prune_what_is_written_in_vain) {
  const Needs needs = find_needs(chain(), chain_usage());
  EXPECT_TRUE(needs.sound());
  EXPECT_EQ(kept(needs), (Names{"body.x.x", "body.svd.s", "body.f.f"}));
  EXPECT_EQ(needs.of("body.svd").fields[0].why, "written by Svd(body.x, body.svd); nothing reads it");
  EXPECT_TRUE(needs.of("body.x").read_only);
  EXPECT_FALSE(needs.of("body.svd").read_only);
  EXPECT_EQ(issues(chain(), chain_usage()),
            "svd.h:4:9: note: field U of body.svd is pruned: Svd(body.x, body.svd) writes it, and nothing reads it\n"
            "chain.h:10:3: note: array body.extra is left out: no field of it is needed\n");
}

TEST(SceneNeeds, name_a_step_once_that_reads_and_writes_a_field_at_the_same_places) {
  Usage usage = chain_usage();
  usage.steps.push_back(step("Scale", {use("body.svd", "s", true, {{"scale.h", 2, 5}, {"scale.h", 3, 5}})}));
  usage.steps.back().fields.front().written = true;
  usage.steps.back().fields.front().written_places = {{"scale.h", 2, 5}, {"scale.h", 3, 5}};
  EXPECT_EQ(report_why(chain(), find_needs(chain(), usage), "svd.s"),
            "body.svd.s of m::Svd is kept: written by Svd(body.x, body.svd) and Scale(body.svd); read by "
            "Force(body.svd, body.f) and Scale(body.svd)\n"
            "  written by Svd(body.x, body.svd)\n    at svd.h:5:9\n"
            "  read and written by Scale(body.svd)\n    at scale.h:2:5\n    at scale.h:3:5\n"
            "  read by Force(body.svd, body.f)\n    at force.h:6:1\n");
}

TEST(SceneNeeds, keep_apart_where_a_step_reads_a_field_and_where_it_writes_it) {
  Usage usage = chain_usage();
  usage.steps.push_back(step("Scale", {use("body.svd", "s", true, {{"scale.h", 2, 5}})}));
  add(usage.steps.back().fields, use("body.svd", "s", false, {{"scale.h", 3, 5}}));
  const Needs needs = find_needs(chain(), usage);
  const auto json = nlohmann::json::parse(scenes::report_json(chain(), needs));
  EXPECT_EQ(json.at("format"), 3);
  const auto& s = json.at("arrays").at(1).at("fields").at(1);
  EXPECT_EQ(s.at("read_by").at(1).at("places"), nlohmann::json({"scale.h:2:5"}));
  EXPECT_EQ(s.at("written_by").at(1).at("places"), nlohmann::json({"scale.h:3:5"}));
  const std::string why = report_why(chain(), needs, "svd.s");
  EXPECT_NE(why.find("  written by Scale(body.svd)\n    at scale.h:3:5\n"), std::string::npos) << why;
  EXPECT_NE(why.find("  read by Scale(body.svd)\n    at scale.h:2:5\n"), std::string::npos) << why;
}

/// The chain with a step that advances `s` of svd before Svd writes it, as far as the analysis is told.
Usage with_early_read(bool whole_object) {
  Usage usage = chain_usage();
  usage.early_reads.push_back(
      {"body.svd", "s", step("Scale", {reads("body.svd", "s")}), {"scale.h", 2, 5}, whole_object});
  usage.early_reads.back().step.fields.clear();
  return usage;
}

TEST(SceneNeeds, note_a_field_that_a_step_reads_before_any_step_has_written_it) {
  const std::string note =
      "field s of body.svd is read by Scale(body.svd) before any step has written it; declare input(\"s\") where "
      "body.svd is declared, or run a step before it that writes it";
  const Needs needs = find_needs(chain(), with_early_read(false));
  EXPECT_TRUE(needs.sound());
  const std::string said = issues(chain(), with_early_read(false));
  EXPECT_NE(said.find("scale.h:2:5: note: " + note + "\n"), std::string::npos) << said;
  const std::string text = scenes::report_text(chain(), needs);
  EXPECT_NE(text.find("\nRead before written:\n  scale.h:2:5: " + note + "\n"), std::string::npos) << text;
  const auto json = nlohmann::json::parse(scenes::report_json(chain(), needs));
  EXPECT_EQ(json.at("read_too_early"), nlohmann::json::array({{{"array", "body.svd"},
                                                               {"fields", {"s"}},
                                                               {"step", "Scale(body.svd)"},
                                                               {"place", "scale.h:2:5"},
                                                               {"note", note}}}));
}

TEST(SceneNeeds, note_no_early_read_of_what_has_a_value_or_of_whole_objects_with_several_fields) {
  Scene scene = chain();
  scene.groups[0].arrays[1].input = scenes::Selection{false, {"s"}, {"chain.h", 5, 5}};
  EXPECT_TRUE(find_needs(scene, with_early_read(false)).read_too_early.empty());
  scene = chain();
  scene.groups[0].arrays[1].fields[1].initial = true;
  EXPECT_TRUE(find_needs(scene, with_early_read(false)).read_too_early.empty());
  EXPECT_TRUE(find_needs(chain(), with_early_read(true)).read_too_early.empty());
  Usage usage = chain_usage();
  usage.early_reads.push_back({"body.f", "f", {}, {}, true});
  const Needs needs = find_needs(chain(), usage);
  ASSERT_EQ(needs.read_too_early.size(), 1U) << "a get() of an object's only field";
  EXPECT_EQ(needs.read_too_early[0].step, "code outside of steps");
}

TEST(SceneNeeds, do_not_depend_on_the_order_of_steps) {
  Usage usage = chain_usage();
  std::reverse(usage.steps.begin(), usage.steps.end());
  EXPECT_EQ(kept(find_needs(chain(), usage)), (Names{"body.x.x", "body.svd.s", "body.f.f"}));
}

TEST(SceneNeeds, go_round_loops_through_as_many_steps_as_there_are) {
  // f <- svd.s <- svd.U <- f: everything is live, however late in the list of steps.
  Usage usage = chain_usage();
  usage.steps.push_back(step("Turn", {writes("body.svd", "s"), reads("body.svd", "U")}));
  usage.steps.push_back(step("Back", {writes("body.svd", "U"), reads("body.f", "f")}));
  EXPECT_EQ(kept(find_needs(chain(), usage)), (Names{"body.x.x", "body.svd.U", "body.svd.s", "body.f.f"}));
}

TEST(SceneNeeds, refuse_a_field_that_is_read_and_never_written) {
  Usage usage = chain_usage();
  usage.steps[1].fields.push_back(reads("body.extra", "a"));
  EXPECT_EQ(
      issues(chain(), usage),
      "force.h:7:3: error: field a of body.extra is read by Force(body.svd, body.f), and no step writes it; declare "
      "input(\"a\") where body.extra is declared, or run the step that computes it\n"
      "svd.h:4:9: note: field U of body.svd is pruned: Svd(body.x, body.svd) writes it, and nothing reads it\n");
}

TEST(SceneNeeds, take_an_initial_value_for_a_write) {
  Usage usage = chain_usage();
  usage.steps[1].fields.push_back(reads("body.extra", "a"));
  Scene scene = chain();
  scene.groups[0].arrays[3].fields[0].initial = true;
  EXPECT_TRUE(find_needs(scene, usage).sound());
}

TEST(SceneNeeds, do_not_count_what_a_dead_step_writes) {
  // The step that writes extra.a is dead but for the one that reads it: together they feed only each other.
  Usage usage = chain_usage();
  usage.steps.push_back(step("A", {writes("body.extra", "a"), reads("body.extra", "b")}));
  usage.steps.push_back(step("B", {writes("body.extra", "b"), reads("body.extra", "a")}));
  const std::string said = issues(chain(), usage);
  EXPECT_NE(
      said.find("error: the step A(body.extra) writes only body.extra.a, which nothing that is wanted depends on; "
                "take the step out of the program, or declare what it writes output(...)\n"),
      std::string::npos)
      << said;
  EXPECT_NE(said.find("error: the step B(body.extra) writes only body.extra.b,"), std::string::npos) << said;
}

TEST(SceneNeeds, refuse_a_step_that_writes_nothing) {
  Usage usage = chain_usage();
  usage.steps.push_back(step("Look", {reads("body.svd", "U")}));
  EXPECT_NE(issues(chain(), usage).find("error: the step Look(body.svd) writes no field; take it out of the program\n"),
            std::string::npos);
}

TEST(SceneNeeds, keep_what_a_root_reads_although_it_writes_nothing) {
  Usage usage = chain_usage();
  usage.steps.push_back(step("Done", {reads("body.svd", "U")}));
  usage.steps.back().root = true;
  EXPECT_EQ(kept(find_needs(chain(), usage)), (Names{"body.x.x", "body.svd.U", "body.svd.s", "body.f.f"}));
}

TEST(SceneNeeds, keep_what_code_outside_of_steps_reads_and_take_what_it_writes_for_written) {
  Usage usage = chain_usage();
  usage.unattributed = {reads("body.svd", "U"), writes("body.extra", "b"), reads("body.extra", "b")};
  const Needs needs = find_needs(chain(), usage);
  EXPECT_TRUE(needs.sound());
  EXPECT_EQ(kept(needs), (Names{"body.x.x", "body.svd.U", "body.svd.s", "body.f.f", "body.extra.b"}));
  EXPECT_NE(needs.of("body.extra").fields[1].why.find("code outside of steps"), std::string::npos);
}

TEST(SceneNeeds, take_an_address_for_a_read_and_a_write) {
  Usage usage = chain_usage();
  auto& use = usage.steps[0].fields[1];
  ASSERT_EQ(use.field, "U");
  use.written = false;
  use.address_taken = true;
  EXPECT_EQ(kept(find_needs(chain(), usage)), (Names{"body.x.x", "body.svd.U", "body.svd.s", "body.f.f"}));
}

TEST(SceneNeeds, refuse_an_output_that_no_step_writes) {
  Scene scene = chain();
  scene.groups[0].arrays[3].output = scenes::Selection{false, {"b"}, {"chain.h", 12, 5}};
  EXPECT_EQ(
      issues(scene, chain_usage()).substr(0, 128),
      "chain.h:12:5: error: the output body.extra.b is written by no step; run the step that computes it, or name "
      "it no output\nsvd.h:4:");
  scene.groups[0].arrays[3].output = scenes::Selection{true, {}, {"chain.h", 12, 5}};
  EXPECT_EQ(issues(scene, chain_usage()).substr(0, 121),
            "chain.h:12:5: error: the output body.extra is written by no step; run the step that computes it, or take "
            "output() away\nsv");
  // An input that is named an output is one only if it is written, too.
  scene = chain();
  scene.groups[0].arrays[0].output = scenes::Selection{false, {"x"}, {"chain.h", 2, 5}};
  EXPECT_FALSE(find_needs(scene, chain_usage()).sound());
}

TEST(SceneNeeds, prune_an_input_that_nothing_reads_and_say_so_where_it_was_named) {
  Scene scene = chain();
  scene.groups[0].arrays[3].input = scenes::Selection{false, {"b"}, {"chain.h", 12, 5}};
  const Needs needs = find_needs(scene, chain_usage());
  EXPECT_TRUE(needs.sound());
  EXPECT_TRUE(needs.of("body.extra").left_out());
  const std::string said = issues(scene, chain_usage());
  EXPECT_NE(said.find("chain.h:12:5: note: field body.extra.b is pruned: it is an input, and nothing reads it\n"),
            std::string::npos)
      << said;
  EXPECT_NE(said.find("note: array body.extra is left out: no field of it is needed\n"), std::string::npos) << said;
}

TEST(SceneNeeds, refuse_a_step_that_writes_one_record_for_all_objects) {
  Scene scene = chain();
  scene.groups[0].arrays[1].uniform = true;
  EXPECT_NE(
      issues(scene, chain_usage())
          .find("error: array body.svd is uniform(), one record for all objects, and Svd(body.x, body.svd) writes "
                "its field 'U' of each; take uniform() away\n"),
      std::string::npos);
}

TEST(SceneNeeds, refuse_uses_that_types_do_not_show_unless_all_fields_stay) {
  Usage usage = chain_usage();
  usage.unknown = {{"body.f", "data()", {"raw.h", 3, 4}}};
  EXPECT_EQ(issues(chain(), usage),
            "raw.h:3:4: error: data() of body.f hides which fields are used; write view[i].field(), or declare the "
            "array output(), which keeps all its fields\n");
  Scene scene = chain();
  scene.groups[0].arrays[2].output->all = true;
  EXPECT_TRUE(find_needs(scene, usage).sound());
}

TEST(SceneNeeds, refuse_arrays_and_fields_that_the_scene_has_not) {
  Usage usage = chain_usage();
  usage.steps[0].fields.push_back(reads("body.svt", "U"));
  EXPECT_NE(issues(chain(), usage).find("there is no array 'body.svt'; did you mean 'body.svd'?"), std::string::npos);
  usage.steps[0].fields.back() = reads("body.svd", "T");
  EXPECT_NE(issues(chain(), usage).find("in body.svd there is no field 'T'"), std::string::npos);
}

// ---- The report -----------------------------------------------------------------------------------------------------

}  // namespace
}  // namespace physgen::test
