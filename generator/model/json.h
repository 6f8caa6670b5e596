// The model as JSON, for other tools and for looking at: only what differs from a default is written.
#pragma once

#include <string>

#include "model/model.h"

namespace physgen::model {

/// Indented JSON, the same bytes for the same model. Text that is not UTF-8 is replaced by U+FFFD.
[[nodiscard]] std::string to_json(const Schema& schema);

/// Reads what to_json writes; from_json(to_json(s)) == s.
/// @throws std::invalid_argument naming the place ("objects[0].fields[2].shape: ...") of what is not JSON, missing,
///         unknown or of the wrong type, and listing every rule of validate() that the model breaks.
[[nodiscard]] Schema from_json(const std::string& text);

}  // namespace physgen::model
