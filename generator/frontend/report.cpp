// See report.h.
#include "frontend/report.h"

#include <clang/AST/DeclCXX.h>
#include <clang/Basic/SourceManager.h>

#include <algorithm>

namespace physgen::frontend {

void Report::error(clang::SourceRange range, std::string message, std::optional<Note> note) {
  const auto is_said = [&](const Entry& entry) { return entry.range == range && entry.message == message; };
  if (std::any_of(entries_.begin(), entries_.end(), is_said)) return;  // two options may name one constant
  entries_.push_back({range, std::move(message), std::move(note)});
}

void Report::flush() {
  const auto& sources = context_.getSourceManager();
  const auto place = [&](const Entry& entry) { return sources.getFileLoc(entry.range.getBegin()); };
  std::stable_sort(entries_.begin(), entries_.end(), [&](const Entry& a, const Entry& b) {
    return place(a) != place(b) && sources.isBeforeInTranslationUnit(place(a), place(b));
  });
  auto& engine = context_.getDiagnostics();
  const unsigned error_id = engine.getCustomDiagID(clang::DiagnosticsEngine::Error, "%0");
  const unsigned note_id = engine.getCustomDiagID(clang::DiagnosticsEngine::Note, "%0");
  for (const Entry& entry : entries_) {
    emit(error_id, entry.range, entry.message);
    if (entry.note) emit(note_id, entry.note->range, entry.note->message);
  }
  entries_.clear();
}

void Report::emit(unsigned id, clang::SourceRange range, const std::string& message) {
  const auto& sources = context_.getSourceManager();
  // In terms of the file, not of the macros: what PHYSGEN() expands to is of no interest to the reader.
  const auto begin = sources.getFileLoc(range.getBegin());
  auto end = sources.getFileLoc(range.getEnd());
  if (range.getEnd().isMacroID() && !sources.isMacroArgExpansion(range.getEnd()))
    end = sources.getExpansionRange(range.getEnd()).getEnd();
  context_.getDiagnostics().Report(begin, id) << message << clang::CharSourceRange::getTokenRange(begin, end);
}

namespace {

/// The declaration's enclosing namespace if it is called `name`, else null.
const clang::NamespaceDecl* within(const clang::Decl* declaration, llvm::StringRef name) {
  if (declaration == nullptr) return nullptr;
  const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(declaration->getDeclContext());
  return space != nullptr && space->getName() == name ? space : nullptr;
}

bool is_vocabulary(const clang::NamespaceDecl* schema) {
  const auto* physgen = within(schema, "physgen");
  return physgen != nullptr && physgen->getDeclContext()->getRedeclContext()->isTranslationUnit();
}

}  // namespace

llvm::StringRef vocabulary_name(const clang::CXXRecordDecl* record) {
  if (record == nullptr || record->getIdentifier() == nullptr || !is_vocabulary(within(record, "schema"))) return {};
  return record->getName();
}

llvm::StringRef option_name(const clang::CXXRecordDecl* record) {
  if (record == nullptr || record->getIdentifier() == nullptr) return {};
  return is_vocabulary(within(within(record, "detail"), "schema")) ? record->getName() : llvm::StringRef();
}

}  // namespace physgen::frontend
