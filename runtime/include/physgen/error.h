// The one exception type of the runtime.
#pragma once

#include <stdexcept>
#include <string>

namespace physgen {

/// Thrown by every operation of the runtime that cannot be done. what() says what was asked, the object type, the sizes
/// and, where CUDA refused, its message. The failed operation leaves its arrays as they were; only where CUDA fails in
/// the middle of a transfer into an array can some of its objects be new.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& what) : std::runtime_error("physgen: " + what) {}
};

}  // namespace physgen
