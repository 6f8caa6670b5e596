// See options.h.
#include "frontend/options.h"

#include <clang/AST/APValue.h>
#include <clang/AST/Attr.h>
#include <clang/AST/DeclCXX.h>
#include <clang/AST/Expr.h>

#include <functional>

#include "frontend/changed_numbers.h"
#include "frontend/constants.h"

namespace physgen::frontend {
namespace {

using model::Aspect;

constexpr const char* object_options = "layout(...) and align(...)";
constexpr const char* field_options = "unit(...), range(...), initial(...) and format(...)";

/// One argument of a macro: which option it is, and its evaluated members.
struct Option {
  const clang::Expr* expression;
  llvm::StringRef type;  // Unit, Layout, ...; empty: not an option
  clang::APValue value;

  [[nodiscard]] int integer(unsigned member) const {
    return static_cast<int>(value.getStructField(member).getInt().getExtValue());
  }
  [[nodiscard]] Constant member(unsigned number) const { return Constant{value, expression->getType()}.member(number); }
  [[nodiscard]] double real(unsigned member) const { return value.getStructField(member).getFloat().convertToDouble(); }
  [[nodiscard]] clang::SourceRange range() const { return expression->getSourceRange(); }
};

Option evaluated(const clang::Expr* argument, const clang::ASTContext& context) {
  Option option{argument->IgnoreImplicit(), {}, {}};
  const llvm::StringRef type = option_name(argument->getType()->getAsCXXRecordDecl());
  clang::Expr::EvalResult result;
  if (type.empty() || argument->isValueDependent() || !argument->EvaluateAsConstantExpr(result, context) ||
      !result.Val.isStruct())
    return option;
  option.type = type;
  option.value = result.Val;
  return option;
}

/// Calls `read` for every argument of the macro on the declaration.
void for_each_option(const clang::Decl& declaration, llvm::StringRef annotation, Report& report,
                     const std::function<void(const Option&)>& read) {
  for (const auto* attribute : declaration.specific_attrs<clang::AnnotateAttr>())
    if (attribute->getAnnotation() == annotation)
      for (const clang::Expr* argument : attribute->args()) {
        if (argument->containsErrors()) continue;  // which Clang has reported
        report_changed_numbers(*argument, report);
        read(evaluated(argument, report.context()));
      }
}

/// Remembers where an option stands; an option that was there before is an error.
class KnownPlaces {
 public:
  explicit KnownPlaces(Report& report) : report_(report) {}

  bool add(Aspect aspect, const Option& option, llvm::StringRef name) {
    const auto [first, is_new] = places.emplace(aspect, option.range());
    if (!is_new)
      report_.error(option.range(), name.str() + " is given twice; remove one of them",
                    Note{first->second, "the first one is here"});
    return is_new;
  }

  OptionPlaces places;

 private:
  Report& report_;
};

/// The row of the catalogue for an enumerator, found by its name, so that the schema's lists may stand in any order.
/// Null, with a report: this physgen has none, because the vocabulary is that of another one, found by -I.
template <class Facts>
const Facts* known(std::span<const Facts> rows, const std::string& name, const char* what, const Option& option,
                   Report& report) {
  const Facts* row = model::find_word(rows, name);
  if (row == nullptr) {
    std::vector<std::string> words;
    for (const Facts& candidate : rows) words.emplace_back(candidate.word);
    report.error(option.range(), "this physgen does not know the " + std::string(what) + " " + in_quotes(name) +
                                     " of <physgen/schema.h>, which is for another version; it knows " +
                                     model::joined(words, " and "));
  }
  return row;
}

void reject(const Option& option, const char* macro, const char* options, Report& report) {
  report.error(option.range(), std::string(option.type.empty() ? "this is not an option"
                                                               : "this is not an option of " + std::string(macro)) +
                                   "; " + macro + " takes " + options);
}

/// The two words of layout(space, pattern) or format(space, encoding).
template <class Facts>
struct Words {
  const model::SpaceFacts* space = nullptr;
  const Facts* row = nullptr;  ///< null, with a report: the catalogue does not have both
  [[nodiscard]] bool host() const { return space->key == model::Space::host; }
};

/// @param option "layout"
/// @param part its second word: "pattern"
/// @param what that part is called in the catalogue
/// @param choices what may be written for it
template <class Facts>
Words<Facts> words(const Option& option, std::span<const Facts> rows, const std::string& name, const char* part,
                   const char* what, const std::string& choices, Report& report) {
  const auto space = option.member(0).enumerator(), row = option.member(1).member(0).enumerator();
  if (!space || !row) {
    report.error(option.range(), "this names no space or no " + std::string(part) + " of the vocabulary; write " +
                                     name + "(host, ...) or " + name + "(cuda, ...) with " + choices);
    return {};
  }
  const auto* known_space = known(model::spaces(), *space, "memory space", option, report);
  const auto* known_row = known(rows, *row, what, option, report);
  return {known_space, known_space == nullptr ? nullptr : known_row};
}

}  // namespace

OptionPlaces read_options(const clang::Decl& declaration, model::Object& object, Report& report) {
  KnownPlaces places(report);
  for_each_option(declaration, object_annotation, report, [&](const Option& option) {
    if (option.type == "Layout") {
      const auto said = words(option, model::layouts(), "layout", "pattern", "layout",
                              model::joined(model::layout_words("tile"), " or "), report);
      if (said.row == nullptr || !places.add(said.host() ? Aspect::host_layout : Aspect::cuda_layout, option,
                                             "layout(" + std::string(said.space->word) + ", ...)"))
        return;
      const int tile = static_cast<int>(option.member(1).member(1).value.getInt().getExtValue());
      (said.host() ? object.host_layout : object.cuda_layout) = model::Layout{said.row->key, tile};
    } else if (option.type == "Alignment") {
      if (!places.add(Aspect::alignment, option, "align(...)")) return;
      object.alignment = option.integer(0);
      if (object.alignment == 0)  // which the model reads as nothing asked for
        report.error(option.range(), "alignment 0 is not a power of two from 1 to 256; write one, such as align(16)");
    } else {
      reject(option, "PHYSGEN_OBJECT", object_options, report);
    }
  });
  return std::move(places.places);
}

OptionPlaces read_options(const clang::Decl& declaration, model::Field& field, Report& report) {
  KnownPlaces places(report);
  for_each_option(declaration, field_annotation, report, [&](const Option& option) {
    if (option.type == "Unit") {
      if (!places.add(Aspect::unit, option, "unit(...)")) return;
      const auto text = literal(option.value.getStructField(0));
      if (!text)
        report.error(option.range(), "a unit must be a string literal; write one, such as unit(\"Pa\")");
      else if (text->empty())
        report.error(option.range(), "the unit is empty; write \"1\" for a number without unit, or leave unit() out");
      else
        field.unit = *text;
    } else if (option.type == "Range") {
      if (places.add(Aspect::range, option, "range(...)")) field.range = model::Range{option.real(0), option.real(1)};
    } else if (option.type == "Initial") {
      if (places.add(Aspect::initial, option, "initial(...)")) field.initial = option.real(0);
    } else if (option.type == "Format") {
      const auto said = words(option, model::encodings(), "format", "encoding", "encoding",
                              model::joined(model::encoding_words()) + " or quaternion(...)", report);
      if (said.row == nullptr) return;
      const auto quaternions = option.member(1).member(1).value.getInt().getExtValue();
      if (quaternions != 0 && quaternions != 1)
        return report.error(option.range(),
                            "the components of a quaternion are numbers, not quaternions; write quaternion(), or one "
                            "with their encoding, such as quaternion(half)");
      if (!places.add(said.host() ? Aspect::host_format : Aspect::cuda_format, option,
                      "format(" + std::string(said.space->word) + ", ...)"))
        return;
      (said.host() ? field.host_format : field.cuda_format) = model::Format{said.row->key, quaternions == 1};
    } else {
      reject(option, "PHYSGEN", field_options, report);
    }
  });
  return std::move(places.places);
}

std::optional<clang::SourceRange> marker(const clang::Decl& declaration, llvm::StringRef annotation) {
  for (const auto* attribute : declaration.specific_attrs<clang::AnnotateAttr>())
    if (attribute->getAnnotation() == annotation && !attribute->isInherited()) return attribute->getRange();
  return std::nullopt;
}

}  // namespace physgen::frontend
