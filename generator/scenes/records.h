// Reads with Clang how many bytes a record of each array takes, as the compiler lays it out: with the fields that are
// needed and with all of them, in the layouts that the schemas choose.
#pragma once

#include "scenes/needs.h"

namespace clang {
class ASTContext;
}

namespace physgen::scenes {

/// The records of a scene's arrays, in order of declaration.
using Records = std::vector<std::vector<Record>>;

/// @param context of probe_unit() and rest_of_unit(), without errors
[[nodiscard]] Records read_records(clang::ASTContext& context);

/// Fills ArrayNeed::records. @pre the records are those of the needs' arrays, or there are none
void add_records(const Records& records, Needs& needs);

}  // namespace physgen::scenes
