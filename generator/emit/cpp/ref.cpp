// The reference class: one accessor per field over a cursor, and get and put for all of them.
#include <algorithm>

#include "emit/cpp/pieces.h"
#include "emit/cpp/text.h"

namespace physgen::emit::cpp {
namespace {

void accessor(Printer& out, const model::Object& object, const model::Field& field) {
  std::string comment = field_comment(field);
  std::string offset = "Record::" + field.name + "::offset";
  std::string parameter;
  std::vector<std::string> lines;
  if (field.array_extent != 0) {
    const std::string extent = std::to_string(field.array_extent);
    comment += comment.empty() ? "" : "\n";
    comment += "@pre 0 <= entry < " + extent;
    offset += " + entry * Record::" + field.name + "::stride";
    parameter = "int entry";
    lines.push_back("physgen::check_inner(entry, " + extent + ", \"an entry of " + object.qualified_name() +
                    "::" + field.name + "\");");
  }
  if (!comment.empty()) out.comment("///", comment);
  lines.push_back("return this->field_(typename Record::" + field.name + "(), " + offset + ");");
  out.function("PHYSGEN_FUNCTION decltype(auto) " + field.name + "(" + parameter + ") const", lines);
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

bool has_long_arrays(const model::Object& object) {
  return std::any_of(object.fields.begin(), object.fields.end(),
                     [](const model::Field& field) { return field.array_extent > longest_unrolled; });
}

const char* read(const model::Field& field) { return field.shape == model::Shape::scalar ? "" : ".get()"; }

void get(Printer& out, const model::Object& object) {
  const std::string signature = "PHYSGEN_FUNCTION const Value get() const";
  if (!has_long_arrays(object)) {  // an aggregate, in order of declaration, so that nothing begins as 0 before
    std::vector<std::string> items;
    for (const model::Field& field : object.fields) {
      const int entries = field.array_extent;
      if (entries == 0) items.push_back(field.name + "()" + read(field));
      for (int entry = 0; entry < entries; ++entry)
        items.push_back((entry == 0 ? "{" : "") + field.name + "(" + std::to_string(entry) + ")" + read(field) +
                        (entry == entries - 1 ? "}" : ""));
    }
    std::string all;
    for (const std::string& item : items) all += (all.empty() ? "" : ", ") + item;
    if (Printer::columns >= signature.size() + all.size() + 16)
      return out.function(signature, {"return {" + all + "};"});
    out.open(signature + " {");
    out.filled("return {", items, "};");
    return out.close("}");
  }
  const std::string value = local_name("value", object);
  std::vector<std::string> lines{"Value " + value + ";"};
  for (const model::Field& field : object.fields) {
    append_entries(lines, object, field, [&](const std::string& member, const std::string& call) {
      return value + "." + field.name + member + " = " + field.name + call + read(field) + ";";
    });
  }
  lines.push_back("return " + value + ";");
  out.function(signature, lines);
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

}  // namespace

void ref_class(Printer& out, const model::Object& object) {
  const std::string name = object.name + "Ref";
  out.line("template <class Real, class Formats, class Cursor>");
  out.open("struct " + name + " : physgen::OnCursor<Cursor> {");
  out.line("using physgen::OnCursor<Cursor>::OnCursor;");
  out.line("using Record = " + object.name + "Record<Real, Formats>;");
  out.line("using Value = " + object.name + "<typename Cursor::template Lanes<Real>>;");
  out.line();
  for (const model::Field& field : object.fields) accessor(out, object, field);
  out.line();
  get(out, object);
  put(out, object);
  out.close("};");
}

}  // namespace physgen::emit::cpp
