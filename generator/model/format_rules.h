// The rules about how a field is stored.
#pragma once

#include <functional>
#include <string>

#include "model/issue.h"
#include "model/model.h"

namespace physgen::model {

/// Is told of each broken rule about a field.
using FieldReport = std::function<void(Aspect, std::string message)>;

/// Reports what is wrong with one of the formats of `field`.
/// @param aspect of the format: host_format or cuda_format
void check_format(Aspect aspect, const Field& field, const Format& format, const FieldReport& report);

}  // namespace physgen::model
