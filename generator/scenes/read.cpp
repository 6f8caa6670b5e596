// See read.h. A declaration is parsed with all that its program needs, since the types of its arrays come from there,
// but bodies are skipped.
#include "scenes/read.h"

#include <clang/AST/ASTConsumer.h>
#include <clang/AST/Attr.h>
#include <clang/AST/DeclTemplate.h>
#include <clang/AST/PrettyPrinter.h>
#include <clang/AST/QualTypeNames.h>
#include <clang/AST/RawCommentList.h>
#include <clang/Frontend/CompilerInstance.h>
#include <clang/Frontend/FrontendAction.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "frontend/program.h"
#include "scenes/read_options.h"

namespace physgen::scenes {
namespace {

namespace fs = std::filesystem;

bool is_marked(const clang::Decl& declaration, llvm::StringRef annotation) {
  return llvm::any_of(declaration.specific_attrs<clang::AnnotateAttr>(),
                      [&](const auto* attribute) { return attribute->getAnnotation() == annotation; });
}

class SceneReader {
 public:
  SceneReader(clang::ASTContext& context, std::string path, bool clang_errors)
      : context_(context), report_(context, clang_errors), path_(std::move(path)) {}

  /// @return none: there is not one scene
  std::optional<Scene> read() {
    declarations(*context_.getTranslationUnitDecl());
    if (scenes_.empty() && !report_.clang_errors())
      report_.error(beginning_, "this file declares no scene; write 'struct PHYSGEN_SCENE() " +
                                    fs::path(path_).stem().string() +
                                    " { ... };' with its groups of arrays and its "
                                    "program, as <physgen/scene.h> says");
    if (scenes_.size() > 1)
      report_.error(
          scenes_[1]->getLocation(),
          "a file declares one scene; move " + frontend::in_quotes(scenes_[1]->getName()) + " to a file of its own");
    std::optional<Scene> result;
    if (scenes_.size() == 1) result = scene(*scenes_.front());
    report_.flush();
    return result;
  }

 private:
  [[nodiscard]] bool in_file(clang::SourceLocation where) const {
    const auto& sources = context_.getSourceManager();
    const auto name = sources.getFilename(sources.getFileLoc(where));
    return !name.empty() && (name == path_ || fs::path(name.str()).lexically_normal() == fs::path(path_));
  }

  void declarations(const clang::DeclContext& scope) {
    for (const clang::Decl* declaration : scope.decls()) {
      if (const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(declaration)) {
        declarations(*space);
      } else if (const auto* linkage = llvm::dyn_cast<clang::LinkageSpecDecl>(declaration)) {
        declarations(*linkage);
      } else if (in_file(declaration->getLocation())) {
        if (beginning_.isInvalid()) beginning_ = declaration->getLocation();
        const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(declaration);
        if (record != nullptr && record->isThisDeclarationADefinition() && is_marked(*record, scene_annotation))
          scenes_.push_back(record);
      }
    }
  }

  std::string comment(const clang::Decl& declaration) const {
    const auto* raw = context_.getRawCommentForAnyRedecl(&declaration);
    if (raw == nullptr || !raw->isDocumentation()) return {};
    const std::string text = raw->getFormattedText(context_.getSourceManager(), context_.getDiagnostics());
    return llvm::StringRef(text).trim().str();
  }

  Scene scene(const clang::CXXRecordDecl& record) {
    Scene scene;
    scene.name = record.getName().str();
    const std::string qualified = record.getQualifiedNameAsString();
    scene.scope = qualified.size() > scene.name.size() + 2
                      ? qualified.substr(0, qualified.size() - scene.name.size() - 2)
                      : std::string();
    scene.doc = comment(record);
    scene.location = location(context_, record.getLocation());
    const std::string stem = fs::path(path_).stem().string();
    if (scene.name != stem)
      report_.error(record.getLocation(), "scene " + frontend::in_quotes(scene.name) + " stands in the file of " +
                                              frontend::in_quotes(stem) +
                                              "; give both one name, which the generated files get");
    for (const clang::Decl* member : record.decls()) {
      if (const auto* alias = llvm::dyn_cast<clang::TypedefNameDecl>(member); alias && alias->getName() == "Real")
        scene.real = alias->getUnderlyingType().getCanonicalType().getAsString();
    }
    groups(record, scene);
    if (scene.groups.empty() && !report_.has_errors())
      report_.error(record.getLocation(),
                    "scene " + frontend::in_quotes(scene.name) +
                        " has no arrays; write a group, 'struct Body { PHYSGEN_ARRAY(per(\"tet\")) "
                        "Array<elasticity::TetObject, Real> tets; };'");
    check_names(scene, arrays_, report_);
    program(record, scene);
    return scene;
  }

  /// Those of what the scene derives from, and then its own.
  void groups(const clang::CXXRecordDecl& record, Scene& scene) {
    for (const clang::CXXBaseSpecifier& base : record.bases()) {
      const auto* type = base.getType()->getAsCXXRecordDecl();
      if (type != nullptr && type->hasDefinition()) groups(*type->getDefinition(), scene);
    }
    for (const clang::Decl* member : record.decls()) {
      const auto* group = llvm::dyn_cast<clang::CXXRecordDecl>(member);
      if (group != nullptr && group->isThisDeclarationADefinition() && !group->isInjectedClassName()) {
        if (!is_group(*group)) continue;
        if (auto read = this->group(*group); !read.arrays.empty()) scene.groups.push_back(std::move(read));
      } else if (is_marked(*member, array_annotation)) {
        report_.error(member->getLocation(),
                      "arrays stand in a group of their scene, which programs get as a whole; write 'struct Body { "
                      "PHYSGEN_ARRAY(...) ...; };'");
      }
    }
  }
  /// Others are types of the program's parameters.
  static bool is_group(const clang::CXXRecordDecl& record) {
    return llvm::any_of(record.fields(), [](const clang::FieldDecl* field) {
      return is_marked(*field, array_annotation) || is_array(field->getType());
    });
  }

  Group group(const clang::CXXRecordDecl& record) {
    Group group;
    group.name = record.getName().str();
    group.doc = comment(record);
    group.location = location(context_, record.getLocation());
    for (const clang::FieldDecl* member : record.fields()) {
      if (!is_marked(*member, array_annotation)) {
        report_.error(member->getLocation(), frontend::in_quotes(member->getName()) +
                                                 " is not marked as an array; write "
                                                 "PHYSGEN_ARRAY(per(\"tet\"), ...) before it");
        continue;
      }
      Array array;
      array.name = member->getName().str();
      array.doc = comment(*member);
      array.location = location(context_, member->getLocation());
      if (!read_type(*member, array, report_)) continue;
      read_options(*member, array, report_);
      group.arrays.push_back(std::move(array));
      arrays_.push_back(member);
    }
    return group;
  }

  /// The program's names of the groups, and the parameters that it takes behind them.
  void program(const clang::CXXRecordDecl& record, Scene& scene) {
    const std::string form =
        "write 'template <class On" + templates(scene) + "> static void program(On& on" + references(scene) + ")'";
    const clang::FunctionTemplateDecl* program = nullptr;
    for (const clang::Decl* member : record.decls()) {
      const auto* candidate = llvm::dyn_cast<clang::FunctionTemplateDecl>(member);
      if (candidate != nullptr && candidate->getName() == "program") program = candidate;
    }
    if (program == nullptr)
      return report_.error(record.getLocation(),
                           "scene " + frontend::in_quotes(scene.name) + " has no function template 'program'; " + form);
    const auto& function = *program->getTemplatedDecl();
    const std::size_t groups = scene.groups.size();
    if (report_.has_errors()) return;  // groups may not have been read
    if (!function.isStatic() || program->getTemplateParameters()->size() != groups + 1 ||
        function.getNumParams() < groups + 1)
      return report_.error(
          program->getLocation(),
          "program takes an executor and a reference to each group, in their order, and is static; " + form);
    for (std::size_t i = 0; i < groups; ++i) {
      const std::string name = function.getParamDecl(static_cast<unsigned>(i + 1))->getName().str();
      scene.groups[i].variable = name.empty() ? lower(scene.groups[i].name) : name;
    }
    clang::PrintingPolicy policy(context_.getLangOpts());
    policy.SuppressTagKeyword = true;
    for (auto i = static_cast<unsigned>(groups + 1); i < function.getNumParams(); ++i) {
      const auto* parameter = function.getParamDecl(i);
      if (parameter->getType()->isDependentType())
        report_.error(parameter->getLocation(),
                      "a parameter of program behind its groups must not depend on a template's parameter; "
                      "write a concrete type");
      else
        scene.parameters.push_back(clang::TypeName::getFullyQualifiedName(
            parameter->getType().getNonReferenceType().getUnqualifiedType(), context_, policy));
    }
  }

  static std::string lower(std::string name) {
    name.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
    return name;
  }
  static std::string templates(const Scene& scene) {
    std::string text;
    for (const Group& group : scene.groups) text += ", class " + group.name;
    return text;
  }
  static std::string references(const Scene& scene) {
    std::string text;
    for (const Group& group : scene.groups) text += ", " + group.name + "& " + lower(group.name);
    return text;
  }

  clang::ASTContext& context_;
  frontend::Report report_;
  std::string path_;
  clang::SourceLocation beginning_;
  std::vector<const clang::CXXRecordDecl*> scenes_;
  std::vector<const clang::FieldDecl*> arrays_;  // of all groups, in order
};

class Consumer : public clang::ASTConsumer {
 public:
  Consumer(std::string path, std::optional<Scene>& scene) : path_(std::move(path)), scene_(scene) {}
  void HandleTranslationUnit(clang::ASTContext& context) override {
    scene_ = SceneReader(context, path_, context.getDiagnostics().hasErrorOccurred()).read();
  }

 private:
  std::string path_;
  std::optional<Scene>& scene_;
};

class Action : public clang::ASTFrontendAction {
 public:
  Action(std::string path, std::optional<Scene>& scene) : path_(std::move(path)), scene_(scene) {}
  std::unique_ptr<clang::ASTConsumer> CreateASTConsumer(clang::CompilerInstance& /*compiler*/,
                                                        llvm::StringRef /*file*/) override {
    return std::make_unique<Consumer>(path_, scene_);
  }

 private:
  std::string path_;
  std::optional<Scene>& scene_;
};

/// How the file is included, by the folder of -I that it lies in; its bare name, if it lies in none.
std::string include_name(const fs::path& path, const std::vector<std::string>& flags) {
  std::string best = path.filename().string();
  std::size_t longest = 0;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    std::string folder;
    if (flags[i] == "-I" && i + 1 < flags.size())
      folder = flags[i + 1];
    else if (flags[i].starts_with("-I"))
      folder = flags[i].substr(2);
    if (folder.empty()) continue;
    const std::string base = fs::absolute(folder).lexically_normal().string();
    const std::string relative = path.lexically_relative(base).generic_string();
    if (relative.empty() || relative.starts_with("..") || base.size() <= longest) continue;
    longest = base.size();
    best = relative;
  }
  return best;
}

}  // namespace

Declaration read(const std::string& path, const std::vector<std::string>& flags) {
  Declaration result;
  const fs::path absolute = fs::absolute(path).lexically_normal();
  std::optional<Scene> scene;
  Action action(absolute.string(), scene);
  auto outcome = frontend::run(
      {.name = "scene.cpp", .text = "#include \"" + absolute.string() + "\"\n", .flags = flags, .skip_bodies = true},
      action);
  result.diagnostics = std::move(outcome.diagnostics);
  result.dependencies = std::move(outcome.dependencies);
  if (outcome.parsed && scene) {
    scene->file = path;
    scene->include = include_name(absolute, flags);
    for (Group& group : scene->groups)
      for (Array& array : group.arrays)
        array.header = include_name(fs::absolute(array.header).lexically_normal(), flags);
    result.scene = std::move(scene);
  }
  return result;
}

}  // namespace physgen::scenes
