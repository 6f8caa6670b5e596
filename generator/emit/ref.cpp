// The reference class: one accessor per field over a cursor, and get and put for all of them.
#include "emit/pieces.h"
#include "emit/text.h"

namespace physgen::emit {
namespace {

// Longer loops stay loops: code size and compile time must not grow with the extent of an array.
constexpr int longest_unrolled = 32;

void accessor(Printer& out, const model::Object& object, std::size_t number) {
  const model::Field& field = object.fields[number];
  std::string comment = field_comment(field);
  std::string offset = "Record::" + field.name;
  std::string parameter;
  if (field.array_extent != 0) {
    comment += comment.empty() ? "" : "\n";
    comment += "@pre 0 <= entry < " + std::to_string(field.array_extent);
    offset += " + entry * Record::plan_.stride[" + std::to_string(number) + "]";
    parameter = "int entry";
  }
  if (!comment.empty()) out.comment("///", comment);
  const std::string name = field.name + "(" + parameter + ") const";
  std::vector<std::string> lines;
  if (field.array_extent != 0) {
    lines.push_back("physgen::check_inner(entry, " + std::to_string(field.array_extent) + ", \"an entry of " +
                    object.qualified_name() + "::" + field.name + "\");");
  }
  if (field.shape == model::Shape::object) {
    const std::string ref =
        nested_type_name(field, "Ref", object) + "<Real, typename Formats::" + field.name + ", Cursor>";
    lines.push_back("return " + ref + "(at_.nested(" + offset + "));");
    out.function("PHYSGEN_FUNCTION " + ref + " " + name, lines);
    return;
  }
  const std::string access = "field<" + stored_as(field) + ">";
  lines.push_back("return at_.template " + access + "(" + offset + ");");
  out.function("PHYSGEN_FUNCTION decltype(auto) " + name, lines);
}

// The statement for one field, or the lines of a loop of it over the entries of an array. `statement` is given what
// stands behind the field's name in a value ("" or "[entry]") and in a call ("()" or "(entry)").
template <class Statement>
void append_entries(std::vector<std::string>& lines, const model::Object& object, const model::Field& field,
                    const Statement& statement) {
  if (field.array_extent == 0) {
    lines.push_back(statement("", "()"));
    return;
  }
  const std::string entry = local_name("entry", object);
  if (field.array_extent <= longest_unrolled) lines.push_back("PHYSGEN_UNROLL");
  const std::string extent = std::to_string(field.array_extent);
  lines.push_back("for (int " + entry + " = 0; " + entry + " < " + extent + "; ++" + entry + ") " +
                  statement("[" + entry + "]", "(" + entry + ")"));
}

void get(Printer& out, const model::Object& object) {
  const std::string value = local_name("value", object);
  std::vector<std::string> lines{"Value " + value + ";"};
  for (const model::Field& field : object.fields) {
    append_entries(lines, object, field, [&](const std::string& member, const std::string& call) {
      const char* get = field.shape == model::Shape::scalar ? ";" : ".get();";
      return value + "." + field.name + member + " = " + field.name + call + get;
    });
  }
  lines.push_back("return " + value + ";");
  out.function("PHYSGEN_FUNCTION const Value get() const", lines);
}

void put(Printer& out, const model::Object& object) {
  const std::string value = local_name("value", object);
  std::vector<std::string> lines;
  for (const model::Field& field : object.fields) {
    append_entries(lines, object, field, [&](const std::string& member, const std::string& call) {
      const std::string from = value + "." + field.name + member;
      return field.name + call + (field.shape == model::Shape::object ? ".put(" + from + ");" : " = " + from + ";");
    });
  }
  out.function("PHYSGEN_FUNCTION void put(const Value& " + value + ") const", lines);
}

// Assignment copies objects, as `view[i] = view[j]` looks. A named reference that is not const is refused: std::swap
// and algorithms would take it for a value.
void assignment(Printer& out, const model::Object& object) {
  const std::string name = object.name + "Ref", other = local_name("other", object);
  out.line(name + "(const " + name + "&) = default;");
  out.line(name + "& operator=(const " + name + "&) & = delete;");
  const std::vector<std::string> copy{"return physgen::assign(*this, " + other + ");"};
  out.function("PHYSGEN_FUNCTION decltype(auto) operator=(const " + name + "&& " + other + ") const&", copy);
  out.line("template <physgen::ReadsAs<Value> Other>");
  out.function("PHYSGEN_FUNCTION decltype(auto) operator=(const Other&& " + other + ") const&", copy);
}

}  // namespace

void ref_class(Printer& out, const plan::Record& record) {
  const model::Object& object = *record.object;
  const std::string name = object.name + "Ref";
  out.comment("///", "One " + object.name +
                         " of an array, or those under a SIMD index: fields by name, all of them by get and put.");
  out.line("template <class Real, class Formats, class Cursor>");
  out.open("class " + name + " {");
  out.line("using Record = " + object.name + "Record<Real, Formats>;");
  out.line();
  out.label("public:");
  out.line("using Value = " + object.name + "<typename Cursor::template Lanes<Real>>;");
  out.line();
  out.line("PHYSGEN_FUNCTION explicit " + name + "(const Cursor& cursor) : at_(cursor) {}");
  assignment(out, object);
  out.line();
  for (std::size_t f = 0; f < object.fields.size(); ++f) accessor(out, object, f);
  out.line();
  get(out, object);
  put(out, object);
  out.line();
  out.label("private:");
  out.line("Cursor at_;");
  out.close("};");
}

}  // namespace physgen::emit
