// Copies between fields of any two formats compute as kernels do, in the wider precision of the two arrays: one source
// for host and CUDA memory.
#pragma once

#include <cmath>

#include "test_objects.h"

namespace physgen::test {

template <class Format>
struct PositionsIn : elasticity::NodePositionFormats<Host> {
  using x = Format;
};
template <class Real, class Space, class Layout, class Format>
using PositionsArray = Array<elasticity::NodePositionObject, Real, Space, Layout, PositionsIn<Format>>;

/// Numbers whose distance from 300 or 1000 is stored, in 4 or 2 bytes, finer than a float near them can be.
using FloatAround300 = format::Scaled<format::Float32, format::Affine{.centre = 300}>;
using HalfAround300 = format::Scaled<format::Half<>, format::Affine{.centre = 300}>;
using Fine = format::Snorm16<format::Interval{300, 300.001}>;

/// The format itself, as it is stored in an array of Real: Native holds what is computed with.
template <class Format, class Real>
using FixedFormat =
    std::conditional_t<std::is_same_v<Format, format::Native>,
                       std::conditional_t<std::is_same_v<Real, double>, format::Float64, format::Float32>, Format>;

/// Stores numbers from 300 to 300.001 as From, copies them in Space, and finds what the formats' own functions make of
/// them.
template <class Space, class From, class RealFrom, class To, class RealTo>
void check_precision_of_copy(index_t n) {
  using Wider = std::conditional_t<std::is_same_v<RealFrom, RealTo>, RealTo, double>;
  using Source = FixedFormat<From, RealFrom>;
  using Target = FixedFormat<To, RealTo>;
  using SourceStored = typename Source::template Stored<RealFrom>;
  using TargetStored = typename Target::template Stored<RealTo>;
  std::mt19937 random(seed());
  std::uniform_real_distribution<double> exponent(-20, -10);
  PositionsArray<RealFrom, Host, Aos, From> source(n);
  for (index_t i = 0; i < n; ++i) {
    for (int k = 0; k < 3; ++k) source.putdata(i, k, 300 + std::exp2(exponent(random)));
  }
  PositionsArray<RealFrom, Space, Soa, From> from(n);
  PositionsArray<RealTo, Space, Aosoa<32>, To> to(n);
  PositionsArray<RealTo, Host, Aos, To> back(n);
  copy(from, source);
  copy(to, from);
  copy(back, to);
  synchronize();
  const auto* stored = reinterpret_cast<const SourceStored*>(source.untyped().base);
  const auto* copied = reinterpret_cast<const TargetStored*>(back.untyped().base);
  for (index_t k = 0; k < 3 * n; ++k) {
    TargetStored expected;
    if constexpr (std::is_same_v<Source, Target>) {
      expected = stored[k];
    } else {
      expected = Target::template encode<Wider>(Source::template decode<Wider>(stored[k]));
    }
    ASSERT_EQ(copied[k], expected) << From::name << " of " << sizeof(RealFrom) << " bytes, centre " << From::centre
                                   << ", to " << To::name << " of " << sizeof(RealTo) << ", centre " << To::centre;
  }
}

template <class Space, class From, class... To>
void check_copies_from(index_t n) {
  (check_precision_of_copy<Space, From, double, To, double>(n), ...);
  (check_precision_of_copy<Space, From, float, To, double>(n), ...);
  (check_precision_of_copy<Space, From, double, To, float>(n), ...);
  (check_precision_of_copy<Space, From, float, To, float>(n), ...);
}
template <class Space, class... Format>
void check_copies_between(index_t n) {
  (check_copies_from<Space, Format, Format...>(n), ...);
}

}  // namespace physgen::test
