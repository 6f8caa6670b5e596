// Models built by hand, for tests of the back half of the generator: no schema is parsed.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "model/model.h"
#include "plan/plan.h"

namespace physgen::test {

/// Finds the records of nested objects for a plan, where there are none.
inline const plan::Record& no_objects(const std::string& name) { throw std::invalid_argument(name); }

inline model::Field field(std::string name, model::Shape shape = model::Shape::scalar, int rows = 1, int cols = 1,
                          model::Element element = model::Element::real) {
  model::Field made;
  made.name = std::move(name);
  made.shape = shape;
  made.rows = rows;
  made.cols = cols;
  made.element = element;
  return made;
}

inline model::Field scalar(std::string name, model::Element element = model::Element::real) {
  return field(std::move(name), model::Shape::scalar, 1, 1, element);
}

inline model::Field nested(std::string name, std::string object) {
  model::Field made = field(std::move(name), model::Shape::object);
  made.object = std::move(object);
  return made;
}

inline model::Field array(model::Field entry, int extent) {
  entry.array_extent = extent;
  return entry;
}

/// The field, stored so in both memory spaces.
inline model::Field stored(model::Field made, model::Encoding encoding, bool quaternion = false) {
  made.host_format = made.cuda_format = {encoding, quaternion};
  return made;
}

/// The field, stored so in CUDA memory, and as computed on the host.
inline model::Field stored_on_cuda(model::Field made, model::Encoding encoding, bool quaternion = false) {
  made.cuda_format = {encoding, quaternion};
  return made;
}

inline model::Field rotation(std::string name) { return field(std::move(name), model::Shape::rotation, 3, 3); }

inline model::Object object(std::string name, std::vector<model::Field> fields, std::string scope = "test") {
  model::Object made;
  made.name = std::move(name);
  made.scope = std::move(scope);
  made.fields = std::move(fields);
  return made;
}

inline model::Schema schema(std::vector<model::Object> objects) {
  model::Schema made;
  made.file = "test.h";
  made.objects = std::move(objects);
  return made;
}

}  // namespace physgen::test
