// What the commands of physgen return: see command.h.
#pragma once

namespace physgen::command {

inline constexpr int done = 0;
inline constexpr int errors = 1;     ///< in what was read, which are printed
inline constexpr int wrong_use = 2;  ///< of arguments, or of a file that cannot be read or written

}  // namespace physgen::command
