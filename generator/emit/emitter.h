// Accessor classes as C++ text, from a model. One piece of the text per file: value.cpp, record.cpp, ref.cpp,
// object.cpp.
#pragma once

#include <string>

#include "model/model.h"

namespace physgen::emit {

/// The runtime that generated code is written for: PHYSGEN_RUNTIME_VERSION of its <physgen/config.h>.
inline constexpr int runtime_version = 4;

/// The text of the header with the accessor classes of all objects of `schema`; the same text for the same schema,
/// whatever the machine and the time, so that several targets may generate one schema. It depends on the runtime and on
/// the headers of imported objects.
/// @pre validate(schema) has no objection
/// @throws std::logic_error when a planned record does not pass its proof (a defect of physgen)
[[nodiscard]] std::string accessor_header(const model::Schema& schema);

}  // namespace physgen::emit
