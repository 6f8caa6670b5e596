// See objects.h. The walk goes through namespaces; within a struct every declaration that is not a plain public field
// is an error. Rules about values come last, from model::validate, and get the carets remembered here.
#include "frontend/objects.h"

#include <clang/AST/Attr.h>
#include <clang/AST/DeclFriend.h>
#include <clang/AST/DeclTemplate.h>
#include <clang/AST/RawCommentList.h>
#include <clang/Basic/SourceManager.h>

#include "frontend/options.h"
#include "frontend/types.h"
#include "model/validate.h"

namespace physgen::frontend {
namespace {

using model::Aspect;

/// Where the parts of a field or an object stand.
struct Places {
  clang::SourceRange name;
  clang::SourceRange type;  // of a field
  OptionPlaces options;
  bool has_errors = false;  // an object whose fields could not all be read
  std::vector<Places> fields;

  [[nodiscard]] clang::SourceRange of(Aspect aspect) const {
    if (aspect == Aspect::type) return type;
    const auto option = options.find(aspect);
    return option == options.end() ? name : option->second;
  }
};

class SchemaReader {
 public:
  SchemaReader(clang::ASTContext& context, bool clang_errors)
      : context_(context), sources_(context.getSourceManager()), report_(context, clang_errors) {}

  model::Schema read(bool has_vocabulary) {
    schema_.file = file_name(sources_.getLocForStartOfFile(sources_.getMainFileID()));
    declarations(*context_.getTranslationUnitDecl());
    rules(has_vocabulary);
    report_.flush();
    return std::move(schema_);
  }

 private:
  // ---- The walk ---------------------------------------------------------------------------------------------------

  void declarations(const clang::DeclContext& scope) {
    for (const clang::Decl* declaration : scope.decls()) {
      if (declaration->isImplicit() || in_vocabulary(*declaration)) continue;
      if (const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(declaration)) {
        declarations(*space);
      } else if (llvm::isa<clang::LinkageSpecDecl>(declaration)) {
        declarations(*llvm::cast<clang::LinkageSpecDecl>(declaration));
      } else if (const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(declaration)) {
        if (record->isThisDeclarationADefinition()) this->record(*record);
      } else if (const auto* pattern = llvm::dyn_cast<clang::ClassTemplateDecl>(declaration)) {
        if (const auto range = marker(*pattern->getTemplatedDecl(), object_annotation))
          report_.error(pattern->getLocation(), "object " + quoted(pattern->getName()) +
                                                    " is a template, and the generator needs its sizes; write a struct "
                                                    "for each set of arguments");
      } else {
        misplaced_markers(*declaration);
      }
    }
  }

  [[nodiscard]] bool in_vocabulary(const clang::Decl& declaration) const {
    return sources_.isInSystemHeader(sources_.getExpansionLoc(declaration.getLocation()));  // the only one there is
  }

  void misplaced_markers(const clang::Decl& declaration) {
    if (const auto range = marker(declaration, object_annotation))
      report_.error(*range, "PHYSGEN_OBJECT belongs between 'struct' and the name of a struct; remove it here");
    if (const auto range = marker(declaration, field_annotation))
      report_.error(*range, "PHYSGEN belongs before the type of a field of an object; remove it here");
  }

  void record(const clang::CXXRecordDecl& record) {
    if (const auto range = marker(record, field_annotation))
      report_.error(*range, "PHYSGEN is for fields; write PHYSGEN_OBJECT(...) for the options of a struct");
    if (!is_object(record)) return not_an_object(record);
    if (record.getName().empty()) {
      if (report_.clang_errors()) return;  // Clang takes the name from a second definition
      return report_.error(record.getLocation(),
                           "an object needs a name, which the generated classes get; write "
                           "'struct PHYSGEN_OBJECT() Name'");
    }
    const std::string what = "object " + quoted(record.getName());
    if (record.isUnion())
      return report_.error(record.getLocation(),
                           what + " is a union, whose members share memory; write a struct with one field per member");
    if (llvm::isa<clang::ClassTemplateSpecializationDecl>(record))
      return report_.error(record.getLocation(), what + " is a specialization of a template; write a struct");
    if (record.isInAnonymousNamespace())
      report_.error(
          record.getLocation(),
          what + " is in an anonymous namespace, where generated code cannot name it; give the namespace a name");
    object(record);
  }

  void not_an_object(const clang::CXXRecordDecl& record) {
    for (const clang::Decl* member : record.decls())
      if (const auto range = marker(*member, field_annotation))
        report_.error(*range, "PHYSGEN stands in " + quoted(record.getName()) +
                                  ", which is no object; write 'struct PHYSGEN_OBJECT() " + record.getName().str() +
                                  "'");
  }

  // ---- One object -------------------------------------------------------------------------------------------------

  void object(const clang::CXXRecordDecl& record) {
    model::Object object;
    object.name = record.getName().str();
    object.scope = scope_of(record);
    object.doc = comment(record);
    object.location = location(record.getLocation());
    Places places;
    places.name = record.getLocation();
    for (const auto* redeclaration : record.redecls())
      if (marker(*redeclaration, object_annotation)) {
        places.options = read_options(*redeclaration, object, report_);
        break;
      }
    places.has_errors = record.isInvalidDecl() || !supported(record);
    for (const clang::Decl* member : record.decls()) {
      const auto* field = llvm::dyn_cast<clang::FieldDecl>(member);
      if (!(field != nullptr ? this->field(record, *field, object, places) : harmless(record, *member)))
        places.has_errors = true;
    }
    share_comments(record, object);
    const bool imported = !sources_.isInMainFile(sources_.getExpansionLoc(record.getLocation()));
    if (imported) object.header = model::generated_header(object.location.file);
    (imported ? schema_.imported : schema_.objects).push_back(std::move(object));
    (imported ? imported_ : own_).push_back(std::move(places));
  }

  bool supported(const clang::CXXRecordDecl& record) {
    const std::string what = "object " + quoted(record.getName());
    for (const auto& base : record.bases())
      report_.error(base.getSourceRange(), what + " has a base class; write a field of the base's type instead");
    const auto* aligned = record.getAttr<clang::AlignedAttr>();
    if (aligned != nullptr)
      report_.error(aligned->getRange(),
                    "alignas says nothing about generated records; write PHYSGEN_OBJECT(align(...))");
    const auto* packed = record.getAttr<clang::PackedAttr>();
    if (packed != nullptr)
      report_.error(packed->getRange(), "generated records have no gaps to pack; remove the attribute");
    return record.getNumBases() == 0 && aligned == nullptr && packed == nullptr;
  }

  /// @return whether a member that is no field may stand in an object
  bool harmless(const clang::CXXRecordDecl& record, const clang::Decl& member) {
    if (member.isImplicit() || llvm::isa<clang::AccessSpecDecl, clang::StaticAssertDecl, clang::EmptyDecl>(member))
      return true;
    if (llvm::isa<clang::IndirectFieldDecl>(member)) return false;  // its anonymous struct is reported
    const std::string within = " in object " + quoted(record.getName());
    const auto error = [&](const std::string& what) {
      report_.error(member.getLocation(), what);
      return false;
    };
    if (const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(&member); method != nullptr && method->isVirtual())
      return error("virtual function" + within + "; an object is a record of numbers, remove it");
    if (llvm::isa<clang::FunctionDecl, clang::FunctionTemplateDecl>(member))
      return error("member function" + within +
                   "; an object is a record of numbers, write a function beside it that "
                   "takes the generated value");
    if (llvm::isa<clang::VarDecl>(member))
      return error("static member" + within + "; write a constexpr constant beside the object");
    if (const auto* nested = llvm::dyn_cast<clang::CXXRecordDecl>(&member))
      return error((nested->getName().empty() ? "anonymous " + nested->getKindName().str()
                                              : nested->getKindName().str() + " " + quoted(nested->getName())) +
                   " is defined" + within + "; write it as an object of its own before this one and nest it by name");
    return error("declaration" + within + " that is not a field; write it beside the object");
  }

  // ---- One field --------------------------------------------------------------------------------------------------

  bool field(const clang::CXXRecordDecl& record, const clang::FieldDecl& declaration, model::Object& object,
             Places& places) {
    if (declaration.isInvalidDecl()) return recursive(record, declaration), false;
    if (const auto* type = declaration.getType()->getBaseElementTypeUnsafe()->getAsCXXRecordDecl();
        type != nullptr && type->getDeclContext() == &record)
      return false;  // the nested definition is reported
    if (const auto range = marker(declaration, object_annotation))
      report_.error(*range, "PHYSGEN_OBJECT is for structs; write PHYSGEN(...) for the options of a field");
    if (declaration.getName().empty()) {
      report_.error(declaration.getLocation(), "field without a name; write one, or remove it");
      return false;
    }
    const std::string what = "field " + quoted(declaration.getName());
    bool good = true;
    if (declaration.getAccess() != clang::AS_public) {
      report_.error(declaration.getLocation(),
                    what + " is " + (declaration.getAccess() == clang::AS_private ? "private" : "protected") +
                        ", but generated code must reach it; write 'struct' and no '" +
                        (declaration.getAccess() == clang::AS_private ? "private:'" : "protected:'"));
      good = false;
    }
    if (const auto* initializer = declaration.getInClassInitializer()) {
      report_.error(initializer->getSourceRange(),
                    what + " has a C++ initializer; write PHYSGEN(initial(...)) before its type");
      good = false;
    }
    if (const auto* aligned = declaration.getAttr<clang::AlignedAttr>()) {
      report_.error(aligned->getRange(),
                    what +
                        " has an alignment, which is the layout's choice; remove alignas, or write "
                        "PHYSGEN_OBJECT(align(...)) for the whole record");
      good = false;
    }
    model::Field field;
    field.name = declaration.getName().str();
    field.doc = comment(declaration);
    field.location = location(declaration.getLocation());
    Places field_places;
    field_places.name = declaration.getLocation();
    field_places.type = declaration.getTypeSourceInfo()->getTypeLoc().getSourceRange();
    field_places.options = read_options(declaration, field, report_);
    if (!read_type(declaration, field, report_)) return false;
    object.fields.push_back(std::move(field));
    places.fields.push_back(std::move(field_places));
    return good;
  }

  /// Clang has said that the type is incomplete, but not what to do.
  void recursive(const clang::CXXRecordDecl& record, const clang::FieldDecl& declaration) {
    const auto* type = declaration.getType()->getBaseElementTypeUnsafe()->getAsCXXRecordDecl();
    if (type == nullptr || type->getCanonicalDecl() != record.getCanonicalDecl()) return;
    report_.error(declaration.getLocation(), "object " + quoted(record.getName()) + " contains itself in field " +
                                                 quoted(declaration.getName()) +
                                                 "; store an Index of the other object instead");
  }

  std::string comment(const clang::Decl& declaration) const {
    const auto* raw = context_.getRawCommentForAnyRedecl(&declaration);
    if (raw == nullptr || !raw->isDocumentation()) return {};
    const std::string text = raw->getFormattedText(sources_, context_.getDiagnostics());
    return llvm::StringRef(text).trim().str();
  }

  /// Fields of one declaration share its comment, which Clang attaches to those on the comment's line.
  void share_comments(const clang::CXXRecordDecl& record, model::Object& object) const {
    std::map<unsigned, std::string> shared;  // by the beginning of the declaration
    std::map<std::string, unsigned, std::less<>> begin;
    for (const auto* declaration : record.fields())
      begin.emplace(declaration->getName().str(), declaration->getBeginLoc().getRawEncoding());
    for (const auto& field : object.fields)
      if (!field.doc.empty()) shared[begin[field.name]] = field.doc;
    for (auto& field : object.fields)
      if (field.doc.empty()) field.doc = shared[begin[field.name]];
  }

  // ---- Rules that need the whole schema -----------------------------------------------------------------------------

  void rules(bool has_vocabulary) {
    for (const auto& issue : model::validate(schema_)) {
      if (issue.place.object < 0) {
        if (!report_.has_errors() && !report_.clang_errors()) empty_schema(has_vocabulary);
        continue;
      }
      const Places& object = places(issue.place);
      if (issue.aspect == Aspect::fields && object.has_errors) continue;
      const Places& place = issue.place.field < 0 ? object : object.fields[static_cast<std::size_t>(issue.place.field)];
      std::optional<Note> note;
      if (issue.other.object >= 0) note = Note{places(issue.other).name, "the other one is here"};
      report_.error(place.of(issue.aspect), issue.message, note);
    }
  }

  void empty_schema(bool has_vocabulary) {
    report_.error(sources_.getLocForStartOfFile(sources_.getMainFileID()),
                  std::string("this schema declares no object; write ") +
                      (has_vocabulary ? "" : "'#include <physgen/schema.h>' and ") +
                      "'struct PHYSGEN_OBJECT() Name { ... };' with the fields of one object");
  }

  const Places& places(const model::Place& place) const {
    return (place.imported ? imported_ : own_)[static_cast<std::size_t>(place.object)];
  }

  // ---- Locations --------------------------------------------------------------------------------------------------

  std::string file_name(clang::SourceLocation where) const {
    const llvm::StringRef path = sources_.getFilename(sources_.getExpansionLoc(where));
    return path.substr(path.rfind('/') + 1).str();
  }

  model::Location location(clang::SourceLocation where) const {
    const auto presumed = sources_.getPresumedLoc(sources_.getExpansionLoc(where));
    return {file_name(where), static_cast<int>(presumed.getLine()), static_cast<int>(presumed.getColumn())};
  }

  clang::ASTContext& context_;
  const clang::SourceManager& sources_;
  Report report_;
  model::Schema schema_;
  std::vector<Places> own_, imported_;  // beside schema_.objects, schema_.imported
};

}  // namespace

model::Schema read_schema(clang::ASTContext& context, bool clang_errors, bool has_vocabulary) {
  return SchemaReader(context, clang_errors).read(has_vocabulary);
}

}  // namespace physgen::frontend
