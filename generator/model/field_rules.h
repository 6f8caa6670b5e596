// The rules about one field by itself: sizes of its type, and its options.
#pragma once

#include "model/format_rules.h"
#include "model/model.h"

namespace physgen::model {

/// Reports what is wrong with the type and the options of `field`, but not with its name, extent and nested object.
/// @return whether it is not a nested object and element_count() makes sense
bool check_field(const Field& field, const FieldReport& report);

}  // namespace physgen::model
