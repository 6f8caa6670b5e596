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
  if (element == model::Element::boolean) return value != 0 ? "true" : "false";
  if (element == model::Element::uint64) return std::to_string(static_cast<unsigned long long>(value)) + "U";
  if (row.integer && value == -0x1p63) return "-9223372036854775807 - 1";  // the number without its sign is too large
  if (row.integer) return std::to_string(static_cast<long long>(value));
  if (element == model::Element::real) return "physgen::all_lanes<Real>(" + real(value) + ")";
  return real(value) + (row.bytes_with_double == 4 ? "f" : "");
}

std::string beginning(const model::Field& field) {
  return field.shape == model::Shape::rotation ? "Identity()" : "Zero()";
}

// What a member begins as: the value that the schema states, else 0, and rotations as the identity. Compilers drop what
// is overwritten. Nested objects have initializers of their own.
std::string initializer(const model::Field& field) {
  const bool scalar = field.shape == model::Shape::scalar;
  if (field.shape == model::Shape::object) return {};
  if (initial_in_value(field)) {
    const std::string value = literal(field.element, *field.initial);
    return " = " + (scalar ? value : "decltype(" + field.name + ")::Constant(" + value + ")");
  }
  return scalar ? " = {}" : " = decltype(" + field.name + ")::" + beginning(field);
}

// Eigen leaves entries of arrays as they are, so each is said; long arrays of matrices would cost more than they give.
void array_member(Printer& out, const model::Field& field, const std::string& type) {
  const std::string member = type + " " + field.name + "[" + std::to_string(field.array_extent) + "]";
  if (field.shape == model::Shape::scalar) return out.line(member + " = {};");
  if (field.shape == model::Shape::object || field.array_extent > longest_unrolled) return out.line(member + ";");
  const std::string entry = "std::remove_extent_t<decltype(" + field.name + ")>::" + beginning(field);
  out.filled(member + " = {", std::vector<std::string>(static_cast<std::size_t>(field.array_extent), entry), "};");
}

}  // namespace

void value_struct(Printer& out, const model::Object& object) {
  out.comment("///", object.doc.empty() ? "The value of one " + object.name + "." : object.doc);
  out.line("template <class Real>");
  out.open("struct " + object.name + " {");
  for (const model::Field& field : object.fields) {
    if (const std::string comment = field_comment(field); !comment.empty()) out.comment("///", comment);
    const std::string type = member_type(field, object);
    if (field.array_extent != 0) {
      array_member(out, field, type);
    } else {
      out.line(type + " " + field.name + initializer(field) + ";");
    }
  }
  out.close("};");
}

}  // namespace physgen::emit::cpp
