// See frontend.h. Sets up a Clang that parses C++20 from the schema's folder, the given folders and the built-in
// vocabulary, and nothing else.
#include "frontend/frontend.h"

#include <clang/AST/ASTConsumer.h>
#include <clang/AST/DeclCXX.h>
#include <clang/Basic/LangStandard.h>
#include <clang/Frontend/CompilerInstance.h>
#include <clang/Frontend/FrontendAction.h>
#include <clang/Lex/Preprocessor.h>
#include <llvm/TargetParser/Triple.h>

#include <map>

#include "frontend/compiler.h"
#include "frontend/objects.h"
#include "frontend/vocabulary.h"

namespace physgen::frontend {
namespace {

constexpr const char* vocabulary_dir = "/physgen.builtin";
// Any target with a 32-bit int will do, the same on every machine; this one has few builtins to register.
constexpr const char* target = "riscv64-unknown-linux-gnu";

class Consumer : public clang::ASTConsumer {
 public:
  Consumer(clang::Preprocessor& preprocessor, const ParseOptions& options, model::Schema& schema)
      : preprocessor_(preprocessor), options_(options), schema_(schema) {}

  void HandleTranslationUnit(clang::ASTContext& context) override {
    const bool has_vocabulary = preprocessor_.isMacroDefined("PHYSGEN_SCHEMA_H");
    schema_ = read_schema(context, context.getDiagnostics().hasErrorOccurred(), has_vocabulary, options_.objections);
  }

  /// Clang evaluates a variable field by field, those of nested structs included: twenty-five structs of two of the one
  /// before would take gigabytes. A struct of so many fields is called invalid, and its variables are not looked at; as
  /// an object it is far above what model::validate allows.
  void HandleTagDeclDefinition(clang::TagDecl* tag) override {
    auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(tag);
    if (record == nullptr || record->isDependentContext()) return;
    double count = 1;
    const auto add = [&](clang::QualType type) {
      const auto* nested = type->getBaseElementTypeUnsafe()->getAsCXXRecordDecl();
      const auto known = nested == nullptr ? fields_.end() : fields_.find(nested->getCanonicalDecl());
      count += known == fields_.end() ? 1 : known->second;
    };
    for (const auto& base : record->bases()) add(base.getType());
    for (const auto* field : record->fields()) add(field->getType());
    fields_[record->getCanonicalDecl()] = count;
    if (count > 1 << 18) record->setInvalidDecl();
  }

 private:
  std::map<const clang::CXXRecordDecl*, double> fields_;  // with those of nested structs
  clang::Preprocessor& preprocessor_;
  const ParseOptions& options_;
  model::Schema& schema_;
};

class Action : public clang::ASTFrontendAction {
 public:
  Action(const ParseOptions& options, model::Schema& schema) : options_(options), schema_(schema) {}

  std::unique_ptr<clang::ASTConsumer> CreateASTConsumer(clang::CompilerInstance& compiler, llvm::StringRef) override {
    return std::make_unique<Consumer>(compiler.getPreprocessor(), options_, schema_);
  }

 private:
  const ParseOptions& options_;
  model::Schema& schema_;
};

std::shared_ptr<clang::CompilerInvocation> invocation(const std::string& path, const ParseOptions& options) {
  auto result = std::make_shared<clang::CompilerInvocation>();
  result->getTargetOpts().Triple = target;
  auto& language = result->getLangOpts();
  std::vector<std::string> includes;
  clang::LangOptions::setLangDefaults(language, clang::Language::CXX, llvm::Triple(target), includes,
                                      clang::LangStandard::lang_cxx20);
  language.IsHeaderFile = true;  // #pragma once is right in a schema
  auto& search = result->getHeaderSearchOpts();
  search.UseBuiltinIncludes = false;
  search.UseStandardSystemIncludes = false;
  search.UseStandardCXXIncludes = false;
  for (const std::string& dir : options.include_dirs) search.AddPath(dir, clang::frontend::Angled, false, false);
  search.AddPath(vocabulary_dir, clang::frontend::System, false, false);
  auto& frontend = result->getFrontendOpts();
  frontend.ProgramAction = clang::frontend::ParseSyntaxOnly;
  frontend.Inputs.emplace_back(path, clang::InputKind(clang::Language::CXX));
  auto& diagnostics = result->getDiagnosticOpts();
  diagnostics.ShowOptionNames = true;
  diagnostics.Warnings.emplace_back("comment");  // a backslash that makes the next field part of a comment
  return result;
}

/// Notes that say how to mend an error of which Clang can only say that it does not know a name.
std::string notes(llvm::StringRef diagnostics) {
  std::string text;
  if (diagnostics.contains("' file not found"))
    text +=
        "note: a schema can include <physgen/schema.h> and other schemas, but no system headers; -I adds folders "
        "to look in\n";
  const bool library = diagnostics.contains("undeclared identifier 'std'") ||
                       diagnostics.contains("undeclared identifier 'Eigen'") ||
                       diagnostics.contains("in namespace 'std'");
  if (library || diagnostics.contains("unknown type name"))
    text +=
        "note: types of fields are " + model::joined(model::field_types()) +
        ", objects, and fixed arrays of these, 'Scalar x[8];'; write Vector<3> for Eigen::Vector3d or "
        "std::array<double, 3>, Matrix<3, 3> for Eigen::Matrix3d, and for a std::vector an array of objects of its own "
        "whose numbers are kept here as an Index\n";
  if (!library && (diagnostics.contains("use of undeclared identifier") || diagnostics.contains("call to 'format'") ||
                   diagnostics.contains("call to 'layout'")))
    text +=
        "note: options of fields are unit(\"Pa\"), range(low, high), initial(value) and format(space, encoding), "
        "of objects layout(space, pattern) and align(bytes); spaces are host and cuda, one layout and one format for "
        "each; patterns " +
        model::joined(model::layout_words("W")) + "; encodings " + model::joined(model::encoding_words()) +
        ", quaternion(), quaternion(half)\n";
  return text;
}

}  // namespace

Result parse(const std::string& path, const ParseOptions& options) {
  Result result;
  model::Schema schema;
  llvm::raw_string_ostream diagnostics(result.diagnostics);
  const Files files = files_with({{std::string(vocabulary_dir) + "/physgen/schema.h", vocabulary}});
  Action action(options, schema);
  Compiled compiled = compile(invocation(path, options), files, action, diagnostics, true);
  result.dependencies = std::move(compiled.dependencies);
  if (compiled.good) result.schema = std::move(schema);
  diagnostics << notes(result.diagnostics);
  diagnostics.flush();
  return result;
}

}  // namespace physgen::frontend
