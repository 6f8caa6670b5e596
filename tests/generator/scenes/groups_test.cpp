// Which neighbouring steps become one: a group that is found, and for each rule a program that breaks this rule alone.
#include "scenes/groups.h"

#include <gtest/gtest.h>

#include "by_hand.h"
#include "scenes/header.h"
#include "scenes/program_text.h"
#include "scenes/report.h"

namespace physgen::test {
namespace {

using scenes::ProgramStep;

const std::string text =
    "template <class On, class Body>\n"
    "  static void program(On& on, Body& body) {\n"
    "    // From x to s.\n"
    "    on.run(n, Svd{body.x.view(), body.svd.view()});\n"
    "    // From s to f.\n"
    "    on.run(n, Force{body.svd.view(), body.f.view()});  // the end\n"
    "  }";

usage::FieldUse own(usage::FieldUse use) {
  use.own = true;
  return use;
}

ProgramStep program_step(const std::string& step, int line, const std::string& kernel) {
  ProgramStep made;
  made.step = step;
  made.place = {"scenes/chain.h", line, 5};
  made.runs = "per tet of body";
  made.takes_packs = true;
  made.scalar_bytes = 4;
  const std::size_t at = text.find("on.run(n, " + kernel);
  made.statement = {at, text.find(';', at) + 1};
  made.count = {at + 7, at + 8};
  made.kernel = {at + 10, made.statement.end - 2};
  return made;
}

/// A scene of x -> Svd -> svd -> Force -> f with all arrays per tet, and its program.
struct Chain {
  scenes::Scene scene = chain();
  usage::Usage usage;
  scenes::ProgramText program;

  Chain() {
    for (auto& array : scene.groups[0].arrays) array.set = "tet";
    usage.steps.push_back(step(
        "Svd", {own(use("body.x", "x", true, {{"svd.h", 3, 9}})), own(use("body.svd", "U", false, {{"svd.h", 4, 9}})),
                own(use("body.svd", "s", false, {{"svd.h", 5, 9}}))}));
    usage.steps.back().arrays = {"body.x", "body.svd"};
    usage.steps.push_back(step("Force", {own(use("body.svd", "s", true, {{"force.h", 6, 1}})),
                                         own(use("body.f", "f", false, {{"force.h", 9, 1}}))}));
    usage.steps.back().arrays = {"body.svd", "body.f"};
    program.text = text;
    program.lists.push_back(
        {{program_step("Svd(body.x, body.svd)", 4, "Svd"), program_step("Force(body.svd, body.f)", 6, "Force")}, {""}});
    first().stores = {{"body.svd", "U"}, {"body.svd", "s"}};
    program.runs = {{first().step, 1}, {second().step, 1}};
  }

  ProgramStep& first() { return program.lists[0].steps[0]; }
  ProgramStep& second() { return program.lists[0].steps[1]; }
  usage::FieldUse& reads_s() { return usage.steps[1].fields[0]; }

  scenes::Needs needs() const {
    scenes::Needs needs = scenes::find_needs(scene, usage);
    EXPECT_TRUE(needs.sound());
    scenes::join_steps(scene, usage, program, needs);
    return needs;
  }
  /// Why its steps stay apart; empty: they are one.
  std::string why() const {
    const auto needs = this->needs();
    EXPECT_EQ(needs.groups.size() + needs.apart.size(), 1U);
    EXPECT_EQ(needs.of("body.svd").local(), !needs.groups.empty());
    return needs.apart.empty() ? "" : model::joined(needs.apart[0].why, "; ");
  }
};

TEST(Groups, join_steps_with_an_array_between_them_that_nothing_else_uses) {
  const Chain chain;
  const auto needs = chain.needs();
  ASSERT_EQ(needs.groups.size(), 1U);
  EXPECT_EQ(needs.groups[0].steps, (std::vector<std::string>{"Svd(body.x, body.svd)", "Force(body.svd, body.f)"}));
  EXPECT_EQ(needs.groups[0].locals, std::vector<std::string>{"body.svd"});
  EXPECT_TRUE(needs.apart.empty());
  EXPECT_TRUE(needs.of("body.svd").local());
  EXPECT_FALSE(needs.of("body.x").local());
  EXPECT_FALSE(needs.of("body.f").local());
}

TEST(Groups, are_written_into_the_text_of_the_program_which_stays_the_same_around_them) {
  const Chain chain;
  EXPECT_EQ(scenes::joined_text(chain.needs(), chain.program),
            "template <class On, class Body>\n"
            "  static void program(On& on, Body& body) {\n"
            "    // From x to s.\n"
            "    // From s to f.\n"
            "    on.run(n, ::physgen::fuse(\n"
            "        ::physgen::locals(body.svd.view()),\n"
            "        Svd{body.x.view(), body.svd.view()},\n"
            "        Force{body.svd.view(), body.f.view()}));  // the end\n"
            "  }");
  const auto header = scenes::program_header(chain.scene, chain.needs(), chain.program);
  EXPECT_NE(header.find("struct fused : ::scenes::chain {\n  template <class On, class Body>\n"), std::string::npos)
      << header;
  auto apart = chain;
  apart.second().takes_packs = false;
  EXPECT_NE(scenes::program_header(apart.scene, apart.needs(), apart.program).find("using fused = ::scenes::chain;\n"),
            std::string::npos);
}

TEST(Groups, make_arrays_local_in_the_header_and_in_the_report) {
  const Chain chain;
  const auto header = scenes::header(chain.scene, chain.needs());
  EXPECT_NE(header.find("physgen::LocalArray<"), std::string::npos) << header;
  EXPECT_NE(header.find("physgen::allocate(svd, counts.tet);\n"), std::string::npos) << header;
  const auto everything = scenes::header(chain.scene, scenes::everything(chain.needs()), "_everything");
  EXPECT_EQ(everything.find("LocalArray"), std::string::npos);
  const auto report = scenes::report_text(chain.scene, chain.needs());
  for (const char* line :
       {"body.svd    U      36     pruned    Svd", "            s      12     local     Svd",
        "per tet: 24 of 80 bytes, 6 of 20 numbers\n",
        "\nGroups:\n  Svd and Force are one step, at scenes/chain.h:6:5\n    local to them: body.svd (12); 12 bytes "
        "per tet "
        "are not stored\n",
        "  body.svd.s is local: Svd(body.x, body.svd) and Force(body.svd, body.f) are one step, and nothing else uses "
        "it; written by Svd(body.x, body.svd); read by Force(body.svd, body.f)\n"})
    EXPECT_NE(report.find(line), std::string::npos) << line << " in\n" << report;
  EXPECT_NE(scenes::report_why(chain.scene, chain.needs(), "svd.s").find("body.svd.s of m::Svd is local: Svd("),
            std::string::npos);
}

TEST(Groups, need_reads_at_the_steps_own_index) {
  Chain chain;
  chain.reads_s().gathered = true;
  EXPECT_EQ(chain.why(), "Force reads body.svd.s of other objects than its own, force.h:6:1");
  chain.reads_s().own = chain.reads_s().gathered = false;  // as of a kernel for single objects alone
  EXPECT_EQ(chain.why(), "Force reads body.svd.s of other objects than its own, force.h:6:1");
}

TEST(Groups, need_writes_at_the_steps_own_index) {
  Chain chain;
  chain.usage.steps[0].fields[2].gathered = true;
  EXPECT_EQ(chain.why(), "Svd writes body.svd.s of other objects than its own, svd.h:5:9");
  chain.usage.steps[0].fields[2].gathered = false;
  chain.usage.steps[0].fields[2].added = true;
  EXPECT_EQ(chain.why(), "Svd adds to body.svd.s of other objects than its own, svd.h:5:9");
}

TEST(Groups, keep_a_step_from_writing_what_an_earlier_one_gathers) {
  Chain chain;
  chain.usage.steps[0].fields.push_back(use("body.f", "f", true, {{"svd.h", 8, 2}}));
  chain.usage.steps[0].fields.back().own = chain.usage.steps[0].fields.back().gathered = true;
  EXPECT_EQ(chain.why(), "Svd reads body.f.f of other objects than its own, svd.h:8:2");
  chain.usage.steps[0].fields.back().gathered = false;
  EXPECT_EQ(chain.why(), "");
}

TEST(Groups, run_over_the_same_objects) {
  Chain chain;
  chain.second().runs = "per node of body";
  EXPECT_NE(chain.why().find("they run over different objects, per tet of body and per node of body"),
            std::string::npos);
  chain.second().runs = "";
  EXPECT_NE(chain.why().find("Force runs over a number of objects that is not the size() of an array"),
            std::string::npos);
  chain.first().runs = chain.second().runs = "n";
  EXPECT_NE(chain.why(), "") << "a number that the caller chooses may not be that of the array's objects";
}

TEST(Groups, are_of_kernels_that_take_packs_of_one_width) {
  Chain chain;
  chain.second().takes_packs = false;
  EXPECT_EQ(chain.why(), "Force cannot take packs, since its call operator takes single objects alone");
  chain.second().takes_packs = true;
  chain.second().scalar_bytes = 8;
  EXPECT_EQ(chain.why(), "packs of Force have another width");
}

TEST(Groups, have_nothing_between_their_steps) {
  Chain chain;
  chain.program.lists[0].between[0] = "on.value() at scenes/chain.h:5:5";
  EXPECT_EQ(chain.why(),
            "on.value() at scenes/chain.h:5:5 stands between them; write it before Svd or behind Force where it may "
            "stand there");
  chain.program.lists[0].between[0] = "";
  chain.second().obstacle = "it calls log() at scenes/chain.h:6:20";
  EXPECT_EQ(chain.why(), "Force: it calls log() at scenes/chain.h:6:20");
}

TEST(Groups, are_run_by_one_executor) {
  Chain chain;
  ++chain.second().statement.begin;  // as if the executor were called n
  EXPECT_EQ(chain.why(), "they are run in different words, 'on.run(' and 'n.run('");
}

TEST(Groups, store_outputs_and_inputs) {
  Chain chain;
  chain.scene.groups[0].arrays[1].output = scenes::Selection{false, {"s"}, {}};
  EXPECT_EQ(chain.why(), "body.svd is stored: it is an output");
  chain.scene.groups[0].arrays[1].output = scenes::Selection{false, {"U"}, {}};
  EXPECT_EQ(chain.why(),
            "body.svd is stored: it is an output; put s in an array of its own, which these steps alone use");
  chain.scene.groups[0].arrays[1].output.reset();
  chain.scene.groups[0].arrays[1].input = scenes::Selection{true, {}, {}};
  EXPECT_EQ(chain.why(), "body.svd is stored: it is an input");
}

TEST(Groups, store_what_is_not_written_whole_on_every_path) {
  Chain chain;
  chain.first().stores = {{"body.svd", "U"}};
  EXPECT_EQ(chain.why(),
            "body.svd is stored: no earlier step of the group is sure to store all of body.svd.s, which Force reads");
}

TEST(Groups, store_what_their_first_step_reads_of_the_time_before) {
  Chain chain;
  chain.usage.steps[0].fields.push_back(own(use("body.svd", "s", true, {{"svd.h", 2, 1}})));
  EXPECT_EQ(chain.why(),
            "body.svd is stored: no earlier step of the group is sure to store all of body.svd.s, which Svd reads");
}

TEST(Groups, store_what_other_steps_use) {
  Chain chain;
  chain.usage.steps.push_back(step("Later", {own(use("body.svd", "s", true, {})), own(writes("body.f", "f"))}));
  chain.usage.steps.back().arrays = {"body.svd", "body.f"};
  EXPECT_EQ(chain.why(), "body.svd is stored: Later uses it, too");
  chain.usage.steps.back().fields.erase(chain.usage.steps.back().fields.begin());
  EXPECT_EQ(chain.why(), "body.svd is stored: Later uses it, too") << "its views are given to another step";
}

TEST(Groups, store_what_the_host_or_unknown_code_reads) {
  Chain chain;
  chain.usage.unattributed.push_back(reads("body.svd", "s"));
  EXPECT_EQ(chain.why(), "body.svd is stored: code outside of steps uses it");
  chain.usage.unattributed.clear();
  chain.program.used["body.svd"] = " at scenes/chain.h:7:1";
  EXPECT_EQ(chain.why(),
            "body.svd is stored: the program does more than hand its views to kernels at scenes/chain.h:7:1");
}

TEST(Groups, store_what_a_step_uses_that_is_run_elsewhere_too) {
  Chain chain;
  chain.program.runs[chain.second().step] = 2;
  EXPECT_EQ(chain.why(), "body.svd is stored: Force is run more than once");
  chain.program.runs[chain.second().step] = 1;
  chain.program.elsewhere[chain.second().step] = "helper()";
  EXPECT_EQ(chain.why(), "body.svd is stored: Force is also run by helper()");
  EXPECT_EQ(chain.needs().not_joined,
            std::vector<std::string>{
                "helper() runs Force: only neighbouring statements of the program's own text are joined"});
}

TEST(Groups, are_not_of_steps_that_share_nothing) {
  Chain chain;
  chain.usage.steps[1].fields[0] = own(reads("body.x", "x"));
  chain.usage.steps[1].arrays = {"body.x", "body.f"};
  chain.second().step = "Force(body.x, body.f)";
  chain.scene.groups[0].arrays[1].output = scenes::Selection{false, {"s"}, {}};
  const auto needs = chain.needs();
  ASSERT_EQ(needs.apart.size(), 1U);
  EXPECT_EQ(needs.apart[0].why, std::vector<std::string>{"neither stores what the other reads"});
}

TEST(Groups, begin_anew_behind_a_step_that_cannot_be_joined) {
  Chain chain;
  ProgramStep before = chain.first();
  before.step = "Gather(body.f, body.x)";
  chain.usage.steps.push_back(
      step("Gather", {use("body.f", "f", true, {{"gather.h", 2, 2}}), own(writes("body.x", "x"))}));
  chain.usage.steps.back().fields[0].gathered = true;
  chain.usage.steps.back().arrays = {"body.f", "body.x"};
  chain.program.lists[0].steps.insert(chain.program.lists[0].steps.begin(), before);
  chain.program.lists[0].between = {"", ""};
  const auto needs = chain.needs();
  ASSERT_EQ(needs.groups.size(), 1U) << scenes::report_text(chain.scene, needs);
  EXPECT_EQ(needs.groups[0].first, 1U);
  ASSERT_EQ(needs.apart.size(), 1U);
  EXPECT_EQ(needs.apart[0].second, "Svd(body.x, body.svd)");
}

}  // namespace
}  // namespace physgen::test
