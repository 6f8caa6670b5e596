// Accessor classes as C++ text, from a model. One piece of the text per file: value.cpp, formats.cpp, record.cpp,
// ref.cpp and object.cpp.
#pragma once

#include <string>
#include <string_view>

#include "model/model.h"

namespace physgen::emit::cpp {

/// The runtime that generated code is written for: PHYSGEN_RUNTIME_VERSION of its <physgen/config.h>.
inline constexpr int runtime_version = 7;

/// Generated headers end with it.
inline constexpr std::string_view ending = ".physgen.h";

/// The text of the header with the accessor classes of all objects of `schema`. It depends on the runtime and on the
/// headers of imported objects. Several targets may generate one schema, and a program include all their headers.
/// @pre, @throws as Emitter::emit
[[nodiscard]] std::string accessor_header(const model::Schema& schema);

}  // namespace physgen::emit::cpp
