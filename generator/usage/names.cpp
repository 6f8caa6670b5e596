// See names.h.
#include "usage/names.h"

#include <clang/AST/DeclCXX.h>
#include <clang/AST/ExprCXX.h>
#include <clang/AST/Type.h>

#include <algorithm>
#include <functional>

namespace physgen::usage {
namespace {

using clang::CXXRecordDecl;
using clang::FunctionDecl;

const clang::StringLiteral* first_text(const clang::Stmt* statement) {
  if (statement == nullptr) return nullptr;
  if (const auto* text = llvm::dyn_cast<clang::StringLiteral>(statement)) return text;
  for (const clang::Stmt* child : statement->children())
    if (const auto* text = first_text(child)) return text;
  return nullptr;
}

/// The names in the texts of an object's fields, {{{"U", "1"}, {"V"}}}: of each innermost pair of braces, the first
/// text.
void first_texts(const clang::Stmt* statement, std::vector<std::string>& texts) {
  if (statement == nullptr) return;
  const auto* braces = llvm::dyn_cast<clang::InitListExpr>(statement);
  const bool innermost =
      braces != nullptr && braces->getNumInits() > 0 && !llvm::isa<clang::InitListExpr>(braces->getInit(0));
  if (const auto* text = innermost ? first_text(braces->getInit(0)) : nullptr) {
    std::string name = text->getString().str();
    for (std::size_t at; (at = name.find("[0]")) != std::string::npos;) name.erase(at, 3);  // one for all entries
    texts.push_back(std::move(name));
    return;
  }
  for (const clang::Stmt* child : statement->children()) first_texts(child, texts);
}

const clang::Expr* initializer(const clang::VarDecl* variable) {
  if (variable == nullptr) return nullptr;
  if (variable->getAnyInitializer() == nullptr && variable->getTemplateInstantiationPattern() != nullptr)
    variable = variable->getTemplateInstantiationPattern();
  return variable->getAnyInitializer();
}

}  // namespace

Names::Names(clang::ASTContext& context, const std::vector<std::string>& folders)
    : context_(context), sources_(context.getSourceManager()), folders_(folders) {
  for (const auto* probe : probes())
    if (const auto* tag = tag_of(*probe).first) tags_.emplace(tag->getCanonicalDecl(), tag_name(*tag));
  for (const auto& [name, declared] : {std::pair("physgen", "Probe"), std::pair("Eigen", "Matrix")})
    if (const auto* scope = space({name}); scope != nullptr)
      for (const clang::NamedDecl* found : scope->lookup(&context_.Idents.get(declared))) {
        const llvm::StringRef file = sources_.getFilename(sources_.getFileLoc(found->getLocation()));
        const std::size_t at = file.rfind(std::string("/") + name + "/");
        if (at != llvm::StringRef::npos) libraries_.push_back(file.substr(0, at).str() + "/" + name + "/");
      }
}

Place Names::place(clang::SourceLocation location) const {
  const auto presumed = sources_.getPresumedLoc(sources_.getFileLoc(location));
  if (presumed.isInvalid()) return {};
  std::string file = presumed.getFilename();
  std::size_t prefix = 0;
  for (const std::string& folder : folders_)
    if (file.size() > folder.size() + 1 && file.starts_with(folder) && file[folder.size()] == '/')
      prefix = std::max(prefix, folder.size() + 1);
  return {file.substr(prefix), static_cast<int>(presumed.getLine()), static_cast<int>(presumed.getColumn())};
}

bool Names::is_library(clang::SourceLocation location) const {
  if (location.isInvalid() || sources_.isInSystemHeader(sources_.getFileLoc(location))) return true;
  // Fields' values are Eigen's, whether or not its folder is one of the system's.
  const llvm::StringRef file = sources_.getFilename(sources_.getFileLoc(location));
  return file.ends_with(".physgen.h") ||
         std::ranges::any_of(libraries_, [&](const std::string& folder) { return file.starts_with(folder); });
}

const clang::DeclContext* Names::space(std::initializer_list<llvm::StringRef> path) const {
  const clang::DeclContext* scope = context_.getTranslationUnitDecl();
  for (const llvm::StringRef name : path) {
    const clang::DeclContext* inner = nullptr;
    for (const clang::NamedDecl* found : scope->lookup(&context_.Idents.get(name)))
      if (const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(found)) inner = space;
    if (inner == nullptr) return nullptr;
    scope = inner;
  }
  return scope;
}

std::vector<const clang::ClassTemplateSpecializationDecl*> Names::probes() const {
  std::vector<const clang::ClassTemplateSpecializationDecl*> result;
  const auto* physgen = space({"physgen"});
  if (physgen == nullptr) return result;
  for (clang::NamedDecl* found : physgen->lookup(&context_.Idents.get("Probe")))
    if (const auto* pattern = llvm::dyn_cast<clang::ClassTemplateDecl>(found))
      for (const auto* probe : pattern->specializations()) result.push_back(probe);
  return result;
}

std::pair<const CXXRecordDecl*, llvm::StringRef> Names::tag_of(const clang::ClassTemplateSpecializationDecl& probe) {
  const auto* tag = probe.getTemplateArgs()[0].getAsType()->getAsCXXRecordDecl();
  const auto* own = llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(tag);
  if (own == nullptr || !(is_physgen(own, "AtOwnIndex", {"probe"}) || is_physgen(own, "AtOwnOfPart", {"probe"})))
    return {tag, {}};
  return {own->getTemplateArgs()[0].getAsType()->getAsCXXRecordDecl(), own->getName()};
}

std::string Names::tag_name(const CXXRecordDecl& tag) {
  for (const clang::NamedDecl* found : tag.lookup(&context_.Idents.get("name")))
    if (const auto* text = first_text(initializer(llvm::dyn_cast<clang::VarDecl>(found))))
      return text->getString().str();
  return tag.getNameAsString();
}

ReachedField Names::field(const clang::ClassTemplateSpecializationDecl& probe) {
  const auto& arguments = probe.getTemplateArgs();
  const auto [tag, at] = tag_of(probe);
  const auto* object = arguments[1].getAsType()->getAsCXXRecordDecl();
  const auto number = static_cast<std::size_t>(arguments[2].getAsIntegral().getExtValue());
  const auto [fields, is_new] = fields_.try_emplace(object->getCanonicalDecl());
  if (is_new && object->hasDefinition())
    for (const clang::NamedDecl* found : object->getDefinition()->lookup(&context_.Idents.get("texts")))
      first_texts(initializer(llvm::dyn_cast<clang::VarDecl>(found)), fields->second);
  FieldUse use;
  use.own = at == "AtOwnIndex";
  use.array = tags_.at(tag->getCanonicalDecl());
  use.field = number < fields->second.size() ? fields->second[number] : std::to_string(number);
  return {use, at == "AtOwnOfPart"};
}

void Names::classes(const clang::TemplateArgument& argument, const Visit& visit,
                    std::set<const clang::Decl*>& seen) const {
  if (argument.getKind() == clang::TemplateArgument::Type) classes(argument.getAsType(), visit, seen);
  if (argument.getKind() == clang::TemplateArgument::Pack)
    for (const auto& element : argument.pack_elements()) classes(element, visit, seen);
}

/// Visits the classes that a type is made of, outermost first; not the parts of those for which visit() says false.
void Names::classes(clang::QualType type, const Visit& visit, std::set<const clang::Decl*>& seen) const {
  type = type.getNonReferenceType();
  while (type->isPointerType() || type->isArrayType())
    type = type->isPointerType() ? type->getPointeeType() : clang::QualType(type->getArrayElementTypeNoTypeQual(), 0);
  const auto* record = type->getAsCXXRecordDecl();
  if (record == nullptr || !seen.insert(record->getCanonicalDecl()).second || !visit(*record)) return;
  if (const auto* special = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(record))
    for (const auto& argument : special->getTemplateArgs().asArray()) classes(argument, visit, seen);
  if (!record->hasDefinition()) return;
  for (const auto* member : record->getDefinition()->fields()) classes(member->getType(), visit, seen);
}

std::vector<std::string> Names::arrays(clang::QualType type) {
  std::vector<std::string> result;
  std::set<const clang::Decl*> seen;
  classes(
      type,
      [&](const CXXRecordDecl& record) {
        const auto tag = tags_.find(record.getCanonicalDecl());
        if (tag == tags_.end()) return true;
        if (std::ranges::find(result, tag->second) == result.end()) result.push_back(tag->second);
        return false;
      },
      seen);
  return result;
}

std::string Names::kernel_name(const CXXRecordDecl& kernel) const {
  if (kernel.isLambda()) {
    const auto* function = llvm::dyn_cast<FunctionDecl>(kernel.getDeclContext());
    return function == nullptr ? "lambda" : "lambda in " + function->getQualifiedNameAsString();
  }
  std::string name = kernel.getQualifiedNameAsString();
  const auto* special = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(&kernel);
  if (special == nullptr || !is_library(kernel.getLocation())) return name;
  std::string inner;  // "physgen::Over<lambda in program>"
  std::set<const clang::Decl*> seen;
  for (const auto& argument : special->getTemplateArgs().asArray())
    classes(
        argument,
        [&](const CXXRecordDecl& part) {
          if (tags_.count(part.getCanonicalDecl()) != 0) return false;
          if (is_library(part.getLocation())) return true;
          inner += (inner.empty() ? "" : ", ") + kernel_name(part);
          return false;
        },
        seen);
  return inner.empty() ? name : name + '<' + inner + '>';
}

std::vector<const clang::FunctionDecl*> Names::steps() const {
  std::vector<const clang::FunctionDecl*> result;
  const auto* detail = space({"physgen", "probe", "detail"});
  if (detail == nullptr) return result;
  for (const llvm::StringRef name : {"step", "reduce_step", "perform_step", "root", "host_reads"})
    for (clang::NamedDecl* found : detail->lookup(&context_.Idents.get(name)))
      if (auto* pattern = llvm::dyn_cast<clang::FunctionTemplateDecl>(found))
        for (const auto* function : pattern->specializations())
          if (function->isDefined()) result.push_back(function);
  return result;
}

std::vector<const clang::FunctionDecl*> Names::variants() const {
  const auto* unit = space({"physgen_probe_unit"});
  if (unit == nullptr) return {};
  std::vector<const clang::FunctionDecl*> result;
  for (clang::NamedDecl* found : unit->lookup(&context_.Idents.get("instantiate")))
    if (auto* pattern = llvm::dyn_cast<clang::FunctionTemplateDecl>(found))
      for (const auto* function : pattern->specializations()) result.push_back(function);
  std::ranges::stable_sort(result, [](const FunctionDecl* a, const FunctionDecl* b) {
    const auto is_probed = [](const FunctionDecl* function) {
      const auto* as = function->getTemplateSpecializationArgs()->get(0).getAsType()->getAsCXXRecordDecl();
      return as != nullptr && as->getName() == "Probed";
    };
    return is_probed(a) && !is_probed(b);
  });
  return result;
}

Step Names::step(const clang::FunctionDecl& function) {
  Step step;
  const llvm::StringRef kind = function.getName();
  step.use.root = kind == "root" || kind == "host_reads";
  std::set<const clang::Decl*> seen;
  for (const auto& argument : function.getTemplateSpecializationArgs()->asArray()) {
    if (argument.getKind() != clang::TemplateArgument::Type) continue;
    if (const auto* record = argument.getAsType()->getAsCXXRecordDecl(); record != nullptr && step.use.kernel.empty())
      step.use.kernel = kind == "host_reads" ? "value()" : kernel_name(*record);
    for (const std::string& array : arrays(argument.getAsType()))
      if (std::ranges::find(step.use.arrays, array) == step.use.arrays.end()) step.use.arrays.push_back(array);
    classes(
        argument.getAsType(),
        [&](const CXXRecordDecl& part) {
          if (tags_.count(part.getCanonicalDecl()) != 0) return false;
          if (is_library(part.getLocation())) return true;
          const Place defined = place(part.getLocation());
          if (step.use.place == Place{}) step.use.place = defined;
          step.own_files.insert(defined.file);
          return false;
        },
        seen);
  }
  return step;
}

bool Names::is_object_reference(const CXXRecordDecl& record) {
  const llvm::StringRef name = record.getIdentifier() == nullptr ? llvm::StringRef() : record.getName();
  if (!name.ends_with("Ref") || !llvm::isa<clang::ClassTemplateSpecializationDecl>(record)) return false;
  const auto* scope = record.getDeclContext();
  const std::string object = name.drop_back(3).str() + "Object";
  return !scope->lookup(&record.getASTContext().Idents.get(object)).empty();
}

bool Names::is_physgen(const clang::NamedDecl* declaration, llvm::StringRef name,
                       std::initializer_list<llvm::StringRef> inner) {
  if (declaration == nullptr || declaration->getIdentifier() == nullptr || declaration->getName() != name) return false;
  const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(declaration->getDeclContext());
  for (const llvm::StringRef outer : inner) {
    if (space == nullptr || space->getName() != outer) return false;
    space = llvm::dyn_cast<clang::NamespaceDecl>(space->getDeclContext());
  }
  return space != nullptr && space->getName() == "physgen" && space->getParent()->isTranslationUnit();
}

}  // namespace physgen::usage
