// Storage schemes: which formats the arrays of dP from dF are kept in, from exact to small, and what they take. Speed
// against error is measured over them.
#pragma once

#include <elasticity.physgen.h>

#include "kernels/dp_from_df.h"

namespace physgen::bench {

namespace detail {

/// Formats of the object types that a scheme changes: U, V of the SVD, the entries of the stress derivative, dF and dP.
template <class Rotation, class Entry, class Differential, class Result>
struct DpFormats {
  struct Svd : elasticity::DeformationSvdFormats<Host> {
    using U = Rotation;
    using V = Rotation;
  };
  struct Derivative : elasticity::StressDerivativeFormats<Host> {
    using x1111 = Entry;
    using x2211 = Entry;
    using x3311 = Entry;
    using x2222 = Entry;
    using x3322 = Entry;
    using x3333 = Entry;
    using x2121 = Entry;
    using x2112 = Entry;
    using x3131 = Entry;
    using x3113 = Entry;
    using x3232 = Entry;
    using x3223 = Entry;
  };
  struct DeformationDifferential : elasticity::DeformationGradientDifferentialFormats<Host> {
    using dF = Differential;
  };
  struct StressDifferential : elasticity::StressDifferentialFormats<Host> {
    using dP = Result;
  };

  template <class Object>
  struct Of;
  template <class Object, class Space>
  using Formats = typename Of<Object>::type;
};
template <class R, class E, class D, class P>
template <class Object>
struct DpFormats<R, E, D, P>::Of {
  using type = std::conditional_t<
      std::is_same_v<Object, elasticity::DeformationSvdObject>, Svd,
      std::conditional_t<std::is_same_v<Object, elasticity::StressDerivativeObject>, Derivative,
                         std::conditional_t<std::is_same_v<Object, elasticity::DeformationGradientDifferentialObject>,
                                            DeformationDifferential, StressDifferential>>>;
};

}  // namespace detail

// Entries of the derivative reach 1e6 Pa in this scene, differentials of F 1e-2: halves are scaled to suit.
using HalfEntry = format::Half<5>;
using HalfDifferential = format::Half<-6>;
using HalfResult = format::Half<0>;

namespace scheme {

template <class Rotation, class Entry, class Differential, class Result>
using Formats = detail::DpFormats<Rotation, Entry, Differential, Result>;
using format::Bfloat16, format::Native, format::Quaternion, format::Quaternion16;

/// Rotations as quaternions of floats, all else as computed.
struct QuaternionFloat : Formats<Quaternion<>, Native, Native, Native> {
  static constexpr const char* name = "quaternion";
};
struct Quaternion16Float : Formats<Quaternion16, Native, Native, Native> {
  static constexpr const char* name = "quaternion16";
};
struct HalfDerivative : Formats<Native, HalfEntry, Native, Native> {
  static constexpr const char* name = "half_derivative";
};
struct Bfloat16Derivative : Formats<Native, Bfloat16, Native, Native> {
  static constexpr const char* name = "bfloat16_derivative";
};
struct QuaternionHalf : Formats<Quaternion<>, HalfEntry, Native, Native> {
  static constexpr const char* name = "quaternion_half";
};
struct Quaternion16Half : Formats<Quaternion16, HalfEntry, Native, Native> {
  static constexpr const char* name = "quaternion16_half";
};
/// Everything in 16 bits.
struct AllHalf : Formats<Quaternion16, HalfEntry, HalfDifferential, HalfResult> {
  static constexpr const char* name = "quaternion16_all_half";
};
struct MatricesHalf : Formats<format::Half<>, HalfEntry, HalfDifferential, HalfResult> {
  static constexpr const char* name = "all_half";
};
struct AllBfloat16 : Formats<Quaternion<Bfloat16>, Bfloat16, Bfloat16, Bfloat16> {
  static constexpr const char* name = "all_bfloat16";
};

}  // namespace scheme

template <class... Scheme>
struct SchemeList {
  template <class Visit>
  static void for_each(const Visit& visit) {
    (visit.template operator()<Scheme>(), ...);
  }
};
using AllSchemes = SchemeList<scheme::QuaternionFloat, scheme::Quaternion16Float, scheme::HalfDerivative,
                              scheme::Bfloat16Derivative, scheme::QuaternionHalf, scheme::Quaternion16Half,
                              scheme::AllHalf, scheme::MatricesHalf, scheme::AllBfloat16>;

/// The arrays that dP from dF reads, in records of whole elements, rounded; dP is NaN.
void load_records(Scene& scene, elasticity::ElementRecordArray<float>& records);

}  // namespace physgen::bench
