// What the model knows by itself: the element counts of shapes and the names of generated headers.
#include "model/model.h"

#include <stdexcept>

namespace physgen::model {

int element_count(const Field& field) {
  const ShapeFacts& shape = facts(field.shape);
  if (shape.count == nullptr)
    throw std::invalid_argument("element_count: field '" + field.name + "' is a nested object");
  return shape.count(field.rows, field.cols);
}

std::string generated_header(const std::string& schema_file) {
  const std::string name = schema_file.substr(schema_file.find_last_of('/') + 1);
  const auto dot = name.find_last_of('.');
  return (dot == std::string::npos || dot == 0 ? name : name.substr(0, dot)) + ".physgen.h";
}

}  // namespace physgen::model
