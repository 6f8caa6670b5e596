// A schema whose objects state layouts, or none, and nest each other: one_layout_test.cpp has them all in one layout.
#pragma once
#include <physgen/schema.h>

namespace particles {
using namespace physgen::schema;

struct PHYSGEN_OBJECT() Spin {
  Rotation R;
  PHYSGEN(unit("1/s")) Vector<3> rate;
};

struct PHYSGEN_OBJECT(layout(host, soa), layout(cuda, aos_padded)) Particle {
  PHYSGEN(unit("m")) Vector<3> x;
  Spin spins[2];
  Index kind;
};
}  // namespace particles
