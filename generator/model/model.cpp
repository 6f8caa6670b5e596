// See model.h.
#include "model/model.h"

#include <stdexcept>

namespace physgen::model {

int element_count(const Field& field) {
  const ShapeFacts& shape = facts(field.shape);
  if (shape.count == nullptr)
    throw std::invalid_argument("element_count: field '" + field.name + "' is a nested object");
  return shape.count(field.rows, field.cols);
}

std::string schema_type(const Field& field) {
  const ShapeFacts& shape = facts(field.shape);
  if (field.shape == Shape::object) return field.object;
  std::string type(shape.type);
  if (shape.sides == Sides::fixed) return type;
  type += "<" + std::to_string(field.rows);
  if (shape.sides == Sides::any) type += ", " + std::to_string(field.cols);
  return type + ">";
}

}  // namespace physgen::model
