// The model as JSON, for other tools and for looking at: only what differs from a default is written.
#pragma once

#include <string>

#include "model/model.h"

namespace physgen::model {

/// Indented JSON, the same bytes for the same model. Text that is not UTF-8 is replaced by U+FFFD.
[[nodiscard]] std::string to_json(const Schema& schema);

}  // namespace physgen::model
