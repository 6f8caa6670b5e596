// See read_options.h.
#include "scenes/read_options.h"

#include <clang/AST/Attr.h>
#include <clang/AST/DeclTemplate.h>
#include <clang/AST/Expr.h>
#include <clang/Basic/SourceManager.h>

#include <algorithm>
#include <optional>
#include <set>

#include "frontend/constants.h"
#include "model/facts.h"

namespace physgen::scenes {
namespace {

using frontend::Constant;
using frontend::in_quotes;

constexpr const char* array_options =
    "per(...), input(...), output(...), uniform(), names(...), no_index(...) and follows(...)";

/// "physgen::scene::detail::Per" gives "Per"; empty: it is not an option.
std::string option_name(clang::QualType type) {
  const auto* record = type->getAsCXXRecordDecl();
  if (record == nullptr) return {};
  const std::string name = record->getQualifiedNameAsString(), scope = "physgen::scene::detail::";
  return name.starts_with(scope) ? name.substr(scope.size()) : std::string();
}

/// Bytes of a stored element whose type has this name in the runtime: an encoding's word, or that of a type of
/// integers.
std::optional<int> bytes_of(const std::string& type) {
  if (type == "none") return 0;
  if (const auto* encoding = model::find_word(model::encodings(), type); encoding != nullptr && encoding->bytes > 0)
    return encoding->bytes;
  if (const auto* element = model::find_word(model::elements(), type); element != nullptr && element->integer)
    return element->bytes_with_float;
  return std::nullopt;
}

/// The text of a std::string_view: its one member that is a pointer, to at least as many letters as the other says.
std::optional<std::string> text_of(const Constant& view) {
  std::optional<std::string> text;
  std::size_t size = 0;
  for (const auto* field : view.type->getAsCXXRecordDecl()->fields()) {
    const clang::APValue& member = view.value.getStructField(field->getFieldIndex());
    if (member.isLValue()) text = frontend::literal(member);
    if (member.isInt()) size = member.getInt().getZExtValue();
  }
  if (text) text->resize(std::min(text->size(), size));
  return text;
}

/// "points[2].x" gives "points.x": the entries of a fixed array are stored alike.
std::string without_entries(const std::string& name) {
  std::string result;
  bool inside = false;
  for (const char c : name) {
    inside = (inside || c == '[') && c != ']';
    if (!inside && c != ']') result += c;
  }
  return result;
}

std::optional<Field> field_of(const Constant& info) {
  Field field;
  const auto name = text_of(info.member("name"));
  const Constant type = info.member("type");
  const auto type_name = type.enumerator();
  if (!name || !type_name) return std::nullopt;
  field.name = without_entries(*name);
  field.type = *type_name;
  field.elements = static_cast<int>(info.member("count").value.getInt().getExtValue());
  const auto bytes = bytes_of(field.type);
  if (!bytes) return std::nullopt;
  field.bytes = field.elements * *bytes;
  field.initial = !info.member("initial").value.getFloat().isZero();
  return field;
}

void add(std::vector<Field>& fields, Field field) {
  for (Field& known : fields)
    if (known.name == field.name) {
      known.elements += field.elements;
      known.bytes += field.bytes;
      return;
    }
  fields.push_back(std::move(field));
}

Selection selection_of(const Constant& names, Location where) {
  Selection selection;
  selection.location = std::move(where);
  const auto count = static_cast<unsigned>(names.member("count").value.getInt().getZExtValue());
  selection.all = count == 0;
  for (unsigned i = 0; i < count; ++i)
    selection.names.push_back(frontend::literal(names.member("names").element(i).value).value_or(""));
  return selection;
}

class OptionReader {
 public:
  OptionReader(const clang::FieldDecl& declaration, Array& array, frontend::Report& report)
      : declaration_(declaration), array_(array), report_(report) {}

  void read() {
    for (const auto* attribute : declaration_.specific_attrs<clang::AnnotateAttr>())
      if (attribute->getAnnotation() == array_annotation)
        for (const clang::Expr* argument : attribute->args())
          if (!argument->containsErrors()) option(*argument->IgnoreImplicit());
    if (!seen_.contains("Per"))
      error(declaration_.getLocation(),
            "does not say how many objects it has; write PHYSGEN_ARRAY(per(\"tet\"), ...), or per(1) for one object");
    if (array_.uniform && array_.output)
      error(declaration_.getLocation(), "is uniform(), which programs only read, and an output; remove one of them");
  }

 private:
  void error(clang::SourceRange range, const std::string& message) {
    report_.error(range, "array " + in_quotes(array_.name) + " " + message);
  }

  void option(const clang::Expr& argument) {
    const clang::SourceRange range = argument.getSourceRange();
    const std::string name = option_name(argument.getType());
    clang::Expr::EvalResult result;
    if (name.empty() || !argument.EvaluateAsConstantExpr(result, report_.context()) || !result.Val.isStruct())
      return report_.error(range, std::string("this is not an option; PHYSGEN_ARRAY takes ") + array_options);
    if (name != "NamesObjects" && !seen_.insert(name).second)
      return error(range, "has this option twice; remove one of them");
    const Constant value{result.Val, argument.getType()};
    const Location where = location(report_.context(), range.getBegin());
    if (name == "Per") {
      per(value, range);
    } else if (name == "Uniform") {
      array_.uniform = true;
    } else if (name == "NamesObjects") {
      names(value, where, range);
    } else if (name == "Follows") {
      array_.follows = frontend::literal(value.member("set").value).value_or("");
    } else if (name == "Shift") {
      error(range, "has shifted(...) beside its options; write it in names(\"code\", \"tet\", shifted(2))");
    } else {
      (name == "Input" ? array_.input : array_.output) = selection_of(value.member("fields"), where);
      known_fields(name == "Input" ? *array_.input : *array_.output, range);
    }
  }

  void per(const Constant& value, clang::SourceRange range) {
    array_.count = static_cast<int>(value.member("count").value.getInt().getExtValue());
    array_.set = frontend::literal(value.member("set").value).value_or("");
    const bool is_name = !array_.set.empty() && std::isdigit(static_cast<unsigned char>(array_.set.front())) == 0 &&
                         std::all_of(array_.set.begin(), array_.set.end(),
                                     [](unsigned char c) { return c < 0x80 && (std::isalnum(c) != 0 || c == '_'); });
    if (!is_name && array_.count < 1)
      error(range,
            "has a per(...) that is neither a name nor a number of objects; write per(\"tet\"), with letters, digits "
            "and '_', "
            "or per(1)");
  }

  void names(const Constant& value, const Location& where, clang::SourceRange range) {
    NamedObjects named;
    named.field = frontend::literal(value.member("field").value).value_or("");
    named.set = frontend::literal(value.member("set").value).value_or("");
    named.shift = static_cast<int>(value.member("shift").member("bits").value.getInt().getExtValue());
    named.location = where;
    known_fields({false, {named.field}, where}, range);
    for (const Field& field : array_.fields)
      if (field.name == named.field && field.type != "int32" && !named.set.empty())
        error(range, "names objects by its field " + in_quotes(named.field) + ", which is no index but " + field.type +
                         "; name a field of type Index");
    if (named.shift < 0 || named.shift > 30)
      error(range, "has shifted(" + std::to_string(named.shift) + "); an index has 31 bits, so shift by 0 to 30");
    for (const NamedObjects& known : array_.names)
      if (known.field == named.field && (known.set == named.set || known.set.empty() || named.set.empty()))
        error(range, known.set == named.set ? "has this option twice; remove one of them"
                                            : "has names(...) and no_index(...) of one field; remove one of them");
    array_.names.push_back(std::move(named));
  }

  void known_fields(const Selection& selection, clang::SourceRange range) {
    std::vector<std::string> names;
    for (const Field& field : array_.fields) names.push_back(field.name);
    for (const std::string& name : selection.names)
      if (std::find(names.begin(), names.end(), name) == names.end())
        error(range, "holds " + array_.object + "; " + unknown("field", name, names));
  }

  const clang::FieldDecl& declaration_;
  Array& array_;
  frontend::Report& report_;
  std::set<std::string> seen_;
};

}  // namespace

Location location(const clang::ASTContext& context, clang::SourceLocation where) {
  const auto& sources = context.getSourceManager();
  const auto place = sources.getPresumedLoc(sources.getFileLoc(where));
  return {place.getFilename(), static_cast<int>(place.getLine()), static_cast<int>(place.getColumn())};
}

bool is_array(clang::QualType type) {
  const auto* record = llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(type->getAsCXXRecordDecl());
  if (record == nullptr || record->getQualifiedNameAsString() != "physgen::Array") return false;
  const auto* space = record->getTemplateArgs()[2].getAsType()->getAsCXXRecordDecl();
  return space != nullptr && space->getQualifiedNameAsString() == "physgen::detail::Declared";
}

/// Whether the second argument of Array<Object, Real> is an alias of that name.
static bool has_own_real(clang::QualType type) {
  const auto* spelt = type->getAs<clang::TemplateSpecializationType>();
  if (spelt == nullptr || spelt->template_arguments().size() != 2) return false;
  const auto* alias = spelt->template_arguments()[1].getAsType()->getAs<clang::TypedefType>();
  return alias != nullptr && alias->getDecl()->getName() == "Real";
}

bool read_type(const clang::FieldDecl& declaration, Array& array, frontend::Report& report) {
  const auto wrong = [&](const std::string& message) {
    report.error(declaration.getTypeSpecStartLoc(), "array " + in_quotes(array.name) + " " + message);
    return false;
  };
  if (declaration.isInvalidDecl()) return false;  // Clang has reported it
  if (!is_array(declaration.getType()))
    return wrong("is not an array of objects; write 'Array<elasticity::TetObject, Real> " + array.name + ";'");
  const auto* type = llvm::cast<clang::ClassTemplateSpecializationDecl>(declaration.getType()->getAsCXXRecordDecl());
  if (type->isInvalidDecl()) return false;
  const auto* object = type->getTemplateArgs()[0].getAsType()->getAsCXXRecordDecl();
  const std::string name = object == nullptr ? "" : object->getQualifiedNameAsString(), ending = "Object";
  if (!name.ends_with(ending) || name == ending)
    return wrong(
        "holds no generated object; write 'Array<elasticity::TetObject, Real>' for objects "
        "elasticity::Tet");
  array.object = name.substr(0, name.size() - ending.size());
  const clang::QualType real = type->getTemplateArgs()[1].getAsType().getCanonicalType();
  array.real = real.getUnqualifiedType().getAsString();
  array.own_real = has_own_real(declaration.getType());
  const auto& sources = declaration.getASTContext().getSourceManager();
  array.header = sources.getFilename(sources.getFileLoc(object->getLocation())).str();
  if (array.real != "float" && array.real != "double")
    return wrong("has the precision " + in_quotes(array.real) + "; it is float or double");
  for (const clang::Decl* member : type->decls()) {
    const auto* fields = llvm::dyn_cast<clang::VarDecl>(member);
    if (fields == nullptr || fields->getName() != "fields") continue;
    const clang::APValue* value = fields->evaluateValue();
    if (value == nullptr) break;
    const auto* array_type = fields->getType()->getAsCXXRecordDecl();  // std::array: its one member
    const Constant rows{value->getStructField(0), array_type->field_begin()->getType()};
    for (unsigned i = 0; i < rows.value.getArraySize(); ++i) {
      auto field = field_of(rows.element(i));
      if (!field)
        return wrong("holds " + array.object +
                     ", with a field in a format that this physgen does not know; generate "
                     "its header with the physgen that reads the scene");
      add(array.fields, std::move(*field));
    }
  }
  if (array.fields.empty()) return wrong("holds objects whose fields could not be read");
  return true;
}

void read_options(const clang::FieldDecl& declaration, Array& array, frontend::Report& report) {
  OptionReader(declaration, array, report).read();
}

}  // namespace physgen::scenes
