// Collects what the frontend itself has to say about a schema and hands it to Clang's diagnostics in source order, so
// that it looks like Clang's own.
#pragma once

#include <clang/AST/ASTContext.h>
#include <clang/AST/Decl.h>

#include <optional>
#include <string>
#include <vector>

#include "model/text.h"

namespace physgen::frontend {

struct Note {
  clang::SourceRange range;
  std::string message;
};

class Report {
 public:
  /// @param clang_errors Clang has reported errors: what may only follow from these is not worth a report
  Report(clang::ASTContext& context, bool clang_errors) : context_(context), clang_errors_(clang_errors) {}

  /// @param range what is underlined; the caret is at its beginning
  void error(clang::SourceRange range, std::string message, std::optional<Note> note = {});

  /// Sends everything to Clang's diagnostics, sorted by place.
  void flush();

  [[nodiscard]] bool has_errors() const { return !entries_.empty(); }  // not yet sent
  [[nodiscard]] bool clang_errors() const { return clang_errors_; }
  [[nodiscard]] clang::ASTContext& context() const { return context_; }

 private:
  struct Entry {
    clang::SourceRange range;
    std::string message;
    std::optional<Note> note;
  };
  void emit(unsigned id, clang::SourceRange range, const std::string& message);

  clang::ASTContext& context_;
  bool clang_errors_;
  std::vector<Entry> entries_;
};

using model::in_quotes;

/// If the type is declared in physgen::schema, its name there; else empty.
[[nodiscard]] llvm::StringRef vocabulary_name(const clang::CXXRecordDecl* record);

/// If the type is that of an option, declared in physgen::schema::detail, its name there; else empty.
[[nodiscard]] llvm::StringRef option_name(const clang::CXXRecordDecl* record);

}  // namespace physgen::frontend
