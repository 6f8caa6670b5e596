// The object tag with the fields as data, the aliases for views and arrays, and the proofs that compilers check.
#include <algorithm>
#include <utility>

#include "emit/cpp/pieces.h"
#include "emit/cpp/text.h"

namespace physgen::emit::cpp {
namespace {

std::string space_type(model::Space space) { return "physgen::" + std::string(model::facts(space).type); }

// A literal of C++. "??/" in it is a backslash to compilers that know trigraphs, and a warning to others.
std::string quoted(const std::string& text) {
  std::string literal = "\"";
  for (const char c : text) {
    if (c == '\r') continue;
    if (c == '?' || c == '"' || c == '\\') literal += '\\';
    literal += c == '\n' ? std::string("\\n") : std::string(1, c);
  }
  return literal + "\"";
}

using Runs = std::vector<plan::Run>;

void texts(Printer& out, const Runs& runs) {
  std::vector<std::string> items;
  for (const plan::Run& run : runs) {
    const model::Field& field = run.field();
    std::string text = "{" + quoted(run.name());
    if (!field.unit.empty() || field.initial) text += ", " + quoted(field.unit);
    if (field.initial) text += ", " + real(*field.initial);
    items.push_back(text + "}");
  }
  out.filled("static constexpr std::array<physgen::FieldText, " + std::to_string(runs.size()) + "> texts = {{", items,
             "}};");
}

constexpr std::size_t longest_line = 110;  // within the braces of a member

// The pieces of a text, as literals of one line each.
std::vector<std::string> pieces(std::string text) {
  constexpr std::size_t longest = longest_line - 20;  // without what is escaped
  while (text.ends_with(' ')) text.pop_back();
  std::vector<std::string> literals;
  while (text.size() > longest) {
    const std::size_t blank = text.rfind(' ', longest);
    if (blank == std::string::npos) break;
    literals.push_back(quoted(text.substr(0, blank + 1)));
    text.erase(0, blank + 1);
  }
  literals.push_back(quoted(text));
  return literals;
}

// What the schema says of the fields of the object itself; nested ones have theirs.
void docs(Printer& out, const model::Object& object) {
  const auto has_doc = [](const model::Field& field) { return !field.doc.empty(); };
  if (std::none_of(object.fields.begin(), object.fields.end(), has_doc)) return;
  const std::string count = std::to_string(object.fields.size());
  out.open("static constexpr std::array<std::string_view, " + count + "> docs = {");
  std::string line;  // of as many literals as fit
  for (const model::Field& field : object.fields) {
    const std::vector<std::string> literals = pieces(field.doc);
    for (const std::string& literal : literals) {
      const std::string item = literal + (&literal == &literals.back() ? "," : "");
      if (!line.empty() && line.size() + 1 + item.size() > longest_line) out.line(std::exchange(line, {}));
      line += (line.empty() ? "" : " ") + item;
    }
  }
  out.line(line);
  out.close("};");
}

void aliases(Printer& out, const model::Object& object) {
  const std::string tag = object.name + "Object";
  const std::string formats = "class Formats = physgen::FormatsOf<" + tag + ", Space>";
  out.list("template <", {"class Real", "class Layout", "class Space = physgen::Host", formats}, ">");
  out.wrapped("using " + object.name + "View = physgen::View<" + tag + ", Real, Layout, Formats, Space>;");
  const std::string host = layout_type(object.layout(model::Space::host));
  const std::string cuda = layout_type(object.layout(model::Space::cuda));
  out.list("template <",
           {"class Real", "class Space = physgen::Host",
            "class Layout = physgen::PerSpace<Space, " + host + ", " + cuda + ">", formats},
           ">");
  out.wrapped("using " + object.name + "Array = physgen::Array<" + tag + ", Real, Space, Layout, Formats>;");
}

// Offsets of all runs, so that what was proved here of the plan is what compilers find of the accessors.
std::string numbers(const plan::Record& record, const Runs& runs, plan::Precision real) {
  std::string text = "{" + std::to_string(record.bytes.of(real)) + ", " + std::to_string(record.alignment.of(real));
  for (const plan::Run& run : runs)
    text += (&run == &runs.front() ? ", {" : ", ") + std::to_string(run.offset.of(real));
  return text + "}}";
}

void proof(Printer& out, const plan::Record& record, const Runs& runs) {
  out.filled(
      "static_assert(physgen::are_sound_records<" + record.object->name + "Object, " + space_type(record.space) + ">(",
      {numbers(record, runs, plan::Precision::with_float), numbers(record, runs, plan::Precision::with_double)}, "));");
}

bool same(const Runs& a, const Runs& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const plan::Run& x, const plan::Run& y) { return x.offset == y.offset && x.count == y.count; });
}

bool same_formats(const Runs& runs) {
  return std::all_of(runs.begin(), runs.end(),
                     [](const plan::Run& run) { return run.field().host_format == run.field().cuda_format; });
}

}  // namespace

void object_tag(Printer& out, const plan::Record& host, const plan::Record& cuda) {
  const model::Object& object = *host.object;
  const std::string& name = object.name;
  const Runs host_runs = plan::runs(host), cuda_runs = plan::runs(cuda);
  // One type of formats where the spaces agree, so that kernels may name views without saying for which space.
  out.filled("struct " + name + "Object : physgen::ObjectTag" + (same_formats(host_runs) ? "<" : "PerSpace<"),
             {name + "Object", name, name + "Formats", name + "Record", name + "Ref", name + "Probe"}, "> {");
  out.open();
  out.line("static constexpr std::string_view name = \"" + object.qualified_name() + "\";");
  texts(out, host_runs);
  docs(out, object);
  out.close("};");
  out.line();
  aliases(out, object);
  proof(out, host, host_runs);
  const bool same_record = host.bytes == cuda.bytes && host.alignment == cuda.alignment;
  if (!same_record || !same(host_runs, cuda_runs)) proof(out, cuda, cuda_runs);
}

}  // namespace physgen::emit::cpp
