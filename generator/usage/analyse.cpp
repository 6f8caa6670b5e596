// See analyse.h. How a side is compiled stands here: flags, and the place of a CUDA toolkit.
#include "usage/analyse.h"

#include <clang/AST/ASTConsumer.h>
#include <clang/AST/DeclCXX.h>
#include <clang/Frontend/CompilerInstance.h>
#include <clang/Frontend/FrontendAction.h>
#include <clang/Lex/HeaderSearchOptions.h>
#include <clang/Lex/PPCallbacks.h>
#include <clang/Lex/Preprocessor.h>
#include <clang/Sema/Sema.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "frontend/program.h"
#include "usage/walk.h"

namespace physgen::usage {
namespace {

using Clock = std::chrono::steady_clock;

struct Reading {
  Usage usage;
  Clock::time_point headers_end = Clock::now();
  bool past_headers = false;       ///< and in what a unit goes on with
  Clock::duration elsewhere = {};  ///< time in which others found that
};

/// Notes when the last header has been parsed.
class HeaderEnd : public clang::PPCallbacks {
 public:
  explicit HeaderEnd(Reading& reading) : reading_(reading) {}
  void FileChanged(clang::SourceLocation /*place*/, FileChangeReason reason, clang::SrcMgr::CharacteristicKind /*kind*/,
                   clang::FileID /*before*/) override {
    if (reason == ExitFile && !reading_.past_headers) reading_.headers_end = Clock::now();
  }

 private:
  Reading& reading_;
};

/// Collects the functions that the parser and the instantiation of templates hand over.
class Consumer : public clang::ASTConsumer {
 public:
  Consumer(clang::CompilerInstance& compiler, Reading& reading, const Reader& reader, const Rest& rest)
      : compiler_(compiler), reading_(reading), reader_(reader), rest_(rest) {}

  bool HandleTopLevelDecl(clang::DeclGroupRef group) override {
    for (const clang::Decl* declaration : group) collect(declaration);
    const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(*group.begin());
    if (rest_ && !reading_.past_headers && space != nullptr && space->getName() == "physgen_probe_unit") go_on();
    return true;
  }
  void HandleInlineFunctionDefinition(clang::FunctionDecl* function) override { collect(function); }

  void HandleTranslationUnit(clang::ASTContext& context) override {
    // A program that compiles over probes and not over other arrays is another program there.
    if (context.getDiagnostics().hasErrorOccurred() && !graph_) return;
    if (graph_)
      reading_.usage.dependences = dependences(graph_->read_variants());
    else
      read_usage(context);
    if (reader_ && !context.getDiagnostics().hasErrorOccurred()) reader_(context, folders_);
  }

 private:
  void read_usage(clang::ASTContext& context) {
    for (const auto& entry : compiler_.getHeaderSearchOpts().UserEntries) {
      std::string folder = entry.Path;
      while (folder.size() > 1 && folder.back() == '/') folder.pop_back();
      folders_.push_back(std::move(folder));
    }
    folders_.emplace_back("/physgen.program");  // of the source itself
    graph_.emplace(context, folders_);
    reading_.usage = attribute(graph_->read(functions_));
  }

  /// Instantiates what Clang leaves to the end of a unit, and lets the parser go on with other text.
  void go_on() {
    reading_.past_headers = true;
    clang::Sema& sema = compiler_.getSema();
    do sema.PerformPendingInstantiations();
    while (sema.DefineUsedVTables());
    if (compiler_.getDiagnostics().hasErrorOccurred()) return;
    read_usage(compiler_.getASTContext());
    const auto begin = Clock::now();
    const std::string text = rest_(reading_.usage);
    reading_.elsewhere = Clock::now() - begin;
    const auto file = compiler_.getSourceManager().createFileID(
        llvm::MemoryBuffer::getMemBufferCopy(text, "/physgen.program/arrays.physgen.h"));
    compiler_.getPreprocessor().EnterSourceFile(file, nullptr, clang::SourceLocation());
  }

  void collect(const clang::Decl* declaration) {
    if (const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(declaration)) {
      for (const clang::Decl* inner : space->decls()) collect(inner);
    } else if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(declaration)) {
      if (!function->isDependentContext()) functions_.push_back(function);
    }
  }

  clang::CompilerInstance& compiler_;
  Reading& reading_;
  const Reader& reader_;
  const Rest& rest_;
  std::vector<const clang::FunctionDecl*> functions_;
  std::vector<std::string> folders_;
  std::optional<GraphReader> graph_;
};

class Action : public clang::ASTFrontendAction {
 public:
  Action(Reading& reading, const Reader& reader, const Rest& rest) : reading_(reading), reader_(reader), rest_(rest) {}

  std::unique_ptr<clang::ASTConsumer> CreateASTConsumer(clang::CompilerInstance& compiler, llvm::StringRef) override {
    compiler.getPreprocessor().addPPCallbacks(std::make_unique<HeaderEnd>(reading_));
    return std::make_unique<Consumer>(compiler, reading_, reader_, rest_);
  }

 private:
  Reading& reading_;
  const Reader& reader_;
  const Rest& rest_;
};

/// The folder of the CUDA toolkit; empty: there is none.
std::string cuda_folder() {
  std::vector<std::string> candidates;
  for (const char* variable : {"CUDA_HOME", "CUDA_PATH"})
    if (const char* folder = std::getenv(variable); folder != nullptr && *folder != 0) candidates.emplace_back(folder);
  candidates.emplace_back("/usr/local/cuda");
  std::error_code ignored;
  for (const std::string& folder : candidates)
    if (std::filesystem::exists(folder + "/include/cuda_runtime.h", ignored)) return folder;
  return {};
}

std::vector<std::string> flags_of(Side side, const std::vector<std::string>& flags) {
  std::vector<std::string> result;
  if (side == Side::device)
    result = {"-x", "cuda", "--cuda-device-only", "--cuda-gpu-arch=sm_90", "--cuda-path=" + cuda_folder()};
  for (const std::string& flag : flags) {
    const bool of_processor = flag.starts_with("-march=") || flag.starts_with("-mcpu=") || flag.starts_with("-mtune=");
    const bool is_precompiled = !result.empty() && result.back() == frontend::precompiled_flag;
    if (side == Side::host || !of_processor) result.push_back(is_precompiled ? precompiled(flag, side) : flag);
  }
  return result;
}

/// Clang has its own list of toolkits that it knows; what it says of others concerns no program.
std::string without_toolkit_warning(std::string text) {
  const auto warning = text.find("warning: CUDA version is newer");
  if (warning != std::string::npos) text.erase(warning, text.find('\n', warning) - warning + 1);
  return text;
}

/// Says what to do where Clang can only say that types do not fit.
std::string notes(const std::string& diagnostics) {
  const bool of_probes = diagnostics.find("Probe<") != std::string::npos;
  bool does_not_fit = false;
  for (const char* message : {"no viable", "invokes a deleted function"})
    does_not_fit = does_not_fit || diagnostics.find(message) != std::string::npos;
  if (!of_probes || !does_not_fit) return {};
  return "note: a kernel over one type of view takes no others: write it as a template over its views, "
         "'template <class View> struct Kernel { View view; ... };'\n";
}

double seconds(Clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

}  // namespace

std::string text_of_time(const std::string& program, Side side, const Diagnostics& diagnostics) {
  std::ostringstream text;
  text.precision(2);
  text << program << (side == Side::host ? ", host" : ", device") << std::fixed << ": analysed in "
       << diagnostics.seconds << " s, of which its headers took " << diagnostics.headers_seconds << " s to parse ("
       << diagnostics.seconds / diagnostics.headers_seconds << " times as long)\n";
  return std::move(text).str();
}

bool has_device_side() { return !cuda_folder().empty(); }

std::string precompiled(const std::string& file, Side side) { return side == Side::host ? file : file + ".device"; }

bool precompile(const std::string& file, const std::vector<std::string>& flags, const std::vector<Side>& sides,
                Diagnostics& diagnostics) {
  bool good = true;
  for (const Side side : sides) {
    const auto outcome = frontend::precompile(flags_of(side, flags), precompiled(file, side));
    diagnostics.text += without_toolkit_warning(outcome.diagnostics);
    diagnostics.dependencies.insert(diagnostics.dependencies.end(), outcome.dependencies.begin(),
                                    outcome.dependencies.end());
    good = good && outcome.parsed;
  }
  return good;
}

std::vector<std::string> with_precompiled(const std::string& file, std::vector<std::string> flags) {
  flags.insert(flags.begin(), {frontend::precompiled_flag, file});
  return flags;
}

std::optional<Usage> analyse(const std::string& name, const std::string& source, const std::vector<std::string>& flags,
                             Side side, Diagnostics& diagnostics, const Reader& reader, const Rest& rest) {
  const auto begin = Clock::now();
  Reading reading;
  Action action(reading, reader, rest);
  // The parser looks one token ahead: over this one, and not over what the unit goes on with.
  const std::string text = rest ? source + ";\n" : source;
  const auto outcome = frontend::run({name, text, flags_of(side, flags), false}, action);
  diagnostics.text = without_toolkit_warning(outcome.diagnostics) + notes(outcome.diagnostics);
  diagnostics.dependencies = outcome.dependencies;
  diagnostics.headers_seconds = seconds(reading.headers_end - begin);
  diagnostics.seconds = seconds(Clock::now() - begin - reading.elsewhere);
  if (!reading.usage.dependences.empty())
    diagnostics.text.clear();  // they say it better
  else if (!outcome.parsed)
    return std::nullopt;
  return std::move(reading.usage);
}

}  // namespace physgen::usage
