// See usage_command.h.
#include "usage_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <optional>
#include <ostream>

#include "exit_status.h"
#include "files.h"
#include "scenes/analysis.h"
#include "scenes/read.h"
#include "usage/compare.h"
#include "usage/json.h"
#include "usage/table.h"

namespace physgen::command {
namespace {

namespace fs = std::filesystem;
using ::physgen::usage::Side;

/// One program that is analysed: that of a file, or that of a scene.
struct Unit {
  std::string name;  // of the program
  std::string file;  // for messages
  std::string text;  // of the file
  std::vector<std::string> flags;
  std::optional<scenes::Scene> scene;
};

class UsageCommand {
 public:
  UsageCommand(const UsageRequest& request, std::ostream& out, std::ostream& err)
      : request_(request), out_(out), err_(err) {}

  int run() {
    for (const std::string& file : request_.files) require_readable(file);
    std::vector<std::string> inputs = request_.files;
    if (!request_.checked_in.empty()) {
      require_readable(request_.checked_in);
      inputs.push_back(request_.checked_in);
    }
    if (!request_.json.empty()) require_apart({request_.json}, inputs);
    std::vector<usage::Program> programs;
    bool good = true;
    for (const std::string& file : request_.files) {
      auto program = program_of(file);
      good = good && program;
      if (program) programs.push_back(std::move(*program));
    }
    if (!good) return errors;
    if (request_.side.empty() && !usage::has_device_side())
      times_ += "no CUDA toolkit was found, so code for the device alone was not analysed\n";
    if (request_.checked_in.empty())
      for (const usage::Program& program : programs) out_ << usage::table(program) << '\n';
    out_ << times_;
    if (!request_.json.empty()) write_changed({{request_.json, usage::to_json(programs)}});
    return request_.checked_in.empty() ? done : check(programs);
  }

 private:
  std::optional<usage::Program> program_of(const std::string& file) {
    const auto unit = unit_of(file);
    if (!unit) return std::nullopt;
    auto found = analyse(*unit);
    if (!found) return std::nullopt;
    const usage::Program program{unit->name, std::move(*found)};
    if (!is_sound(*unit, program.usage)) return std::nullopt;
    return program;
  }

  /// A scene, or a file that is itself a unit to analyse.
  std::optional<Unit> unit_of(const std::string& file) {
    Unit unit;
    unit.file = file;
    unit.flags = request_.flags;
    unit.text = read_file(file);
    if (unit.text.find("PHYSGEN_SCENE") == std::string::npos) {
      unit.name = fs::path(file).filename().string();
      unit.text = "#line 1 \"" + file + "\"\n" + unit.text;
      unit.flags.emplace_back("-iquote");
      unit.flags.push_back(fs::absolute(file).parent_path().string());
      return unit;
    }
    auto declaration = scenes::read(file, request_.flags);
    err_ << declaration.diagnostics;
    if (!declaration.scene) return std::nullopt;
    unit.name = declaration.scene->name;
    unit.scene = std::move(declaration.scene);
    return unit;
  }

  [[nodiscard]] std::vector<Side> sides() const {
    if (request_.side == "host" || (request_.side.empty() && !usage::has_device_side())) return {Side::host};
    if (request_.side == "device") return {Side::device};
    return {Side::host, Side::device};
  }

  std::optional<usage::Usage> analyse(const Unit& unit) {
    const std::vector<Side> sides = this->sides();
    scenes::Analysis analysis;
    if (unit.scene) {
      const std::string path = fs::absolute(unit.file).lexically_normal().string();
      analysis = scenes::analyse(*unit.scene, path, unit.flags, sides);
    } else {
      analysis.usage = usage::Usage();
      for (const Side side : sides) {
        const auto found =
            usage::analyse(unit.name + ".cpp", unit.text, unit.flags, side, analysis.diagnostics.emplace_back());
        if (!found) analysis.usage = std::nullopt;
        if (!analysis.usage) break;
        analysis.usage = usage::unite(*analysis.usage, *found);
      }
    }
    for (std::size_t i = 0; i < analysis.diagnostics.size(); ++i) {
      err_ << analysis.diagnostics[i].text;
      times_ += usage::text_of_time(unit.name, sides[i], analysis.diagnostics[i]);
    }
    return std::move(analysis.usage);
  }

  /// Whether there is something to say, and nothing that cannot be said.
  bool is_sound(const Unit& unit, const usage::Usage& found) {
    if (found.steps.empty() && found.unattributed.empty()) {
      err_ << unit.file
           << ": error: this file has no scene and gives no steps to a ProbeExecutor; declare a scene as "
              "<physgen/scene.h> says, or write a program over probes as <physgen/probe.h> says\n";
      return false;
    }
    bool sound = true;
    for (const usage::UnknownUse& use : found.unknown) {
      if (is_declared(unit, use.array)) continue;
      sound = false;
      err_ << usage::text_of(use.place) << ": error: " << use.what << " may use any field of " << use.array
           << " in any way; use its fields by name, or declare all of them as input() and output() of a scene\n";
    }
    for (const usage::Race& race : found.races) {
      sound = false;
      err_ << usage::text_of(race.writer_place) << ": error: " << usage::text_of(race) << '\n';
    }
    for (const usage::Dependence& dependence : found.dependences) {
      sound = false;
      err_ << usage::text_of(dependence.place) << ": error: " << usage::text_of(dependence) << '\n';
    }
    return sound;
  }

  /// Whether a scene says that all fields of an array are given to it and wanted of it.
  [[nodiscard]] static bool is_declared(const Unit& unit, const std::string& name) {
    const scenes::Array* array = unit.scene ? scenes::find(*unit.scene, name) : nullptr;
    return array != nullptr && std::ranges::all_of(array->fields, [&](const scenes::Field& field) {
             return array->is_input(field.name) || array->is_output(field.name);
           });
  }

  int check(const std::vector<usage::Program>& programs) {
    std::vector<std::string> lines;
    try {
      lines = usage::differences(usage::from_json(read_file(request_.checked_in)), programs);
    } catch (const usage::JsonError& error) {
      lines = {error.what()};
    }
    if (lines.empty()) return done;
    err_ << request_.checked_in << ": error: it is stale:\n";
    for (const std::string& line : lines) err_ << "  " << line << '\n';
    err_ << "note: to renew it: physgen usage";
    for (const std::string& file : request_.files) err_ << ' ' << file;
    err_ << " --json " << request_.checked_in;
    if (!request_.side.empty()) err_ << " --side " << request_.side;
    if (!request_.flags.empty()) err_ << " --";
    for (const std::string& flag : request_.flags) err_ << ' ' << flag;
    err_ << '\n';
    return errors;
  }

  const UsageRequest& request_;
  std::ostream& out_;
  std::ostream& err_;
  std::string times_;
};

}  // namespace

void describe_usage(CLI::App& app, UsageRequest& request) {
  auto* usage = app.add_subcommand("usage", "Print which fields of which arrays the steps of programs read and write");
  usage
      ->add_option("FILE", request.files,
                   "Declarations of scenes (<physgen/scene.h>), or C++ sources that give steps to a ProbeExecutor "
                   "(<physgen/probe.h>)")
      ->required();
  usage->add_option("--json", request.json, "File for the table as JSON")->type_name("FILE");
  usage
      ->add_option("--check", request.checked_in,
                   "Compare with this JSON in place of printing; where it is stale, say in what, and exit with 1")
      ->type_name("FILE");
  usage
      ->add_option(
          "--side", request.side,
          "host: as compiled for the CPU; device: for CUDA, which needs a toolkit (found by CUDA_HOME, "
          "CUDA_PATH or in /usr/local/cuda); both: the two united, which is the default where there is a toolkit")
      ->check(CLI::IsMember({"host", "device", "both"}))
      ->type_name("SIDE");
  usage->footer(
      "Arguments after '--' are flags of a compiler, such as -I DIR and -march=x86-64-v3. R: some code can read the "
      "field; "
      "W: some code can write it; &: its address is taken. Branches are united, whatever their conditions; places are "
      "in the kernel's own source, with '(all fields)' for a get() or put() of whole objects. Code outside of steps, "
      "predicates of loops and values that the host asks for are always wanted. Templates that the program does not "
      "instantiate are not in it.");
}

int usage(const UsageRequest& request, std::ostream& out, std::ostream& err) {
  return UsageCommand(request, out, err).run();
}

}  // namespace physgen::command
