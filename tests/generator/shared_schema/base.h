// A schema that two others include.
#pragma once
#include <physgen/schema.h>

namespace shared {
using namespace physgen::schema;

struct PHYSGEN_OBJECT() Base {
  PHYSGEN(initial(0x1p64)) Scalar x;
};
}  // namespace shared
