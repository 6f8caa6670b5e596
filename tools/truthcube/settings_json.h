// The settings of a run as text.
#pragma once

#include <string>

#include "options.h"

namespace physgen::truthcube {

/// The settings that a run that is continued must not change, as a JSON object.
[[nodiscard]] std::string settings_json(const Options& options);

}  // namespace physgen::truthcube
