// The source of a Python module, as C++ text, from a model: a class for each object type, whose arrays NumPy sees. All
// that is done there is written once, in <physgen/python/module.h> of the runtime.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/issue.h"
#include "model/model.h"

namespace physgen::emit::python {

/// Names of sources end with it.
inline constexpr std::string_view ending = ".python.cpp";

/// The text of the source of the module, which needs the header that emit::cpp writes of the same schema.
/// @pre, @throws as Emitter::emit
[[nodiscard]] std::string module_source(const model::Schema& schema);

/// What keeps a schema from becoming accessor classes, or a module: its file name, two classes of one name.
[[nodiscard]] std::vector<model::Issue> objections(const model::Schema& schema);

}  // namespace physgen::emit::python
