// What a case chooses of a run, and the flags that it takes the place of.
#pragma once

#include <functional>
#include <string>

#include "options.h"

namespace physgen::truthcube {

/// Reads options.case_file, and makes the choices that it stands for.
/// @param given whether a flag, such as "--young", stands in the command line
/// @throw Error when one does that a case has no use for, or as read_case()
void apply_case(Options& options, const std::function<bool(const std::string&)>& given);

}  // namespace physgen::truthcube
