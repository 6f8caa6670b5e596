// See module.h.
#include "emit/python/module.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "emit/cpp/header.h"
#include "emit/cpp/rules.h"
#include "emit/cpp/text.h"
#include "emit/file_name.h"
#include "emit/printer.h"
#include "model/text.h"

namespace physgen::emit::python {
namespace {

/// The words that Python keeps and that a schema may be called.
constexpr std::string_view keywords[] = {"False",  "None",   "True",    "and",      "as",       "assert", "async",
                                         "await",  "break",  "class",   "continue", "def",      "del",    "elif",
                                         "else",   "except", "finally", "for",      "from",     "global", "if",
                                         "import", "in",     "is",      "lambda",   "nonlocal", "not",    "or",
                                         "pass",   "raise",  "return",  "try",      "while",    "with",   "yield"};

bool names_a_module(const std::string& name) {
  const auto is_letter = [](unsigned char c) { return c < 0x80 && (std::isalnum(c) != 0 || c == '_'); };
  return !name.empty() && std::isdigit(static_cast<unsigned char>(name.front())) == 0 &&
         std::all_of(name.begin(), name.end(), is_letter) &&
         std::find(std::begin(keywords), std::end(keywords), name) == std::end(keywords);
}

/// A line of text as a literal of C++.
std::string literal(std::string_view line) {
  std::string text = "\"";
  for (const char c : line) {
    if (c == '"' || c == '\\' || c == '?') text += '\\';  // "??/" is a backslash to compilers that know trigraphs
    text += c;
  }
  return text + "\\n\"";
}

/// Appends the lines of `text` to `lines`, with blanks before each.
void add_lines(std::vector<std::string>& lines, std::string_view text, std::string_view before) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    while (line.ends_with('\r') || line.ends_with(' ')) line.remove_suffix(1);
    lines.push_back(line.empty() ? "" : std::string(before).append(line));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

/// What help() prints of a class: the comment of the object, and its fields with types, units and comments.
std::vector<std::string> documentation(const model::Object& object) {
  std::vector<std::string> lines;
  add_lines(lines, object.doc, "");
  if (!lines.empty()) lines.emplace_back();
  for (const model::Field& field : object.fields) {
    std::string line = field.name + " : " + model::schema_type(field);
    if (field.array_extent > 0) line += "[" + std::to_string(field.array_extent) + "]";
    if (!field.unit.empty()) line += " [" + field.unit + "]";
    lines.push_back(line);
    add_lines(lines, field.doc, "    ");
  }
  return lines;
}

void class_of(Printer& out, const model::Object& object) {
  out.line("  physgen::python::add_class<" + object.qualified_name() + "Object, " +
           cpp::layout_type(object.layout(model::Space::host)) + ", " +
           cpp::layout_type(object.layout(model::Space::cuda)) + ">(");
  out.line("      module, \"" + object.name + "\",");
  const std::vector<std::string> lines = documentation(object);
  for (std::size_t i = 0; i < lines.size(); ++i)
    out.line("      " + literal(lines[i]) + (i + 1 == lines.size() ? ");" : ""));
}

}  // namespace

std::string module_source(const model::Schema& schema) {
  const std::string name = file_name(schema.file, "");
  Printer out;
  out.comment("//", "The Python module " + name + " of the object types in " + schema.file +
                        ". Written by physgen: change the schema, not this file.");
  out.line("#include <physgen/python/module.h>");
  out.line();
  out.line("#include \"" + file_name(schema.file, cpp::ending) + "\"");
  out.line();
  out.line("PYBIND11_MODULE(" + name + ", module) {");
  for (const model::Object& object : schema.objects) class_of(out, object);
  out.line("#ifdef PHYSGEN_PYTHON_SOURCES");
  out.line("  physgen::python::add_functions(module);");
  out.line("#endif");
  out.line("}");
  return std::move(out).text();
}

std::vector<model::Issue> objections(const model::Schema& schema) {
  std::vector<model::Issue> issues = cpp::objections(schema);
  const std::string name = file_name(schema.file, "");
  if (!names_a_module(name) && !schema.objects.empty()) {
    issues.push_back({{false, 0, -1},
                      model::Aspect::name,
                      "the Python module of this schema would be called " + model::in_quotes(name) +
                          ", which is no name in Python; rename the file " + model::in_quotes(schema.file),
                      {}});
  }
  std::map<std::string, model::Place> classes;
  model::for_each_object(schema, [&](const model::Object& object, model::Place place) {
    if (place.imported) return;
    const auto [first, is_new] = classes.emplace(object.name, place);
    if (is_new || schema.objects[static_cast<std::size_t>(first->second.object)].scope == object.scope) return;
    issues.push_back({place, model::Aspect::name,
                      "a second object is called " + model::in_quotes(object.name) +
                          "; classes of a Python module stand in no namespaces, so rename one of them",
                      first->second});
  });
  return issues;
}

}  // namespace physgen::emit::python
