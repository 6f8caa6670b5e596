// Schemas that rules object to, and what is said of them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "emit/cpp/rules.h"
#include "model/validate.h"
#include "models.h"

namespace physgen::test {

inline model::Field of(std::string name, model::Shape shape, int rows, int cols) {
  return field(std::move(name), shape, rows, cols);
}

/// A schema a.h with one object m::A of these fields.
inline model::Schema with(std::vector<model::Field> fields) {
  model::Schema made = schema({object("A", std::move(fields), "m")});
  made.file = "a.h";
  return made;
}

/// The field, stored so on the host.
inline model::Field stored_on_host(model::Field made, model::Encoding encoding, bool quaternion = false) {
  made.host_format = {encoding, quaternion};
  return made;
}

/// The messages of the model's rules and of the emitter's, one per line.
inline std::string issues(const model::Schema& schema) {
  std::string text;
  for (const auto& found : {model::validate(schema), emit::cpp::objections(schema)})
    for (const model::Issue& issue : found) text += (text.empty() ? "" : "\n") + issue.message;
  return text;
}

}  // namespace physgen::test
