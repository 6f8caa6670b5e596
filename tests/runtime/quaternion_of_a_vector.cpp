// Does not compile: a vector is no rotation.
#include <elasticity.physgen.h>

struct Wrong : elasticity::NodePositionFormats<physgen::Host> {
  using x = physgen::format::Quaternion16;
};
physgen::Array<elasticity::NodePositionObject, float, physgen::Host, physgen::Aos, Wrong> array(3);
