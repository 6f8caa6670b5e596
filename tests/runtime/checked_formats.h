// Formats that lose, for the tests of checked builds on host and device.
#pragma once

#include "test_objects.h"

namespace physgen::test {

struct Coarse : elasticity::StressDerivativeFormats<Host> {
  using x1111 = format::Half<>;
  using x2211 = format::Snorm16<format::Interval{-1.0, 1.0}>;
};
struct QuaternionRotations : elasticity::DeformationSvdFormats<Host> {
  using U = format::Quaternion<>;
};
struct HalfQuaternions : elasticity::DeformationSvdFormats<Host> {
  using U = format::Quaternion<format::Half<>>;
};

}  // namespace physgen::test
