// The usage of programs as a text for readers.
#pragma once

#include <string>

#include "usage/usage.h"

namespace physgen::usage {

/// A table for each step, and one of all of them: array, field, R where it is read, W where it is written, & where its
/// address is taken, and places.
[[nodiscard]] std::string table(const Program& program);

}  // namespace physgen::usage
