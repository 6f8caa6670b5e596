// The object tag with the fields as data, the aliases for views and arrays, and the proofs that compilers check.
#include "emit/pieces.h"
#include "emit/text.h"

namespace physgen::emit {
namespace {

constexpr model::Layout default_host{model::LayoutKind::aosoa, 16};
constexpr model::Layout default_cuda{model::LayoutKind::aosoa, 32};

std::string layout_type(const model::Layout& layout) {
  switch (layout.kind) {
    case model::LayoutKind::aos:
      return "physgen::Aos";
    case model::LayoutKind::aos_padded:
      return "physgen::AosPadded";
    case model::LayoutKind::soa:
      return "physgen::Soa";
    case model::LayoutKind::aosoa:
      break;
  }
  return "physgen::Aosoa<" + std::to_string(layout.tile) + ">";
}

std::string element_type(model::Element element) {
  switch (element) {
    case model::Element::real:
      return "physgen::element_type<Real>";
    case model::Element::float32:
      return "physgen::ElementType::float32";
    case model::Element::float64:
      return "physgen::ElementType::float64";
    case model::Element::index:
    case model::Element::int32:
      break;
  }
  return "physgen::ElementType::int32";
}

// In terms of the records that accessors use, so that the proofs below are about the accessors' addresses.
std::string offset(const plan::Run& run, const model::Object& user) {
  std::string text;
  for (const plan::Step& step : run.path) {
    if (!text.empty()) text += " + ";
    text += type_name(*step.record->object, "Record", user) + "<Real>::" + step.declaration().name;
    if (step.entry > 0) text += " + " + std::to_string(step.entry) + " * " + bytes(step.slot().stride);
  }
  return text;
}

void fields(Printer& out, const plan::Record& record) {
  const std::vector<plan::Run> runs = plan::runs(record);
  out.line("template <class Real>");
  out.open("static constexpr std::array<physgen::FieldInfo, " + std::to_string(runs.size()) + "> fields = {{");
  for (const plan::Run& run : runs) {
    const model::Field& field = run.field();
    out.list("  {",
             {"\"" + run.name() + "\"", "\"" + field.unit + "\"", element_type(field.element),
              offset(run, *record.object), std::to_string(run.count), number(field.initial.value_or(0))},
             "},");
  }
  out.close("}};");
}

void aliases(Printer& out, const model::Object& object) {
  const std::string tag = object.name + "Object";
  out.line("template <class Real, class Layout>");
  out.line("using " + object.name + "View = physgen::View<" + tag + ", Real, Layout>;");
  const std::string host = layout_type(object.host_layout.value_or(default_host));
  const std::string cuda = layout_type(object.cuda_layout.value_or(default_cuda));
  out.list("template <",
           {"class Real", "class Space = physgen::Host",
            "class Layout = physgen::PerSpace<Space, " + host + ", " + cuda + ">"},
           ">");
  out.line("using " + object.name + "Array = physgen::Array<" + tag + ", Real, Space, Layout>;");
}

void proofs(Printer& out, const plan::Record& record) {
  out.line(
      "// Proved for both precisions: no two elements share a byte, each is aligned to its size, the record holds "
      "all.");
  const auto proof = [&](const char* real, int bytes, int alignment) {
    out.line("static_assert(physgen::is_sound_record<" + record.object->name + "Object, " + real + ">(" +
             std::to_string(bytes) + ", " + std::to_string(alignment) + "));");
  };
  proof("float", record.bytes.with_float, record.alignment.with_float);
  proof("double", record.bytes.with_double, record.alignment.with_double);
}

}  // namespace

void object_tag(Printer& out, const plan::Record& record) {
  const model::Object& object = *record.object;
  out.line("/// What the runtime knows of " + object.name + ".");
  out.open("struct " + object.name + "Object {");
  out.line("static constexpr std::string_view name = \"" + object.qualified_name() + "\";");
  for (const char* piece : {"Value", "Record"}) {
    out.line("template <class Real>");
    out.line("using " + std::string(piece) + " = " + object.name + (piece[0] == 'V' ? "" : piece) + "<Real>;");
  }
  out.line("template <class Real, class Cursor>");
  out.line("using Ref = " + object.name + "Ref<Real, Cursor>;");
  fields(out, record);
  out.close("};");
  out.line();
  aliases(out, object);
  out.line();
  proofs(out, record);
}

}  // namespace physgen::emit
