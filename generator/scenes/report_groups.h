// The part of the need report about groups: which steps are one, and why others are not.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "scenes/needs.h"

namespace physgen::scenes {

/// With an empty line before it; empty where the program has no neighbouring steps and none that are not looked at.
[[nodiscard]] std::string groups_text(const Scene& scene, const Needs& needs);

/// Adds "groups", "apart" and "not_joined".
void add_groups(const Needs& needs, nlohmann::ordered_json& json);

}  // namespace physgen::scenes
