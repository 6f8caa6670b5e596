// The formats: how each field is stored in each memory space, as types that a program can replace one by one.
#include "emit/pieces.h"
#include "emit/text.h"

namespace physgen::emit {

void formats_struct(Printer& out, const model::Object& object) {
  const std::string name = object.name + "Formats";
  out.comment("///", "How the fields of one " + object.name +
                         " are stored in a memory space. To store some otherwise, derive from it, declare those anew, "
                         "and name the derived struct as the last argument of " +
                         object.name + "Array.");
  out.line("template <class Space>");
  out.open("struct " + name + " {");
  for (const model::Field& field : object.fields) {
    if (!has_format(field)) continue;
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

}  // namespace physgen::emit
