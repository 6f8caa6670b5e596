// The command physgen: it reads its arguments, parses the schemas, and only then writes.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace physgen::command {

/// Runs physgen with these arguments (without the program's name).
/// @return exit status: 0 done, 1 errors in a schema (nothing was written), 2 wrong use, or a file that cannot be
///         read or written
int run(std::vector<std::string> arguments, std::ostream& out, std::ostream& err);

}  // namespace physgen::command
