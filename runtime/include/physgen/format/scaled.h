// Numbers in another unit or around another zero than those that code computes with, in any stored type.
#pragma once

#include <physgen/detail/from_library.h>
#include <physgen/detail/rounding.h>
#include <physgen/format/native.h>
#include <physgen/format/nothing.h>

#include <type_traits>

namespace physgen::format {

/// A stored number means centre + scale * stored.
struct Affine {
  double scale = 1;
  double centre = 0;
};

/// Stored as Base stores (value - centre) / scale, with an error of scale times that of Base, and the rounding of the
/// subtraction. `Scaled<Float32, Affine{.scale = 1000}>` keeps thousands of a unit; `Scaled<Half<>, Affine{.centre =
/// 300}>` keeps temperatures around 300 K to 2^-11 of their distance from it.
/// @tparam Base_ Native, Float32, Float64, Half<> or Bfloat16
template <class Base_, Affine kOf>
struct Scaled {
  static_assert(FromLibrary<Base_> && !StoresNothing<Base_> && Base_::scale == 1 && Base_::centre == 0,
                "Scaled takes Native, Float32, Float64, Half<> or Bfloat16");
  static_assert(kOf.scale >= 0x1p-100 && kOf.scale <= 0x1p100, "numbers are scaled by 2^-100 to 2^100");
  static_assert(kOf.centre >= -0x1p126 && kOf.centre <= 0x1p126, "the centre is a number that float has");
  using Library = Scaled;
  using Base = Base_;
  static constexpr const char* name = "scaled";
  template <class Real>
  using Stored = typename Base::template Stored<Real>;
  template <class Real>
  static constexpr ElementType type = Base::template type<Real>;
  static constexpr double scale = kOf.scale, centre = kOf.centre;

  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static Real decode(Stored<Real> stored) {
    using Work = Computed<Real>;
    return static_cast<Real>(detail::to_scale<Work>(Base::template decode<Work>(stored), static_cast<Work>(scale),
                                                    static_cast<Work>(centre)));
  }
  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static Stored<Real> encode(Real value) {
    using Work = Computed<Real>;
    return Base::template encode<Work>(
        detail::from_scale<Work>(static_cast<Work>(value), scale, static_cast<Work>(centre), sizeof(Stored<Real>) > 2));
  }

 private:
  /// In double where that is stored, as copies do.
  template <class Real>
  using Computed = std::conditional_t<sizeof(Stored<Real>) == 8, double, Real>;
};

}  // namespace physgen::format
