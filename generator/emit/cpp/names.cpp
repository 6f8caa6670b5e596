// See names.h.
#include "emit/cpp/names.h"

#include <algorithm>
#include <cctype>

#include "emit/cpp/taken_names.h"
#include "model/facts.h"

namespace physgen::emit::cpp {
namespace {

constexpr std::string_view reserved_fields[] = {"get",       "put",     "Real", "Cursor", "Value",   "Record", "bytes",
                                                "alignment", "physgen", "std",  "Eigen",  "Formats", "Space"};
// Objects must not hide what generated code says beside them, its template parameters, nor the words of the schema.
constexpr std::string_view reserved_objects[] = {"Real", "Cursor", "Value",   "Record", "Layout", "Space",
                                                 "View", "Array",  "Ref",     "Object", "bytes",  "alignment",
                                                 "get",  "put",    "physgen", "std",    "Eigen",  "Formats"};
constexpr std::string_view reserved_scopes[] = {"physgen", "std", "Eigen", "xsimd"};

bool is_type_of_the_vocabulary(std::string_view name) {
  return std::ranges::any_of(model::shapes(), [&](const model::ShapeFacts& row) { return row.type == name; }) ||
         std::ranges::any_of(model::elements(), [&](const model::ElementFacts& row) { return row.schema == name; });
}

bool is_identifier(std::string_view name) {
  const auto letter = [](unsigned char c) { return std::isalpha(c) != 0 || c == '_'; };
  const auto letter_or_digit = [&](unsigned char c) { return letter(c) || std::isdigit(c) != 0; };
  return !name.empty() && letter(static_cast<unsigned char>(name.front())) &&
         std::all_of(name.begin(), name.end(), letter_or_digit);
}

// M_pi for M_PI, C_v for C_V, nu_12 for NU_12.
std::string with_small_letters(std::string_view name) {
  std::string changed(name);
  const auto lower = [](unsigned char c) { return static_cast<char>(std::tolower(c)); };
  const auto underscore = changed.begin() + static_cast<std::ptrdiff_t>(changed.find('_'));
  std::transform(underscore, changed.end(), underscore, lower);
  if (is_written_as_a_macro(changed)) std::transform(changed.begin(), underscore, changed.begin(), lower);
  return changed;
}

}  // namespace

std::string name_problem(std::string_view name, NameOf of) {
  if (!is_identifier(name)) return "is not a name of ASCII letters, digits and underscores; choose such a name";
  if (name.front() == '_') return "begins with an underscore, which is reserved; write the name without it";
  if (name.back() == '_')
    return "ends with an underscore, which generated code keeps for its own members; write the name without it";
  if (name.find("__") != std::string_view::npos)
    return "contains two underscores in a row, which is reserved for compilers; write one";
  if (is_word_of_the_language(name)) return "is a keyword of C++20; choose another name";
  if (is_written_as_a_macro(name))
    return "is written as the macros of system headers are, in capitals with an underscore; write '" +
           with_small_letters(name) + "' or another name with a small letter";
  if (is_macro(name))
    return "is a macro of a header that programs include, and means something else there; choose another name";
  const bool reserved = of == NameOf::field    ? is_one_of(name, reserved_fields)
                        : of == NameOf::object ? is_one_of(name, reserved_objects) || is_type_of_the_vocabulary(name)
                                               : is_one_of(name, reserved_scopes);
  if (reserved) return "is a name that generated code needs for itself; choose another name";
  return {};
}

}  // namespace physgen::emit::cpp
