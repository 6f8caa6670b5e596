// The object tag with the fields as data, the aliases for views and arrays, and the proofs that compilers check.
#include <algorithm>

#include "emit/cpp/pieces.h"
#include "emit/cpp/text.h"

namespace physgen::emit::cpp {
namespace {

std::string space_type(model::Space space) { return "physgen::" + std::string(model::facts(space).type); }

// "??/" in a string is a backslash to compilers that know trigraphs, and a warning to others.
std::string without_trigraphs(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '?' ? std::string("\\?") : std::string(1, c);
  return escaped;
}

using Runs = std::vector<plan::Run>;

void texts(Printer& out, const Runs& runs) {
  std::vector<std::string> items;
  for (const plan::Run& run : runs) {
    const model::Field& field = run.field();
    std::string text = "{\"" + run.name() + "\"";
    if (!field.unit.empty() || field.initial) text += ", \"" + without_trigraphs(field.unit) + "\"";
    if (field.initial) text += ", " + real(*field.initial);
    items.push_back(text + "}");
  }
  out.filled("static constexpr std::array<physgen::FieldText, " + std::to_string(runs.size()) + "> texts = {{", items,
             "}};");
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
  out.close("};");
  out.line();
  aliases(out, object);
  proof(out, host, host_runs);
  const bool same_record = host.bytes == cuda.bytes && host.alignment == cuda.alignment;
  if (!same_record || !same(host_runs, cuda_runs)) proof(out, cuda, cuda_runs);
}

}  // namespace physgen::emit::cpp
