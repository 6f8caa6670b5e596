// The record: of each field its shape, format and type, from which the runtime computes where it lies. object.cpp
// prints the numbers that this must give for the schema's own formats.
#include "emit/cpp/pieces.h"
#include "emit/cpp/text.h"

namespace physgen::emit::cpp {

void record_struct(Printer& out, const model::Object& object) {
  const std::string name = object.name + "Record";
  out.line("template <class Real, class Formats>");
  out.open("struct " + name + " {");
  std::vector<std::string> names;
  for (const model::Field& field : object.fields) {
    const bool nested = field.shape == model::Shape::object;
    std::vector<std::string> arguments{
        name, std::to_string(names.size()),
        nested ? nested_type_name(field, "Object", object) : "physgen::shape::" + schema_type(field),
        "typename Formats::" + field.name, nested ? "Real" : stored_type(field.element)};
    if (field.array_extent != 0) arguments.push_back(std::to_string(field.array_extent));
    out.filled("using " + field.name + " = physgen::" + (nested ? "NestedField<" : "StoredField<"), arguments, ">;");
    names.push_back(field.name);
  }
  if (object.alignment != 0) names.insert(names.begin(), std::to_string(object.alignment));
  out.filled(
      std::string("using fields_ = physgen::") + (object.alignment == 0 ? "RecordFields<" : "AlignedRecordFields<"),
      names, ">;");
  out.close("};");
}

}  // namespace physgen::emit::cpp
