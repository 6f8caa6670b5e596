// The record: where each field begins, computed from the formats when it is compiled. object.cpp prints the numbers
// that this must give for the schema's own formats.
#include "emit/pieces.h"
#include "emit/text.h"

namespace physgen::emit {
namespace {

std::string slot(const model::Field& field, const model::Object& object) {
  const std::string entries = field.array_extent == 0 ? "" : std::to_string(field.array_extent);
  if (field.shape == model::Shape::object) {
    return "physgen::nested_slot<" + nested_type_name(field, "Record", object) +
           "<Real, typename Formats::" + field.name + ">>(" + entries + ")";
  }
  return "physgen::slot<" + stored_as(field) + ">(" + entries + ")";
}

}  // namespace

void record_struct(Printer& out, const plan::Record& record) {
  const model::Object& object = *record.object;
  out.line("/// Where each field begins in the record of one " + object.name + " [bytes].");
  out.line("template <class Real, class Formats>");
  out.open("struct " + object.name + "Record {");
  out.open("static constexpr auto plan_ = physgen::plan_record<" + std::to_string(object.fields.size()) + ">({{");
  for (const model::Field& field : object.fields) out.line(slot(field, object) + ",");
  out.close("}});");
  for (std::size_t f = 0; f < object.fields.size(); ++f) {
    out.line("static constexpr int " + object.fields[f].name + " = plan_.offset[" + std::to_string(f) + "];");
  }
  out.line("static constexpr int bytes = plan_.bytes;");
  const std::string asked = std::to_string(object.alignment);
  out.line("static constexpr int alignment = " +
           (object.alignment == 0 ? "plan_.alignment;"
                                  : "plan_.alignment > " + asked + " ? plan_.alignment : " + asked + ";"));
  out.close("};");
}

}  // namespace physgen::emit
