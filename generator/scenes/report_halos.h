// The part of the need report that says which fields cross between ranks, and before which steps.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "scenes/halos.h"

namespace physgen::scenes {

/// The report's section, or nothing where no names are stated.
[[nodiscard]] std::string halos_text(const Halos& halos);

/// "body.positions.x crosses before ...": of one field, which steps make it cross. Nothing where no names are stated.
[[nodiscard]] std::string why_text(const Halos& halos, const std::string& array, const std::string& field);

/// "halos" of the report as JSON, where names are stated.
void add_halos(const Halos& halos, nlohmann::ordered_json& json);

}  // namespace physgen::scenes
