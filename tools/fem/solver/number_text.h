// Numbers in messages, as streams print them.
#pragma once

#include <sstream>
#include <string>

namespace physgen::fem {

/// "1.5e-09": six digits at most.
[[nodiscard]] inline std::string number_text(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

}  // namespace physgen::fem
