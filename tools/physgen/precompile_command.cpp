// See precompile_command.h.
#include "precompile_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <ostream>
#include <string_view>

#include "exit_status.h"
#include "files.h"
#include "usage/analyse.h"

namespace physgen::command {
namespace {

/// Clang writes where it is told, be it over a header that it reads.
void require_own(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  char magic[4] = {};
  if (in && (!in.read(magic, sizeof magic) || std::string_view(magic, sizeof magic) != "CPCH"))
    throw FileError("cannot write '" + file +
                    "': it is there, and is no precompiled header; remove it, or name another "
                    "file");
}

}  // namespace

std::string without_toolkit(const std::string& file) {
  return file +
         ": error: --device needs the headers of a CUDA toolkit, which is looked for by CUDA_HOME, CUDA_PATH and in "
         "/usr/local/cuda; without --device, only what the CPU does is looked at\n";
}

void describe_stamp(CLI::App& command, std::string& stamp, std::string& depfile) {
  auto* option =
      command.add_option("--stamp", stamp, "File that is made after all outputs, with the time when reading began")
          ->type_name("FILE");
  command.add_option("--depfile", depfile, "File for the dependencies of the stamp, in the syntax of Make")
      ->needs(option)
      ->type_name("FILE");
}

void describe_precompile(CLI::App& app, PrecompileRequest& request) {
  auto* precompile = app.add_subcommand(
      "precompile",
      "Read the runtime's headers once for many scenes: write FILE for 'physgen scene --precompiled FILE'");
  precompile
      ->add_option("-o,--output", request.output,
                   "The precompiled header of Clang; with --device also FILE.device. It fits this physgen and these "
                   "flags, until one of the headers changes")
      ->required()
      ->type_name("FILE");
  precompile->add_flag("--device", request.device,
                       "For 'physgen scene --device', too; needs a CUDA toolkit, as it does");
  describe_stamp(*precompile, request.stamp, request.depfile);
  precompile->footer("Arguments after '--' are flags of a compiler, the same as of 'physgen scene'.");
}

int precompile(const PrecompileRequest& request, std::ostream& err) {
  const Stamp stamp{request.stamp};
  std::vector<usage::Side> sides = {usage::Side::host};
  if (request.device) sides.push_back(usage::Side::device);
  for (const usage::Side side : sides) require_own(usage::precompiled(request.output, side));
  if (request.device && !usage::has_device_side()) {
    err << without_toolkit(request.output);
    return errors;
  }
  make_folder_of(request.output);
  usage::Diagnostics diagnostics;
  const bool good = usage::precompile(request.output, request.flags, sides, diagnostics);
  err << diagnostics.text;
  if (!good) return errors;
  std::vector<std::string>& read = diagnostics.dependencies;
  std::ranges::sort(read);
  read.erase(std::ranges::unique(read).begin(), read.end());
  std::vector<File> files;
  for (const usage::Side side : sides) set_time(usage::precompiled(request.output, side), stamp.begun);
  if (!request.depfile.empty()) files.push_back({request.depfile, depfile(request.stamp, read)});
  write_outputs(files, read, stamp);
  return done;
}

}  // namespace physgen::command
