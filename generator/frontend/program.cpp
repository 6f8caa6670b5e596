// See program.h. Clang's driver turns the flags into an invocation, as for the command clang++.
#include "frontend/program.h"

#include <clang/Basic/Version.h>
#include <clang/Frontend/CompilerInstance.h>
#include <clang/Frontend/FrontendAction.h>
#include <clang/Frontend/FrontendActions.h>
#include <clang/Frontend/TextDiagnosticPrinter.h>
#include <clang/Frontend/Utils.h>
#include <llvm/ADT/StringExtras.h>
#include <llvm/Support/xxhash.h>

#include <filesystem>
#include <functional>

#include "frontend/compiler.h"

#if CLANG_VERSION_MAJOR >= 22
#include <clang/Driver/CreateInvocationFromArgs.h>
#endif

namespace physgen::frontend {
namespace {

const std::string folder = "/physgen.program/";
const char* const precompiled_text = "#include <physgen/probe.h>\n\n#include <cstdlib>\n";

/// The name of the text of precompile(), which a precompiled header asks for again: it has another one with other
/// flags, since Clang does not compare all of them.
std::string precompiled_name(const std::vector<std::string>& flags) {
  std::string text;
  for (std::size_t i = 0; i < flags.size(); ++i)
    if (flags[i] == precompiled_flag)
      ++i;  // and not its file
    else
      text += flags[i] + '\n';
  return "precompiled." + llvm::utohexstr(llvm::xxh3_64bits(text)) + ".h";
}

/// The headers that physgen is installed with; in its own tree, those beside its sources.
std::string runtime_folder() {
  std::error_code error;
  const auto command = std::filesystem::read_symlink("/proc/self/exe", error);
  const auto installed = command.parent_path().parent_path() / "include";
  if (!error && std::filesystem::exists(installed / "physgen/probe.h", error)) return installed.string();
  return PHYSGEN_RUNTIME_INCLUDE;
}

std::vector<const char*> arguments(const std::string& path, const std::vector<std::string>& flags) {
  std::vector<const char*> result = {"clang++",       "-fsyntax-only",        "-x", "c++", "-std=c++20",
                                     "-resource-dir", PHYSGEN_CLANG_RESOURCES};
  // OpenMP's header belongs to other compilers, and the pragmas of loops declare nothing.
  for (const std::string& flag : flags)
    if (!flag.starts_with("-fopenmp")) result.push_back(flag.c_str());
  for (const char* flag : {"-w", "-ferror-limit=20", "-Qunused-arguments"}) result.push_back(flag);
  static const std::string runtime = "-I" + runtime_folder();
  result.push_back(runtime.c_str());  // last: the user's folders come first
  result.push_back(path.c_str());
  return result;
}

/// @param change what is particular to this run
ProgramOutcome run(const Program& program, clang::FrontendAction& action,
                   const std::function<void(clang::CompilerInvocation&)>& change) {
  ProgramOutcome outcome;
  llvm::raw_string_ostream diagnostics(outcome.diagnostics);
  const std::string path = folder + program.name;
  // A precompiled header's own text has to be there as well, unchanged.
  const Files files = files_with({{folder + precompiled_name(program.flags), precompiled_text}, {path, program.text}});
  clang::CreateInvocationOptions how;
#if CLANG_VERSION_MAJOR >= 21
  clang::DiagnosticOptions driver_options;
  how.Diags = clang::CompilerInstance::createDiagnostics(*files, driver_options,
                                                         new clang::TextDiagnosticPrinter(diagnostics, driver_options));
#else
  auto driver_options = llvm::makeIntrusiveRefCnt<clang::DiagnosticOptions>();
  how.Diags = clang::CompilerInstance::createDiagnostics(
#if CLANG_VERSION_MAJOR >= 20
      *files,
#endif
      driver_options.get(), new clang::TextDiagnosticPrinter(diagnostics, driver_options.get()));
#endif
  how.VFS = files;
  std::shared_ptr<clang::CompilerInvocation> invocation =
      clang::createInvocation(arguments(path, program.flags), std::move(how));
  diagnostics.flush();
  if (invocation == nullptr) return outcome;
  invocation->getFrontendOpts().DisableFree = false;
  change(*invocation);
  Compiled compiled = compile(invocation, files, action, diagnostics, false);
  outcome.parsed = compiled.good;
  for (std::string& file : compiled.dependencies)
    if (!file.starts_with(folder)) outcome.dependencies.push_back(std::move(file));
  return outcome;
}

}  // namespace

ProgramOutcome run(const Program& program, clang::FrontendAction& action) {
  return run(program, action, [&](clang::CompilerInvocation& invocation) {
    invocation.getFrontendOpts().SkipFunctionBodies = program.skip_bodies;
  });
}

ProgramOutcome precompile(const std::vector<std::string>& flags, const std::string& file) {
  clang::GeneratePCHAction action;
  return run({precompiled_name(flags), precompiled_text, flags}, action, [&](clang::CompilerInvocation& invocation) {
    invocation.getFrontendOpts().ProgramAction = clang::frontend::GeneratePCH;
    invocation.getFrontendOpts().OutputFile = file;
    invocation.getLangOpts().CompilingPCH = true;
    invocation.getLangOpts().PCHInstantiateTemplates = true;  // once, and not in each program
  });
}

}  // namespace physgen::frontend
