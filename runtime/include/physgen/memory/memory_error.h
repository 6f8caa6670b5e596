// The error of memory that cannot be had, for programs that say what they were doing.
#pragma once

#include <physgen/error.h>

namespace physgen {

/// Says what was to be allocated, how many bytes, and why they cannot be had.
class MemoryError : public Error {
 public:
  using Error::Error;
};

}  // namespace physgen
