// The formats: how each field is stored in each memory space, as types that a program can replace one by one; and the
// formats that tell reads and writes of each field apart.
#include "emit/cpp/pieces.h"
#include "emit/cpp/text.h"

namespace physgen::emit::cpp {

void formats_struct(Printer& out, const model::Object& object) {
  const std::string name = object.name + "Formats";
  out.line("template <class Space>");
  out.open("struct " + name + " {");
  for (const model::Field& field : object.fields) {
    if (field.shape == model::Shape::object) {
      out.line("using " + field.name + " = " + nested_type_name(field, "Formats", object) + "<Space>;");
      continue;
    }
    const std::string host = format_type(field, model::Space::host), cuda = format_type(field, model::Space::cuda);
    out.list("using " + field.name + " = " + (host == cuda ? "" : "physgen::PerSpace<Space, "),
             host == cuda ? std::vector<std::string>{host} : std::vector<std::string>{host, cuda},
             host == cuda ? ";" : ">;");
  }
  out.close("};");
}

void probe_struct(Printer& out, const plan::Record& record) {
  const model::Object& object = *record.object;
  const std::string formats = object.name + "Formats", tag = object.name + "Object";
  const std::string array = local_name("ArrayTag", object), base = local_name("Base", object);
  const std::string outer = local_name("Object", object), first = local_name("first", object);
  out.line("struct " + tag + ";");
  out.list("template <",
           {"class " + array, "class " + base + " = " + formats + "<physgen::Host>", "class " + outer + " = " + tag,
            "int " + first + " = 0"},
           ">");
  out.open("struct " + object.name + "Probe {");
  out.line("using array_ = " + array + ";");
  int number = 0;
  for (std::size_t f = 0; f < object.fields.size(); ++f) {
    const model::Field& field = object.fields[f];
    const std::string at = first + " + " + std::to_string(number), of = "typename " + base + "::" + field.name;
    if (field.shape == model::Shape::object) {
      // Entries of a fixed array of objects share their formats: the numbers are those of the first.
      const int runs = static_cast<int>(plan::runs(*record.slots[f].nested).size());
      out.list("using " + field.name + " = " + nested_type_name(field, "Probe", object) + "<", {array, of, outer, at},
               ">;");
      number += runs * (field.array_extent == 0 ? 1 : field.array_extent);
    } else {
      out.list("using " + field.name + " = physgen::Probe<", {array, outer, at, of}, ">;");
      ++number;
    }
  }
  out.close("};");
}

}  // namespace physgen::emit::cpp
