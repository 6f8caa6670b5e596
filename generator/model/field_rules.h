// The rules about one field by itself: sizes of its type, and its options.
#pragma once

#include <functional>
#include <string>

#include "model/model.h"
#include "model/validate.h"

namespace physgen::model {

/// Is told of each broken rule.
using FieldReport = std::function<void(Aspect, std::string message)>;

/// Reports what is wrong with the type and the options of `field`, but not with its name, extent and nested object.
/// @return whether it is no nested object and element_count() makes sense
bool check_field(const Field& field, const FieldReport& report);

}  // namespace physgen::model
