// run.json, read by a JSON parser: its keys and numbers, and that it is complete at any time.
#include <truthcube/output/run_json.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "scratch.h"
#include "writes.h"

namespace physgen::truthcube {
namespace {

using Json = nlohmann::ordered_json;
using testing::expect_error;
using testing::read_text;

class RunJson : public testing::Scratch {
 public:
  std::filesystem::path path = in_folder("run.json");
};

RunRecord record_of(int steps) {
  RunRecord run{.nodes = 274625,
                .tets = 1572864,
                .bytes = 3'000'000'000,
                .device = "NVIDIA H200",
                .layout = "schema",
                .command = "truthcube --cells 64 --out \"a b\"",
                .settings = R"({"material":"neo_hookean","young":15000.0,"poisson":0.49,"cells":64})",
                .setup_seconds = 0.1,
                .stages = {{"rows of tets", 0.03, 1'000'000'000}, {"other", 0.07, 0}},
                .lower_plate = {4225, 0.0064},
                .upper_plate = {4224, 0.0063},
                .steps = {}};
  for (int s = 0; s < steps; ++s) {
    run.steps.push_back(
        {0.05 * (s + 1), 4 + s, 60 + s, 1e-4 / 3, 0.7, 0.94, -1.1, -1.05, 1e-4, 2e-5, 0.04, 0.03, 0.2, 3e-4, {}});
    run.steps.back().newton = {{2, 9, 0.3, 0.9, 0.8, 0.001}, {0, 11 + s, 1e-4 / 3, 0.7, 0.94, 0.02}};
  }
  return run;
}

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

TEST_F(RunJson, has_the_keys_that_scripts_look_for) {
  write_run_json(path, record_of(2));
  const Json run = Json::parse(read_text(path));
  EXPECT_EQ(keys_of(run), (std::vector<std::string>{"nodes", "tets", "bytes", "device", "layout", "command",
                                                    "setup_seconds", "held", "setup_stages", "settings", "steps"}));
  EXPECT_EQ(run["nodes"], 274625);
  EXPECT_EQ(run["tets"], 1572864);
  EXPECT_EQ(run["bytes"], 3'000'000'000);
  EXPECT_EQ(run["device"], "NVIDIA H200");
  EXPECT_EQ(run["layout"], "schema");
  EXPECT_EQ(run["command"], "truthcube --cells 64 --out \"a b\"");
  EXPECT_EQ(run["setup_seconds"], 0.1);
  EXPECT_EQ(run["held"]["lower"], Json::parse(R"({"nodes": 4225, "area": 0.0064})"));
  EXPECT_EQ(run["held"]["upper"], Json::parse(R"({"nodes": 4224, "area": 0.0063})"));
  EXPECT_EQ(run["setup_stages"][0],
            Json::parse(R"({"name": "rows of tets", "seconds": 0.03, "bytes_moved": 1000000000})"));
  EXPECT_EQ(run["settings"]["material"], "neo_hookean");
  ASSERT_EQ(run["steps"].size(), 2U);
  const Json& step = run["steps"][1];
  EXPECT_EQ(keys_of(step),
            (std::vector<std::string>{"compression", "newton_iterations", "pcg_iterations", "residual", "energy",
                                      "smallest_J", "reaction", "reaction_estimate", "error_estimate", "past_plates",
                                      "seconds", "warm_seconds", "time", "kinetic_energy", "newton"}));
  EXPECT_EQ(step["compression"], 0.1);
  EXPECT_EQ(step["newton_iterations"], 5);
  EXPECT_EQ(step["pcg_iterations"], 61);
  EXPECT_EQ(step["residual"], 1e-4 / 3);
  EXPECT_EQ(step["energy"], 0.7);
  EXPECT_EQ(step["smallest_J"], 0.94);
  EXPECT_EQ(step["reaction"], -1.1);
  EXPECT_EQ(step["past_plates"], 2e-5);
  EXPECT_EQ(step["seconds"], 0.04);
  EXPECT_EQ(step["time"], 0.2);
  EXPECT_EQ(step["kinetic_energy"], 3e-4);
}

TEST_F(RunJson, has_every_newton_step_in_order) {
  write_run_json(path, record_of(2));
  const Json newton = Json::parse(read_text(path))["steps"][1]["newton"];
  ASSERT_EQ(newton.size(), 2U);
  EXPECT_EQ(keys_of(newton[0]),
            (std::vector<std::string>{"coarser_by", "pcg_iterations", "residual", "energy", "smallest_J", "seconds"}));
  EXPECT_EQ(newton[0]["coarser_by"], 2);
  EXPECT_EQ(newton[0]["residual"], 0.3);
  EXPECT_EQ(newton[1]["coarser_by"], 0);
  EXPECT_EQ(newton[1]["pcg_iterations"], 12);
  EXPECT_EQ(newton[1]["residual"], 1e-4 / 3);
  EXPECT_EQ(newton[1]["energy"], 0.7);
  EXPECT_EQ(newton[1]["smallest_J"], 0.94);
  EXPECT_EQ(newton[1]["seconds"], 0.02);
}

TEST_F(RunJson, without_steps_has_an_empty_list) {
  write_run_json(path, record_of(0));
  EXPECT_EQ(Json::parse(read_text(path))["steps"], Json::array());
}

TEST_F(RunJson, is_read_as_it_was_written) {
  RunRecord run = record_of(3);
  run.steps[0].residual = std::numeric_limits<double>::denorm_min();
  run.steps[1].energy = -0.0;
  run.steps[2].seconds = 1. / 3;
  write_run_json(path, run);
  const RunRecord read = read_run_json(path);
  EXPECT_TRUE(read == run);
  EXPECT_TRUE(std::signbit(read.steps[1].energy));
}

TEST_F(RunJson, of_a_version_that_did_not_say_what_plates_hold_is_read) {
  write_run_json(path, record_of(1));
  Json run = Json::parse(read_text(path));
  for (const char* key : {"held", "setup_stages"}) run.erase(key);
  testing::put_text(path, run.dump());
  const RunRecord read = read_run_json(path);
  EXPECT_EQ(read.steps.size(), 1U);
  EXPECT_EQ(read.lower_plate.nodes, 0);
}

TEST_F(RunJson, numbers_that_are_not_finite_are_null) {
  RunRecord run = record_of(1);
  run.steps[0].energy = std::numeric_limits<double>::quiet_NaN();
  run.steps[0].smallest_J = -std::numeric_limits<double>::infinity();
  write_run_json(path, run);
  const Json step = Json::parse(read_text(path))["steps"][0];
  EXPECT_TRUE(step["energy"].is_null());
  EXPECT_TRUE(step["smallest_J"].is_null());
  EXPECT_TRUE(std::isnan(read_run_json(path).steps[0].energy));
}

TEST_F(RunJson, command_need_not_be_utf_8) {
  RunRecord run = record_of(0);
  run.command = "truthcube --out \xFF";
  write_run_json(path, run);
  EXPECT_EQ(Json::parse(read_text(path))["command"], "truthcube --out \xEF\xBF\xBD");
}

TEST_F(RunJson, settings_that_are_no_object_are_refused) {
  for (const char* settings : {"", "{", "[1]", "7"}) {
    RunRecord run = record_of(0);
    run.settings = settings;
    expect_error([&] { write_run_json(path, run); }, path.string(), "not a JSON object");
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(RunJson, files_that_are_none_are_refused) {
  const auto read = [&] { static_cast<void>(read_run_json(path)); };
  expect_error(read, path.string(), "cannot be opened");
  for (const char* text : {"", "{", "[]", R"({"nodes": "many"})"}) {
    testing::put_text(path, text);
    expect_error(read, path.string(), "this is not a run.json");
  }
  testing::put_text(path, "{\"nodes\": \x1b[2J\xff 7}");
  const std::string said = testing::error_of(read);
  EXPECT_TRUE(std::ranges::all_of(said, [](unsigned char c) { return c >= ' ' && c <= '~'; })) << said;
  write_run_json(path, record_of(1));
  Json run = Json::parse(read_text(path));
  run["steps"][0].erase("reaction");
  testing::put_text(path, run.dump());
  expect_error(read, path.string(), "reaction");
  write_run_json(path, record_of(1));
  run = Json::parse(read_text(path));
  run["steps"][0]["newton"][1].erase("residual");
  testing::put_text(path, run.dump());
  expect_error(read, path.string(), "residual");
}

TEST_F(RunJson, kill_or_full_disk_at_any_write_leaves_the_old_or_the_new_one) {
  const RunRecord old_run = record_of(1), new_run = record_of(2);
  int writes = 0;
  for (bool stopped = true; stopped; ++writes) {
    write_run_json(path, old_run);
    stopped = testing::interrupted(testing::At::Kill, writes, [&] { write_run_json(path, new_run); });
    const RunRecord read = read_run_json(path);
    EXPECT_TRUE(read == (stopped ? old_run : new_run));
  }
  EXPECT_GT(writes, 2);
  write_run_json(path, old_run);
  testing::stop_writes(testing::At::Failure, 0);
  const std::string error = testing::error_of([&] { write_run_json(path, new_run); });
  testing::resume_writes();
  EXPECT_NE(error.find(path.string() + ".new: cannot write"), std::string::npos) << error;
  EXPECT_TRUE(read_run_json(path) == old_run);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path.parent_path()), {}), 1);  // nothing left beside it
}

TEST_F(RunJson, folder_that_cannot_be_written_is_named) {
  const testing::ReadOnly read_only(path.parent_path());
  expect_error([&] { write_run_json(path, record_of(0)); }, path.string(), "Permission denied");
}

}  // namespace
}  // namespace physgen::truthcube
