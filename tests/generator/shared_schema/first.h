// Nests an object of an included schema.
#pragma once
#include "base.h"

namespace shared {
struct PHYSGEN_OBJECT() First {
  Base base;
};
}  // namespace shared
