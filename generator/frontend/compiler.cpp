// See compiler.h. The differences between versions of Clang's set-up are here, and where program.cpp reads flags.
#include "frontend/compiler.h"

#include <clang/Basic/Version.h>
#include <clang/Frontend/CompilerInstance.h>
#include <clang/Frontend/FrontendAction.h>
#include <clang/Frontend/TextDiagnosticPrinter.h>
#include <clang/Frontend/Utils.h>
#include <llvm/Support/CrashRecoveryContext.h>

namespace physgen::frontend {
namespace {

constexpr unsigned stack_bytes = 256U << 20;

}  // namespace

Files files_with(const std::vector<std::pair<std::string, llvm::StringRef>>& texts) {
  auto memory = llvm::makeIntrusiveRefCnt<llvm::vfs::InMemoryFileSystem>();
  for (const auto& [path, text] : texts) memory->addFile(path, 0, llvm::MemoryBuffer::getMemBuffer(text));
  auto files = llvm::makeIntrusiveRefCnt<llvm::vfs::OverlayFileSystem>(llvm::vfs::getRealFileSystem());
  files->pushOverlay(memory);
  return files;
}

Compiled compile(const std::shared_ptr<clang::CompilerInvocation>& invocation, const Files& files,
                 clang::FrontendAction& action, llvm::raw_ostream& diagnostics, bool fatals_as_errors) {
#if CLANG_VERSION_MAJOR >= 21
  clang::CompilerInstance compiler(invocation);
  auto* printer =
      new clang::TextDiagnosticPrinter(diagnostics, invocation->getDiagnosticOpts());  // the compiler owns it
#else
  clang::CompilerInstance compiler;
  compiler.setInvocation(invocation);
  auto* printer = new clang::TextDiagnosticPrinter(diagnostics, &invocation->getDiagnosticOpts());
#endif
#if CLANG_VERSION_MAJOR >= 22
  compiler.setVirtualFileSystem(files);
  compiler.createDiagnostics(printer);
  compiler.createFileManager();
#elif CLANG_VERSION_MAJOR >= 20
  compiler.createDiagnostics(*files, printer);
  compiler.createFileManager(files);
#else
  compiler.createDiagnostics(printer);
  compiler.createFileManager(files);
#endif
  compiler.getDiagnostics().setFatalsAsError(fatals_as_errors);
  compiler.setVerboseOutputStream(diagnostics);  // "2 errors generated."
  const auto dependencies = std::make_shared<clang::DependencyCollector>();
  compiler.addDependencyCollector(dependencies);
  // On a thread for its stack: Clang skips brackets that nothing closes by recursion, and a hundred thousand of them
  // are soon there where a file is damaged.
  bool completed = false;
  llvm::CrashRecoveryContext().RunSafelyOnThread([&] { completed = compiler.ExecuteAction(action); }, stack_bytes);
  diagnostics.flush();
  return {completed && !compiler.getDiagnostics().hasErrorOccurred(), dependencies->getDependencies().vec()};
}

}  // namespace physgen::frontend
