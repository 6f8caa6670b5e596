// The object tag with the fields as data, the aliases for views and arrays, and the proofs that compilers check.
#include "emit/pieces.h"
#include "emit/text.h"

namespace physgen::emit {
namespace {

std::string layout_type(const model::Layout& layout) {
  const model::LayoutFacts& row = model::facts(layout.kind);
  return "physgen::" + std::string(row.type) + (row.tiled ? "<" + std::to_string(layout.tile) + ">" : "");
}

std::string space_type(model::Space space) { return "physgen::" + std::string(model::facts(space).type); }

// In terms of the records that accessors use, so that the proofs below are about the accessors' addresses.
std::string offset(const plan::Run& run, const model::Object& user) {
  std::string text, formats = "Formats";
  for (const plan::Step& step : run.path) {
    if (!text.empty()) text += " + ";
    const std::string record = type_name(*step.record->object, "Record", user) + "<Real, " + formats + ">::";
    text += record + step.declaration().name;
    if (step.entry > 0) {
      text += " + " + std::to_string(step.entry) + " * " + record + "plan_.stride[" + std::to_string(step.field) + "]";
    }
    formats = (formats == "Formats" ? "typename Formats::" : formats + "::") + step.declaration().name;
  }
  return text;
}

// "typename Formats::svd::U"
std::string format(const plan::Run& run) {
  std::string text = "typename Formats";
  for (const plan::Step& step : run.path) text += "::" + step.declaration().name;
  return text;
}

// "??/" in a string is a backslash to compilers that know trigraphs, and a warning to others.
std::string without_trigraphs(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '?' ? std::string("\\?") : std::string(1, c);
  return escaped;
}

void fields(Printer& out, const plan::Record& record) {
  const std::vector<plan::Run> runs = plan::runs(record);
  out.line("template <class Real, class Formats>");
  out.open("static constexpr std::array<physgen::FieldInfo, " + std::to_string(runs.size()) + "> fields = {{");
  for (const plan::Run& run : runs) {
    const model::Field& field = run.field();
    out.filled(
        "physgen::field_info<" + shape_type(field) + ", " + format(run) + ", " + stored_type(field.element) + ">(",
        {"\"" + run.name() + "\"", "\"" + without_trigraphs(field.unit) + "\"", offset(run, *record.object),
         std::to_string(field.array_extent == 0 ? 1 : field.array_extent), real(field.initial.value_or(0))},
        "),");
  }
  out.close("}};");
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
void proof(Printer& out, const plan::Record& record, const char* real, int plan::Bytes::* precision) {
  std::vector<std::string> numbers{std::to_string(record.bytes.*precision),
                                   std::to_string(record.alignment.*precision)};
  for (const plan::Run& run : plan::runs(record)) {
    numbers.push_back((numbers.size() == 2 ? "{" : "") + std::to_string(run.offset.*precision));
  }
  numbers.back() += "}";
  const std::string& name = record.object->name;
  out.filled("static_assert(physgen::is_sound_record<" + name + "Object, " + real + ", " + name + "Formats<" +
                 space_type(record.space) + ">>(",
             numbers, "));");
}

bool same(const plan::Record& a, const plan::Record& b) {
  const auto runs_a = plan::runs(a), runs_b = plan::runs(b);
  for (std::size_t r = 0; r < runs_a.size(); ++r) {
    if (runs_a[r].offset != runs_b[r].offset || runs_a[r].count != runs_b[r].count) return false;
  }
  return a.bytes == b.bytes && a.alignment == b.alignment;
}

bool same_formats(const plan::Record& a, const plan::Record& b) {
  const auto runs_a = plan::runs(a), runs_b = plan::runs(b);
  for (std::size_t r = 0; r < runs_a.size(); ++r) {
    const model::Field& field = runs_a[r].field();
    if (field.host_format != field.cuda_format) return false;
  }
  return runs_a.size() == runs_b.size();
}

void proofs(Printer& out, const plan::Record& host, const plan::Record& cuda) {
  out.comment("//",
              "Proved by physgen for every layout and every number of objects, and compared with what the compiler "
              "finds: bytes and alignment of the record, offsets of the fields; no two channels share a byte, each is "
              "aligned to its elements and lies inside its tile.");
  for (const plan::Record* record : {&host, &cuda}) {
    if (record == &cuda && same(host, cuda)) return;
    proof(out, *record, "float", &plan::Bytes::with_float);
    proof(out, *record, "double", &plan::Bytes::with_double);
  }
}

}  // namespace

void object_tag(Printer& out, const plan::Record& host, const plan::Record& cuda) {
  const model::Object& object = *host.object;
  out.line("/// What the runtime knows of " + object.name + ".");
  out.open("struct " + object.name + "Object {");
  out.line("static constexpr std::string_view name = \"" + object.qualified_name() + "\";");
  out.line("template <class Real>");
  out.line("using Value = " + object.name + "<Real>;");
  out.line("template <class Real, class Formats>");
  out.line("using Record = " + object.name + "Record<Real, Formats>;");
  out.line("template <class Real, class Formats, class Cursor>");
  out.line("using Ref = " + object.name + "Ref<Real, Formats, Cursor>;");
  fields(out, host);
  out.line("template <class Space>");
  // One type where the spaces agree, so that kernels may name views without saying for which space.
  const std::string space = same_formats(host, cuda) ? "physgen::Host" : "Space";
  out.line("using Formats = " + object.name + "Formats<" + space + ">;");
  out.line("template <class ArrayTag, class Base>");
  out.line("using Probe = " + object.name + "Probe<ArrayTag, Base>;");
  out.close("};");
  out.line();
  aliases(out, object);
  out.line();
  proofs(out, host, cuda);
}

}  // namespace physgen::emit
