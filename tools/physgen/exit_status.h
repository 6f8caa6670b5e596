// What the commands of physgen return: see command.h.
#pragma once

namespace physgen::command {

inline constexpr int done = 0, errors = 1, wrong_use = 2;

}  // namespace physgen::command
