// Must not compile: a format whose Stored has other bytes than its ElementType.
#include <elasticity.physgen.h>

struct Wrong : physgen::format::Float32 {
  template <class Real>
  static constexpr physgen::ElementType type = physgen::ElementType::half;
};
struct Formats : elasticity::NodePositionFormats<physgen::Host> {
  using x = Wrong;
};
physgen::Array<elasticity::NodePositionObject, float, physgen::Host, physgen::Soa, Formats> array(3);
