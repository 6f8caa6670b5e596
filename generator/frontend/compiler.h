// Runs Clang over one file. Clang's types are in the interface: for the readers of schemas and of programs.
#pragma once

#include <clang/Frontend/CompilerInvocation.h>
#include <llvm/Support/VirtualFileSystem.h>
#include <llvm/Support/raw_ostream.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace clang {
class FrontendAction;
}

namespace physgen::frontend {

using Files = llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem>;

/// The files of the system, and more with these paths and texts, which must outlive them.
[[nodiscard]] Files files_with(const std::vector<std::pair<std::string, llvm::StringRef>>& texts);

struct Compiled {
  bool good = false;                      ///< the action was done, without errors
  std::vector<std::string> dependencies;  ///< files that were read, as they were named
};

/// Runs `action` as the invocation says.
/// @param diagnostics gets errors and warnings as Clang prints them
/// @param fatals_as_errors a missing header does not hide the errors behind it
[[nodiscard]] Compiled compile(const std::shared_ptr<clang::CompilerInvocation>& invocation, const Files& files,
                               clang::FrontendAction& action, llvm::raw_ostream& diagnostics, bool fatals_as_errors);

}  // namespace physgen::frontend
