// See program.h. Clang's driver turns the flags into an invocation, as for the command clang++.
#include "frontend/program.h"

#include <clang/Basic/Version.h>
#include <clang/Frontend/CompilerInstance.h>
#include <clang/Frontend/FrontendAction.h>
#include <clang/Frontend/TextDiagnosticPrinter.h>
#include <clang/Frontend/Utils.h>

#include <filesystem>

#include "frontend/compiler.h"

#if CLANG_VERSION_MAJOR >= 22
#include <clang/Driver/CreateInvocationFromArgs.h>
#endif

namespace physgen::frontend {
namespace {

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

}  // namespace

ProgramOutcome run(const Program& program, clang::FrontendAction& action) {
  ProgramOutcome outcome;
  llvm::raw_string_ostream diagnostics(outcome.diagnostics);
  const std::string path = "/physgen.program/" + program.name;
  const Files files = files_with(path, program.text);
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
  invocation->getFrontendOpts().SkipFunctionBodies = program.skip_bodies;
  Compiled compiled = compile(invocation, files, action, diagnostics, false);
  outcome.parsed = compiled.good;
  for (std::string& file : compiled.dependencies)
    if (file != path) outcome.dependencies.push_back(std::move(file));
  return outcome;
}

}  // namespace physgen::frontend
