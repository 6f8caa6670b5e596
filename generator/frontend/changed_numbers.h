// Finds numbers in options that C++ changes on their way into the option: divisions of integers that drop a remainder,
// and conversions that do not keep the value. A schema states constants, and a wrong one is seen nowhere else.
#pragma once

#include "frontend/report.h"

namespace physgen::frontend {

/// Reports each such place in the argument of an option, and in the constants that it names. Explicit casts are meant:
/// what stands in them is not looked at.
void report_changed_numbers(const clang::Expr& argument, Report& report);

}  // namespace physgen::frontend
