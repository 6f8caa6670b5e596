// Keys and members are paired once, for writing and reading.
#include <files/disk.h>
#include <physgen/error.h>
#include <truthcube/output/run_json.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

namespace physgen::truthcube {

namespace {

using OrderedJson = nlohmann::ordered_json;

template <class Record, class Visit>
void visit_newton(Record& step, const Visit& visit) {
  visit("coarser_by", step.coarser_by);
  visit("pcg_iterations", step.pcg_iterations);
  visit("residual", step.residual);
  visit("energy", step.energy);
  visit("smallest_J", step.smallest_J);
  visit("seconds", step.seconds);
}

template <class Record, class Visit>
void visit_solve(Record& step, const Visit& visit) {
  visit("newton_iterations", step.newton_iterations);
  visit("pcg_iterations", step.pcg_iterations);
  visit("residual", step.residual);
  visit("energy", step.energy);
  visit("smallest_J", step.smallest_J);
}

template <class Record, class Visit>
void visit_step(Record& step, const Visit& visit) {
  visit("compression", step.compression);
  visit_solve(step, visit);
  visit("reaction", step.reaction);
  visit("reaction_estimate", step.reaction_estimate);
  visit("error_estimate", step.error_estimate);
  visit("past_plates", step.past_plates);
  visit("seconds", step.seconds);
  visit("warm_seconds", step.warm_seconds);
  visit("time", step.time);
  visit("kinetic_energy", step.kinetic_energy);
}

template <class Record, class Visit>
void visit_run(Record& run, const Visit& visit) {
  visit("nodes", run.nodes);
  visit("tets", run.tets);
  visit("bytes", run.bytes);
  visit("device", run.device);
  visit("layout", run.layout);
  visit("command", run.command);
  visit("setup_seconds", run.setup_seconds);
}

template <class Record, class Visit>
void visit_plates(Record& run, const Visit& visit) {
  visit("lower", run.lower_plate);
  visit("upper", run.upper_plate);
}

template <class Record, class Visit>
void visit_ranks(Record& ranks, const Visit& visit) {
  visit("count", ranks.count);
  visit("exchanges", ranks.exchanges);
  visit("gathers", ranks.gathers);
  visit("messages", ranks.messages);
  visit("bytes", ranks.bytes);
  visit("gathered_bytes", ranks.gathered_bytes);
}

template <class Record, class Visit>
void visit_stage(Record& stage, const Visit& visit) {
  visit("name", stage.name);
  visit("seconds", stage.seconds);
  visit("bytes_moved", stage.bytes);
}

OrderedJson json_of(const GroupState& state) {
  OrderedJson json{
      {"reaction", state.reaction}, {"load", state.load}, {"largest_displacement", state.largest_displacement}};
  for (const auto& [axis, force] : state.axes) json["axes"].push_back({{"axis", axis}, {"reaction", force}});
  return json;
}

void add(OrderedJson& entry, const CaseState& state) {
  entry["all"] = json_of(state.all);
  entry["groups"] = OrderedJson::object();
  for (const GroupState& group : state.groups) entry["groups"][group.group] = json_of(group);
  for (const auto& [of, low, high] : state.displacement) {
    entry["displacement"][of] = {{"low", low.value}, {"low_at", low.at}, {"high", high.value}, {"high_at", high.at}};
  }
  entry["probes"] = OrderedJson::object();
  for (const ProbeState& probe : state.probes) {
    entry["probes"][probe.probe] = {{"at", probe.at}, {"displacement", probe.displacement}};
  }
}

template <class T>
void take(const OrderedJson& object, const char* key, T& value) {
  const OrderedJson& found = object.at(key);
  if constexpr (std::is_same_v<T, double>) {
    value = found.is_null() ? std::numeric_limits<double>::quiet_NaN() : found.get<double>();
  } else {
    value = found.get<T>();
  }
}

}  // namespace

void write_run_json(const std::filesystem::path& file, const RunRecord& record) {
  OrderedJson run;
  visit_run(record, [&run](const char* key, const auto& value) { run[key] = value; });
  visit_plates(record, [&](const char* key, const PlateRecord& plate) {
    if (record.has_plates) run["held"][key] = {{"nodes", plate.nodes}, {"area", plate.area}};
  });
  if (record.ranks) {
    visit_ranks(*record.ranks, [&](const char* key, const auto& value) { run["ranks"][key] = value; });
  }
  run["setup_stages"] = OrderedJson::array();
  for (const StageRecord& stage : record.stages) {
    OrderedJson& entry = run["setup_stages"].emplace_back();
    visit_stage(stage, [&entry](const char* key, const auto& value) { entry[key] = value; });
  }
  run["settings"] = OrderedJson::parse(record.settings, nullptr, false);
  if (!run["settings"].is_object())
    throw Error(file.string() + ": the settings are not a JSON object: " + record.settings);
  run["steps"] = OrderedJson::array();
  for (const StepRecord& step : record.steps) {
    OrderedJson entry;
    const auto put = [&entry](const char* key, const auto& value) { entry[key] = value; };
    if (step.at) {
      put("load", step.at->load);
      visit_solve(step, put);
      put("seconds", step.seconds);
      add(entry, *step.at);
    } else {
      visit_step(step, put);
    }
    entry["newton"] = OrderedJson::array();
    for (const NewtonRecord& newton : step.newton) {
      OrderedJson& line = entry["newton"].emplace_back();
      visit_newton(newton, [&line](const char* key, const auto& value) { line[key] = value; });
    }
    run["steps"].push_back(entry);
  }
  // Names of files in a command need not be UTF-8, which JSON is.
  disk::write_text(file, run.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n");
}

RunRecord read_run_json(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw Error(file.string() + ": cannot be opened");
  try {
    const OrderedJson run = OrderedJson::parse(stream);
    RunRecord record;
    visit_run(record, [&run](const char* key, auto& value) { take(run, key, value); });
    if (run.contains("held")) {
      visit_plates(record, [&held = run["held"]](const char* key, PlateRecord& plate) {
        take(held.at(key), "nodes", plate.nodes);
        take(held.at(key), "area", plate.area);
      });
    }
    if (run.contains("ranks")) {
      visit_ranks(record.ranks.emplace(), [&](const char* key, auto& value) { take(run["ranks"], key, value); });
    }
    for (const OrderedJson& entry : run.value("setup_stages", OrderedJson::array())) {
      visit_stage(record.stages.emplace_back(), [&entry](const char* key, auto& value) { take(entry, key, value); });
    }
    record.settings = run.at("settings").dump();
    for (const OrderedJson& entry : run.at("steps")) {
      StepRecord& step = record.steps.emplace_back();
      visit_step(step, [&entry](const char* key, auto& value) { take(entry, key, value); });
      for (const OrderedJson& line : entry.at("newton")) {
        visit_newton(step.newton.emplace_back(), [&line](const char* key, auto& value) { take(line, key, value); });
      }
    }
    return record;
  } catch (const OrderedJson::exception& error) {
    std::string said = error.what();  // which quotes the file
    std::ranges::replace_if(
        said, [](unsigned char c) { return c < ' ' || c > '~'; }, '?');  // as a terminal can show it
    throw Error(file.string() + ": this is not a run.json of truthcube: " + said);
  }
}

}  // namespace physgen::truthcube
