// See scene_command.h.
#include "scene_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <optional>
#include <ostream>

#include "exit_status.h"
#include "files.h"
#include "precompile_command.h"
#include "scenes/analysis.h"
#include "scenes/digest.h"
#include "scenes/distribution.h"
#include "scenes/groups.h"
#include "scenes/halos.h"
#include "scenes/header.h"
#include "scenes/needs.h"
#include "scenes/probe_unit.h"
#include "scenes/program_text.h"
#include "scenes/read.h"
#include "scenes/read_program.h"
#include "scenes/records.h"
#include "scenes/report.h"
#include "usage/json.h"

namespace physgen::command {
namespace {

class SceneCommand {
 public:
  SceneCommand(const SceneRequest& request, std::ostream& out, std::ostream& err)
      : request_(request), out_(out), err_(err) {}

  int run() {
    require_readable(request_.file);
    require_precompiled();
    auto declaration = scenes::read(request_.file, flags_);
    err_ << declaration.diagnostics;
    if (!request_.precompiled.empty() && declaration.diagnostics.find(request_.precompiled) != std::string::npos)
      err_ << "note: write it again with 'physgen precompile', with the same flags behind '--'\n";
    depends_on(declaration.dependencies);
    if (!declaration.scene) return errors;
    const scenes::Scene& scene = *declaration.scene;
    const std::string path = std::filesystem::absolute(request_.file).lexically_normal().string();
    if (request_.print_model) {
      out_ << scenes::to_json(scene);
      return done;
    }
    if (request_.print_unit) {
      out_ << scenes::probe_unit(scene, "Host", path);
      return done;
    }
    if (request_.device && !usage::has_device_side()) {
      err_ << without_toolkit(request_.file);
      return errors;
    }
    const auto usage = analyse(scene, path);
    if (!usage) return errors;
    scenes::Needs needs = scenes::find_needs(scene, *usage);
    if (needs.sound()) needs.halos = scenes::find_halos(scene, *usage, needs.issues);
    for (const scenes::Issue& issue : needs.issues)  // notes are of needs that hold
      if (needs.sound() || issue.kind == scenes::Issue::Kind::error) err_ << scenes::text_of(issue);
    if (!needs.sound()) return errors;
    scenes::add_records(records_, needs);
    if (!request_.no_fuse) scenes::join_steps(scene, *usage, program_, needs);
    if (needs.halos.stated) {
      distribution_ = scenes::find_distribution(scene, needs);
      needs.halos.no_arrays = distribution_.refused;
    }
    if (!request_.why.empty()) out_ << scenes::report_why(scene, needs, request_.why);
    if (request_.output_dir.empty() && request_.why.empty()) out_ << scenes::report_text(scene, needs);
    if (!request_.output_dir.empty()) write(scene, needs, *usage);
    out_ << times_;
    return done;
  }

 private:
  void require_precompiled() const {
    if (request_.precompiled.empty()) return;
    require_readable(request_.precompiled);
    if (request_.device) require_readable(usage::precompiled(request_.precompiled, usage::Side::device));
  }

  std::optional<usage::Usage> analyse(const scenes::Scene& scene, const std::string& path) {
    std::vector<usage::Side> sides = {usage::Side::host};
    if (request_.device) sides.push_back(usage::Side::device);
    auto analysis = scenes::analyse(scene, path, flags_, sides,
                                    [&](clang::ASTContext& context, const std::vector<std::string>& folders) {
                                      program_ = scenes::read_program(context, scene, folders);
                                      records_ = scenes::read_records(context);
                                    });
    for (std::size_t i = 0; i < sides.size(); ++i) {
      err_ << analysis.diagnostics[i].text;
      depends_on(analysis.diagnostics[i].dependencies);
      if (request_.precompiled.empty()) times_ += usage::text_of_time(scene.name, sides[i], analysis.diagnostics[i]);
    }
    return std::move(analysis.usage);
  }

  void depends_on(const std::vector<std::string>& files) {
    for (const std::string& file : files)
      if (std::find(dependencies_.begin(), dependencies_.end(), file) == dependencies_.end())
        dependencies_.push_back(file);
  }

  void write(const scenes::Scene& scene, const scenes::Needs& needs, const usage::Usage& usage) const {
    const auto path = [&](const char* ending) { return request_.output_dir + "/" + scenes::file_of(scene, ending); };
    std::vector<File> files = {{path(".scene.h"), scenes::header(scene, needs)},
                               {path(".program.h"), scenes::program_header(scene, needs, program_)},
                               {path(".digest"), scenes::digest(scene, needs, usage)},
                               {path(".need.txt"), scenes::report_text(scene, needs)},
                               {path(".need.json"), scenes::report_json(scene, needs)},
                               {path(".usage.json"), usage::to_json({{scene.name, usage}})}};
    if (request_.everything)
      files.push_back({path(".everything.h"), scenes::header(scene, scenes::everything(needs), "_everything")});
    const bool has_halos = needs.halos.stated, has_arrays = has_halos && distribution_.refused.empty();
    if (has_halos) files.push_back({path(".halos.h"), scenes::halos_header(scene, needs.halos)});
    if (has_arrays) files.push_back({path(".distributed.h"), scenes::distributed_header(scene, needs, distribution_)});
    if (!request_.depfile.empty()) files.push_back({request_.depfile, depfile(request_.stamp, dependencies_)});
    write_outputs(files, {request_.file}, stamp_);  // programs that it reads may include what was written of it
    if (!has_halos) std::filesystem::remove(path(".halos.h"));  // of when the scene stated names
    if (!has_arrays) std::filesystem::remove(path(".distributed.h"));
  }

  const SceneRequest& request_;
  std::ostream& out_;
  std::ostream& err_;
  std::vector<std::string> flags_ =
      request_.precompiled.empty() ? request_.flags : usage::with_precompiled(request_.precompiled, request_.flags);
  Stamp stamp_{request_.stamp};
  std::vector<std::string> dependencies_;
  std::string times_;
  scenes::ProgramText program_;
  scenes::Records records_;
  scenes::Distribution distribution_;
};

}  // namespace

void describe_scene(CLI::App& app, SceneRequest& request) {
  auto* scene = app.add_subcommand(
      "scene", "Write the arrays of a scene, with only the fields that its program needs: x.h gives DIR/x.scene.h");
  scene->add_option("FILE", request.file, "The scene's declaration, a header that includes <physgen/scene.h>")
      ->required();
  scene
      ->add_option(
          "-o,--output", request.output_dir,
          "Folder of x.scene.h, of x.program.h, which calls the program over these arrays, of the digest x.digest, "
          "of the table x.halos.h and the arrays of several ranks x.distributed.h where the scene says what its index "
          "fields name, and of the reports x.need.txt, x.need.json and x.usage.json; made if it does not exist; "
          "without: the report is printed")
      ->type_name("DIR");
  scene
      ->add_option("--why", request.why,
                   "Explain what becomes of an array or a field, by which lines of which kernels: body.svds, "
                   "body.svds.U, DeformationSvd.U")
      ->type_name("NAME");
  scene->add_flag(
      "--device", request.device,
      "Look at what the program does on a CUDA device, too; needs a toolkit (found by CUDA_HOME, CUDA_PATH or "
      "in /usr/local/cuda)");
  scene->add_flag("--no-fuse", request.no_fuse,
                  "Join no steps: by default, neighbouring steps over the same objects become one where arrays between "
                  "them then need no memory");
  scene->add_flag("--everything", request.everything,
                  "Write DIR/x.everything.h, too: the same arrays with every field, to compare with");
  scene->add_flag("--print-model", request.print_model, "Print what physgen reads from the declaration, as JSON");
  scene->add_flag("--print-unit", request.print_unit,
                  "Print the source that is analysed: the program over probes, which any compiler takes");
  scene
      ->add_option("--precompiled", request.precompiled,
                   "What 'physgen precompile' has written with the same flags: saves much of the time")
      ->type_name("FILE");
  describe_stamp(*scene, request.stamp, request.depfile);
  scene->footer(
      "Arguments after '--' are flags of a compiler, such as -I DIR and -march=x86-64-v3, by which the declaration and "
      "its "
      "kernels are read.");
}

int scene(const SceneRequest& request, std::ostream& out, std::ostream& err) {
  return SceneCommand(request, out, err).run();
}

}  // namespace physgen::command
