// The value struct: an aggregate of all fields of one object, or of the objects of a SIMD batch.
#include "emit/pieces.h"
#include "emit/text.h"

namespace physgen::emit {
namespace {

std::string member_type(const model::Field& field, const plan::Slot& slot, const model::Object& user) {
  std::string element = value_type(field.element);
  const auto matrix = [&](int rows, int cols) {
    return "Eigen::Matrix<" + element + ", " + std::to_string(rows) + ", " + std::to_string(cols) + ">";
  };
  if (field.shape == model::Shape::object) return type_name(*slot.nested->object, "", user) + "<Real>";
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

void value_struct(Printer& out, const plan::Record& record) {
  const model::Object& object = *record.object;
  out.comment("///", object.doc.empty() ? "The value of one " + object.name + "." : object.doc);
  out.line("/// @tparam Real float, double, or a SIMD batch of one of them");
  out.line("template <class Real>");
  out.open("struct " + object.name + " {");
  for (std::size_t f = 0; f < object.fields.size(); ++f) {
    const model::Field& field = object.fields[f];
    if (const std::string comment = field_comment(field); !comment.empty()) out.comment("///", comment);
    const std::string type = member_type(field, record.slots[f], object);
    const std::string extent = field.array_extent == 0 ? "" : "[" + std::to_string(field.array_extent) + "]";
    out.line(type + " " + field.name + extent + initializer(field) + ";");
  }
  out.close("};");
}

}  // namespace physgen::emit
