// A network of springs between points.
#pragma once

#include <physgen/schema.h>

#include "dimensions.h"

namespace network {
using namespace physgen::schema;

/// A spring between two points.
struct PHYSGEN_OBJECT(layout(host, aosoa(8))) Spring {
  PHYSGEN(unit("N/m")) Scalar stiffness;
  PHYSGEN(unit("m")) Scalar rest_length;
  double damping;                                ///< in double, whatever the scene
  PHYSGEN(unit("m")) Vector<dimensions> vector;  ///< from one end to the other
};
}  // namespace network
