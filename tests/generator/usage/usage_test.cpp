// The results of an analysis: attribution to steps, JSON, tables, comparison. Nothing here needs Clang.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "usage/compare.h"
#include "usage/graph.h"
#include "usage/json.h"
#include "usage/table.h"

namespace physgen::usage {
namespace {

FieldUse read(const std::string& field, std::vector<Place> places) {
  FieldUse use;
  use.array = "svds";
  use.field = field;
  use.read = true;
  use.places = std::move(places);
  return use;
}

/// Every member of every struct holds something that is neither false, zero nor empty.
Program sample() {
  const Place kernel{"fem/kernels/compute_svd.h", 17, 8}, read_at{"fem/kernels/compute_svd.h", 26, 38},
      written_at{"fem/kernels/compute_svd.h", 29, 9};
  FieldUse written = read("V", {read_at, written_at});
  written.written = written.address_taken = written.whole_object = true;
  written.whole_places = {written_at};
  Program program;
  program.name = "dynamics";
  program.usage.steps = {
      {"physgen::fem::ComputeSvd", kernel, {"gradients", "svds"}, false, {read("U", {read_at}), written}, {}},
      {"scenes::IsDone", {"scenes/dynamics.h", 3, 1}, {"state"}, true, {read("r", {})}, {}}};
  program.usage.unattributed = {read("s", {{"scenes/dynamics.h", 4, 5}})};
  program.usage.unknown = {{"tets", "data()", {"scenes/dynamics.h", 6, 7}}};
  return program;
}

TEST(UsageJson, keeps_everything) {
  const std::vector<Program> programs = {sample(), {"empty", {}}};
  EXPECT_EQ(from_json(to_json(programs)), programs);
  EXPECT_EQ(to_json(from_json(to_json(programs))), to_json(programs));
}

std::string message(const std::string& text) {
  try {
    (void)from_json(text);
  } catch (const JsonError& error) {
    return error.what();
  }
  return "no error";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(UsageJson, says_what_is_wrong_with_a_text_and_where) {
  const std::string text = to_json({sample()});
  EXPECT_NE(message(text.substr(0, text.size() / 2)).find("this is not JSON: "), std::string::npos);
  EXPECT_EQ(message("[]"), "it is not an object");
  EXPECT_EQ(message(replaced(text, "\"format\": 1", "\"format\": 2")), "it has format 2; this physgen reads 1");
  EXPECT_EQ(message(replaced(text, "\"kernel\"", "\"colonel\"")), "programs[0]/steps[0] has no 'kernel'");
  EXPECT_EQ(message(replaced(text, "\"written\"", "\"riten\"")),
            "programs[0]/steps[0]/fields[1] has a 'riten', which this physgen does not know");
  EXPECT_EQ(message(replaced(text, "\"read\": true", "\"read\": 1")),
            "programs[0]/steps[0]/fields[0] has a 'read' of another type");
  EXPECT_EQ(message(replaced(text, ":26:38", ":26:x")),
            "programs[0]/steps[0]/fields[0] has the place 'fem/kernels/compute_svd.h:26:x', which is not "
            "file:line:column");
}

TEST(UsageComparison, finds_nothing_where_nothing_differs) {
  EXPECT_EQ(differences({sample()}, {sample()}), std::vector<std::string>());
}

TEST(UsageComparison, finds_every_member_that_was_changed) {
  const auto field = [](Program& program) -> FieldUse& { return program.usage.steps[0].fields[1]; };
  const std::vector<std::pair<const char*, std::function<void(Program&)>>> changes = {
      {"name", [](Program& p) { p.name = "statics"; }},
      {"kernel", [](Program& p) { p.usage.steps[0].kernel = "physgen::fem::ComputeQuaternionSvd"; }},
      {"file of a kernel", [](Program& p) { p.usage.steps[0].place.file = "x.h"; }},
      {"line of a kernel", [](Program& p) { ++p.usage.steps[0].place.line; }},
      {"column of a kernel", [](Program& p) { ++p.usage.steps[0].place.column; }},
      {"array of a kernel", [](Program& p) { p.usage.steps[0].arrays[1] = "other"; }},
      {"order of arrays", [](Program& p) { std::swap(p.usage.steps[0].arrays[0], p.usage.steps[0].arrays[1]); }},
      {"root", [](Program& p) { p.usage.steps[1].root = false; }},
      {"array", [&](Program& p) { field(p).array = "other"; }},
      {"field", [&](Program& p) { field(p).field = "W"; }},
      {"read", [&](Program& p) { field(p).read = false; }},
      {"written", [&](Program& p) { field(p).written = false; }},
      {"address_taken", [&](Program& p) { field(p).address_taken = false; }},
      {"whole_object", [&](Program& p) { field(p).whole_object = false; }},
      {"a place", [&](Program& p) { ++field(p).places[1].line; }},
      {"a place less", [&](Program& p) { field(p).places.pop_back(); }},
      {"a place of all fields", [&](Program& p) { field(p).whole_places.clear(); }},
      {"a field less", [](Program& p) { p.usage.steps[0].fields.pop_back(); }},
      {"a step less", [](Program& p) { p.usage.steps.pop_back(); }},
      {"a step twice", [](Program& p) { p.usage.steps.push_back(p.usage.steps[0]); }},
      {"a use outside of steps", [](Program& p) { p.usage.unattributed[0].read = false; }},
      {"a use outside of steps less", [](Program& p) { p.usage.unattributed.clear(); }},
      {"unknown array", [](Program& p) { p.usage.unknown[0].array = "other"; }},
      {"unknown use", [](Program& p) { p.usage.unknown[0].what = "sizeof"; }},
      {"place of an unknown use", [](Program& p) { ++p.usage.unknown[0].place.column; }},
  };
  for (const auto& [what, change] : changes) {
    Program changed = sample();
    change(changed);
    EXPECT_NE(changed, sample()) << what;
    EXPECT_FALSE(differences({changed}, {sample()}).empty()) << what;
    EXPECT_FALSE(differences({sample()}, {changed}).empty()) << what;
  }
}

TEST(UsageComparison, names_the_step_the_field_and_both_values) {
  Program now = sample();
  now.usage.steps[0].fields[0].written = true;
  const std::vector<std::string> expected = {
      "dynamics: physgen::fem::ComputeSvd(gradients, svds): svds.U: written: yes; in the file: no"};
  EXPECT_EQ(differences({sample()}, {now}), expected);
}

TEST(UsageTable, shows_accesses_and_places) {
  const std::string text = table(sample());
  EXPECT_NE(text.find("physgen::fem::ComputeSvd(gradients, svds)  fem/kernels/compute_svd.h:17:8\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("svds   U      R    compute_svd.h:26:38\n"), std::string::npos) << text;
  EXPECT_NE(text.find("svds   V      RW&  compute_svd.h:26:38, :29:9 (all fields)\n"), std::string::npos) << text;
  EXPECT_NE(text.find("scenes::IsDone(state)  scenes/dynamics.h:3:1  (always wanted)\n"), std::string::npos) << text;
  EXPECT_NE(text.find("outside of all steps (always wanted)\n"), std::string::npos) << text;
  EXPECT_NE(text.find("tets  data()  dynamics.h:6:7\n"), std::string::npos) << text;
}

TEST(Usage, of_two_sides_is_united) {
  Program host = sample(), device = sample();
  host.usage.steps[0].fields[1].address_taken = false;
  device.usage.steps[0].fields.erase(device.usage.steps[0].fields.begin());
  device.usage.steps[0].fields[0].places = {{"device.h", 1, 2}};
  device.usage.steps[1].kernel = "scenes::OnlyThere";
  device.usage.unknown[0].what = "sizeof";
  const Usage both = unite(host.usage, device.usage);
  ASSERT_EQ(both.steps.size(), 3U);
  EXPECT_EQ(both.steps[0].fields.size(), 2U);
  EXPECT_EQ(both.steps[0].fields[0], sample().usage.steps[0].fields[0]);
  EXPECT_TRUE(both.steps[0].fields[1].address_taken);
  EXPECT_EQ(both.steps[0].fields[1].places.size(), 3U);
  EXPECT_EQ(both.unknown.size(), 2U);
  EXPECT_EQ(unite(host.usage, device.usage), unite(device.usage, host.usage));
}

// ---- Attribution ----------------------------------------------------------------------------------------------------

/// A program of two steps over one kernel file, a function of another file and a generated get():
///   0 step A -> 1 kernel A (own) -> 3 helper -> 4 read of x, at a.h:10;  1 -> 5 get() -> 4, 6, at a.h:11
///   2 step B -> 7 kernel B (own) -> 8 write of y, at b.h:20
///   9 program -> 0, 2, and -> 6 read of y itself, at main.cpp:30
Graph sample_graph() {
  Graph graph;
  graph.fields.resize(2);
  graph.fields[0].use.array = graph.fields[1].use.array = "bodies";
  graph.fields[0].use.field = "x";
  graph.fields[1].use.field = "y";
  const auto function = [&](const char* file, std::vector<Call> calls, Access access = Access::none, int field = -1) {
    Function made;
    made.place.file = file;
    made.of_library = std::string(file).starts_with("physgen/");
    made.calls = std::move(calls);
    made.access = access;
    made.field = field;
    graph.functions.push_back(std::move(made));
  };
  function("physgen/steps.h", {{1, {}}});
  function("a.h", {{3, {"a.h", 10, 1}}, {5, {"a.h", 11, 1}}});
  function("physgen/steps.h", {{7, {}}});
  function("helper.h", {{4, {"helper.h", 1, 1}}});
  function("physgen/probe.h", {}, Access::read, 0);
  function("physgen/generated.h", {{4, {}}, {6, {}}});
  function("physgen/probe.h", {}, Access::read, 1);
  function("b.h", {{8, {"b.h", 20, 1}}, {7, {"b.h", 21, 1}}});
  function("physgen/probe.h", {}, Access::write, 1);
  function("main.cpp", {{0, {"main.cpp", 28, 1}}, {2, {"main.cpp", 29, 1}}, {6, {"main.cpp", 30, 1}}});
  graph.functions[5].whole_object = true;
  Step a, b;
  a.function = 0;
  a.use.kernel = "A";
  a.own_files = {"a.h"};
  b.function = 2;
  b.use.kernel = "B";
  b.own_files = {"b.h"};
  graph.steps = {a, b};
  graph.entries = {1, 3, 7, 9};
  return graph;
}

TEST(UsageAttribution, gives_accesses_to_the_steps_that_lead_to_them_with_places_in_their_own_files) {
  const Usage usage = attribute(sample_graph());
  ASSERT_EQ(usage.steps.size(), 2U);
  ASSERT_EQ(usage.steps[0].fields.size(), 2U);
  const FieldUse &x = usage.steps[0].fields[0], &y = usage.steps[0].fields[1];
  EXPECT_TRUE(x.read && !x.written && x.whole_object);
  EXPECT_EQ(x.places, (std::vector<Place>{{"a.h", 10, 1}, {"a.h", 11, 1}}));
  EXPECT_EQ(x.whole_places, (std::vector<Place>{{"a.h", 11, 1}}));
  EXPECT_TRUE(y.read && !y.written && y.whole_object);
  ASSERT_EQ(usage.steps[1].fields.size(), 1U);
  EXPECT_EQ(usage.steps[1].fields[0].field, "y");
  EXPECT_TRUE(usage.steps[1].fields[0].written && !usage.steps[1].fields[0].read);
  EXPECT_EQ(usage.steps[1].fields[0].places, (std::vector<Place>{{"b.h", 20, 1}}));
}

TEST(UsageAttribution, gives_what_the_program_itself_reads_to_no_step_even_where_a_step_reads_it_too) {
  const Usage usage = attribute(sample_graph());
  ASSERT_EQ(usage.unattributed.size(), 1U);
  EXPECT_EQ(usage.unattributed[0].field, "y");
  EXPECT_EQ(usage.unattributed[0].places, (std::vector<Place>{{"main.cpp", 30, 1}}));
}

TEST(UsageAttribution, loses_no_access_that_nothing_is_known_to_lead_to) {
  Graph graph = sample_graph();
  graph.functions[7].calls.clear();
  graph.functions[9].calls.clear();
  const Usage usage = attribute(graph);
  EXPECT_TRUE(usage.steps[1].fields.empty());
  ASSERT_EQ(usage.unattributed.size(), 1U);
  EXPECT_TRUE(usage.unattributed[0].written);
  EXPECT_EQ(all_fields(usage).size(), 2U);
}

TEST(UsageAttribution, takes_a_step_that_only_another_step_calls_for_a_part_of_it) {
  Graph graph = sample_graph();
  graph.functions[9].calls.erase(graph.functions[9].calls.begin() + 1);  // the program gives B to no executor
  graph.functions[0].calls.push_back({2, {}});
  const Usage usage = attribute(graph);
  ASSERT_EQ(usage.steps.size(), 1U);
  EXPECT_EQ(usage.steps[0].kernel, "A");
  EXPECT_TRUE(usage.steps[0].fields[1].written);
}

}  // namespace
}  // namespace physgen::usage
