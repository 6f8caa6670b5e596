// The schema that everything.h includes.
#pragma once

#include <physgen/schema.h>

namespace material {
using namespace physgen::schema;

/// Elastic constants.
struct PHYSGEN_OBJECT() Lame {
  /// Shear modulus.
  PHYSGEN(unit("Pa")) Scalar mu;
  PHYSGEN(unit("Pa")) Scalar lambda;
};

/// One family of fibres.
struct PHYSGEN_OBJECT() Fibre {
  /// Unit vector along the fibre.
  Vector<3, float> direction;
  PHYSGEN(unit("Pa")) double strength;
};

}  // namespace material
