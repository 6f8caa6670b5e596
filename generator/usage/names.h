// The names of Clang's declarations in a report: files, places, kernels, arrays and fields.
#pragma once

#include <clang/AST/ASTContext.h>
#include <clang/AST/DeclTemplate.h>
#include <clang/Basic/SourceManager.h>

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "usage/graph.h"

namespace physgen::usage {

class Names {
 public:
  /// @param folders in which #include looks: files are named without them
  Names(clang::ASTContext& context, const std::vector<std::string>& folders);

  [[nodiscard]] Place place(clang::SourceLocation location) const;
  /// Whether the file is the runtime's, generated, Eigen's or the system's. Those that lie beside the definitions of
  /// the runtime are its own, whatever other folders are called.
  [[nodiscard]] bool is_library(clang::SourceLocation location) const;

  /// Specialisations of physgen::Probe that the program uses.
  [[nodiscard]] std::vector<const clang::ClassTemplateSpecializationDecl*> probes() const;
  /// The array and field of a specialisation of Probe.
  [[nodiscard]] ReachedField field(const clang::ClassTemplateSpecializationDecl& probe);
  /// Specialisations of the function templates that executors of probes instantiate.
  [[nodiscard]] std::vector<const clang::FunctionDecl*> steps() const;
  /// The functions of a scene's unit that run its program: over probes, and then over other arrays.
  [[nodiscard]] std::vector<const clang::FunctionDecl*> variants() const;
  /// Name, place, arrays and own files of a step.
  [[nodiscard]] Step step(const clang::FunctionDecl& function);
  /// Arrays whose tags a type mentions, in the order of its parameters and members.
  [[nodiscard]] std::vector<std::string> arrays(clang::QualType type);
  [[nodiscard]] std::string kernel_name(const clang::CXXRecordDecl& kernel) const;
  /// Whether a class is a generated reference to objects, such as elasticity::TetRef.
  [[nodiscard]] static bool is_object_reference(const clang::CXXRecordDecl& record);
  /// Whether a class or a function is `name` of namespace physgen, or of namespaces in it, innermost first.
  [[nodiscard]] static bool is_physgen(const clang::NamedDecl* declaration, llvm::StringRef name,
                                       std::initializer_list<llvm::StringRef> inner = {});

 private:
  using Visit = std::function<bool(const clang::CXXRecordDecl&)>;
  [[nodiscard]] const clang::DeclContext* space(std::initializer_list<llvm::StringRef> path) const;
  void classes(clang::QualType type, const Visit& visit, std::set<const clang::Decl*>& seen) const;
  void classes(const clang::TemplateArgument& argument, const Visit& visit, std::set<const clang::Decl*>& seen) const;
  /// The tag of a probe's array, and the name of the template in its place: "AtOwnIndex", "AtOwnOfPart" or none.
  [[nodiscard]] static std::pair<const clang::CXXRecordDecl*, llvm::StringRef> tag_of(
      const clang::ClassTemplateSpecializationDecl& probe);
  [[nodiscard]] std::string tag_name(const clang::CXXRecordDecl& tag);

  clang::ASTContext& context_;
  const clang::SourceManager& sources_;
  const std::vector<std::string>& folders_;
  std::vector<std::string> libraries_;  // folders of the runtime and of Eigen
  std::map<const clang::Decl*, std::string> tags_;
  std::map<const clang::Decl*, std::vector<std::string>> fields_;  // of objects
};

}  // namespace physgen::usage
