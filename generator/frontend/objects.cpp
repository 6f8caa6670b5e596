// See objects.h. The walk goes through everything that can hold a marker; objects stand at namespace scope, and within
// one every declaration that is not a plain public field is an error. Rules about values come last, from
// model::validate and from the emitter, and get the carets remembered here.
#include "frontend/objects.h"

#include <clang/AST/DeclFriend.h>
#include <clang/AST/DeclTemplate.h>
#include <clang/AST/RawCommentList.h>
#include <clang/Basic/SourceManager.h>

#include <map>
#include <set>

#include "frontend/constructs.h"
#include "frontend/options.h"
#include "frontend/types.h"

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

  model::Schema read(bool has_vocabulary, model::Rules objections) {
    schema_.file = file_name(sources_.getLocForStartOfFile(sources_.getMainFileID()));
    declarations(*context_.getTranslationUnitDecl());
    rules(model::validate(schema_), has_vocabulary);
    if (objections != nullptr) rules(objections(schema_), has_vocabulary);
    report_.flush();
    return std::move(schema_);
  }

 private:
  // ---- The walk ---------------------------------------------------------------------------------------------------

  void declarations(const clang::DeclContext& scope) {
    for (const clang::Decl* declaration : scope.decls())
      if (declaration->getLocation().isValid() && !in_vocabulary(*declaration)) this->declaration(*declaration);
  }

  void declaration(const clang::Decl& declaration) {
    if (const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(&declaration)) return this->record(*record);
    misplaced_markers(declaration);
    if (const auto* pattern = llvm::dyn_cast<clang::TemplateDecl>(&declaration)) {
      if (pattern->getTemplatedDecl() != nullptr) this->declaration(*pattern->getTemplatedDecl());
    } else if (const auto* friendly = llvm::dyn_cast<clang::FriendDecl>(&declaration)) {
      if (friendly->getFriendDecl() != nullptr) this->declaration(*friendly->getFriendDecl());
    } else if (const auto* scope = llvm::dyn_cast<clang::DeclContext>(&declaration)) {
      declarations(*scope);
    }
  }

  [[nodiscard]] bool in_vocabulary(const clang::Decl& declaration) const {
    return sources_.isInSystemHeader(sources_.getExpansionLoc(declaration.getLocation()));  // the only one there is
  }

  void misplaced_markers(const clang::Decl& declaration) {
    if (const auto range = marker(declaration, object_annotation))
      report_.error(*range, "PHYSGEN_OBJECT belongs between 'struct' and the name of a struct; remove it here");
    const auto range = marker(declaration, field_annotation);
    if (!range) return;
    if (const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(declaration.getDeclContext()))
      report_.error(*range, "PHYSGEN stands in " + in_quotes(record->getName()) +
                                ", which is not an object; write 'struct PHYSGEN_OBJECT() " + record->getName().str() +
                                "'");
    else
      report_.error(*range, "PHYSGEN belongs before the type of a field of an object; remove it here");
  }

  void record(const clang::CXXRecordDecl& record) {
    if (clang::isTemplateInstantiation(record.getTemplateSpecializationKind())) return;  // of what is walked itself
    const auto object_marker = marker(record, object_annotation);
    const auto refuse = [&](const std::string& what) {
      report_.error(record.getLocation(), "object " + in_quotes(record.getName()) + what);
    };
    if (object_marker && record.getDescribedClassTemplate() != nullptr)
      return refuse(" is a template, and the generator needs its sizes; write a struct for each set of arguments");
    if (!record.isThisDeclarationADefinition()) return;
    if (const auto range = marker(record, field_annotation))
      report_.error(*range, "PHYSGEN is for fields; write PHYSGEN_OBJECT(...) for the options of a struct");
    if (!is_object(record)) return declarations(record);
    if (record.getName().empty()) {
      if (report_.clang_errors()) return;  // Clang takes the name from a second definition
      return report_.error(record.getLocation(),
                           "an object needs a name, which the generated classes get; write "
                           "'struct PHYSGEN_OBJECT() Name'");
    }
    if (!record.getDeclContext()->getRedeclContext()->isFileContext())
      return refuse(" is not at namespace scope, where object types stand; move it there");
    if (record.isUnion())
      return refuse(" is a union, whose members share memory; write a struct with one field per member");
    if (llvm::isa<clang::ClassTemplateSpecializationDecl>(record))
      return refuse(" is a specialization of a template; write a struct");
    if (record.isInAnonymousNamespace())
      refuse(" is in an anonymous namespace, where generated code cannot name it; give the namespace a name");
    object(record);
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
    places.options = options(record, object);
    places.has_errors = record.isInvalidDecl() || !is_plain_record(record, report_);
    for (const clang::Decl* member : record.decls()) {
      const auto* field = llvm::dyn_cast<clang::FieldDecl>(member);
      if (!(field != nullptr ? this->field(record, *field, object, places) : is_harmless(record, *member, report_)))
        places.has_errors = true;
    }
    share_comments(record, object);
    const bool imported = !sources_.isInMainFile(sources_.getExpansionLoc(record.getLocation()));
    if (imported) object.schema = object.location.file;
    names_another_file(record);
    (imported ? schema_.imported : schema_.objects).push_back(std::move(object));
    (imported ? imported_ : own_).push_back(std::move(places));
  }

  /// Reports an object whose schema has the file name of another one with objects: what is generated of the two would
  /// have one name, too.
  void names_another_file(const clang::CXXRecordDecl& record) {
    const auto where = sources_.getExpansionLoc(record.getLocation());
    const std::string file = file_name(where);
    const auto [first, is_new] = schemas_.emplace(file.substr(0, file.rfind('.')), where);
    const auto entry = [&](clang::SourceLocation place) {
      return sources_.getFileEntryForID(sources_.getFileID(place));
    };
    if (is_new || entry(first->second) == entry(where)) return;
    const std::string path = sources_.getFilename(where).str(), other = sources_.getFilename(first->second).str();
    if (!clashing_.insert(path).second) return;  // said of its first object
    report_.error(record.getLocation(),
                  "object " + in_quotes(record.getName()) + " is declared in " + in_quotes(path) + " and others in " +
                      in_quotes(other) +
                      ", and the headers that are generated of the two have one name; rename one file",
                  Note{first->second, "an object of the other file is here"});
  }

  /// The options of the one declaration that carries them.
  OptionPlaces options(const clang::CXXRecordDecl& record, model::Object& object) {
    OptionPlaces places;
    std::optional<clang::SourceRange> first;
    for (const auto* redeclaration : record.redecls()) {
      const auto range = marker(*redeclaration, object_annotation);
      if (range && first)
        report_.error(*range, "PHYSGEN_OBJECT is given twice for " + in_quotes(record.getName()) + "; keep one of them",
                      Note{*first, "the other one is here"});
      else if (range)
        places = read_options(*redeclaration, object, report_);
      if (!first) first = range;
    }
    return places;
  }

  // ---- One field --------------------------------------------------------------------------------------------------

  bool field(const clang::CXXRecordDecl& record, const clang::FieldDecl& declaration, model::Object& object,
             Places& places) {
    if (declaration.isInvalidDecl()) return report_recursion(record, declaration, report_), false;
    if (const auto* type = declaration.getType()->getBaseElementTypeUnsafe()->getAsCXXRecordDecl();
        type != nullptr && type->getDeclContext() == &record)
      return false;  // the nested definition is reported
    if (const auto range = marker(declaration, object_annotation))
      report_.error(*range, "PHYSGEN_OBJECT is for structs; write PHYSGEN(...) for the options of a field");
    if (declaration.getName().empty()) {
      report_.error(declaration.getLocation(), "field without a name; write one, or remove it");
      return false;
    }
    const bool good = is_plain_field(declaration, report_);
    model::Field field;
    field.name = declaration.getName().str();
    // Clang looks for it through all the text behind the last comment, each time. Objects of more fields are refused.
    if (object.fields.size() < 5000) field.doc = comment(declaration);
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

  void rules(const std::vector<model::Issue>& broken, bool has_vocabulary) {
    for (const auto& issue : broken) {
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
  std::vector<Places> own_, imported_;                    // beside schema_.objects, schema_.imported
  std::map<std::string, clang::SourceLocation> schemas_;  // first objects of files, by their names without ending
  std::set<std::string> clashing_;                        // files that have the name of another one
};

}  // namespace

model::Schema read_schema(clang::ASTContext& context, bool clang_errors, bool has_vocabulary, model::Rules objections) {
  return SchemaReader(context, clang_errors).read(has_vocabulary, objections);
}

}  // namespace physgen::frontend
