// The value struct: an aggregate of all fields of one object, or of the objects of a SIMD batch.
#include "emit/cpp/pieces.h"
#include "emit/cpp/text.h"

namespace physgen::emit::cpp {
namespace {

std::string member_type(const model::Field& field, const model::Object& user) {
  std::string element = value_type(field.element);
  const auto matrix = [&](int rows, int cols) {
    return "physgen::MatrixValue<" + element + ", " + std::to_string(rows) + ", " + std::to_string(cols) + ">";
  };
  if (field.shape == model::Shape::object) return nested_type_name(field, "", user) + "<Real>";
  if (field.shape == model::Shape::scalar) return element;
  return matrix(field.rows, model::facts(field.shape).column ? 1 : field.cols);
}

std::string literal(model::Element element, double value) {
  const model::ElementFacts& row = model::facts(element);
  if (row.integer) return std::to_string(static_cast<long long>(value));
  if (element == model::Element::real) return "physgen::all_lanes<Real>(" + real(value) + ")";
  return real(value) + (row.bytes_with_double == 4 ? "f" : "");
}

// Only where the schema states a value: an object that a kernel is about to fill costs nothing.
std::string initializer(const model::Field& field) {
  if (!initial_in_value(field)) return {};
  const std::string value = literal(field.element, *field.initial);
  return " = " +
         (field.shape == model::Shape::scalar ? value : "decltype(" + field.name + ")::Constant(" + value + ")");
}

}  // namespace

void value_struct(Printer& out, const model::Object& object) {
  out.comment("///", object.doc.empty() ? "The value of one " + object.name + "." : object.doc);
  out.line("template <class Real>");
  out.open("struct " + object.name + " {");
  for (const model::Field& field : object.fields) {
    if (const std::string comment = field_comment(field); !comment.empty()) out.comment("///", comment);
    const std::string type = member_type(field, object);
    const std::string extent = field.array_extent == 0 ? "" : "[" + std::to_string(field.array_extent) + "]";
    out.line(type + " " + field.name + extent + initializer(field) + ";");
  }
  out.close("};");
}

}  // namespace physgen::emit::cpp
