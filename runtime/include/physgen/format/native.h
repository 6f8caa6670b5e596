// Elements stored as float or double. Where that is the type computed with, memory holds the very numbers, and
// references to them are plain C++ references.
#pragma once

#include <physgen/format/element_type.h>

namespace physgen::format {

/// Stored as it is computed: in the precision of the scene.
struct Native {
  using Library = Native;
  static constexpr const char* name = "native";
  template <class Real>
  using Stored = Real;
  template <class Real>
  static constexpr ElementType type = element_type<Real>;
  static constexpr double scale = 1, centre = 0;

  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static Real decode(Real stored) {
    return stored;
  }
  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static Real encode(Real value) {
    return value;
  }
};

namespace detail {

/// Stored as T, whatever the precision of the scene.
template <class T>
struct Floating {
  template <class Real>
  using Stored = T;
  template <class Real>
  static constexpr ElementType type = element_type<T>;
  static constexpr double scale = 1, centre = 0;

  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static Real decode(T stored) {
    return static_cast<Real>(stored);
  }
  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static T encode(Real value) {
    return static_cast<T>(value);
  }
};

}  // namespace detail

/// Whether a field of integers may have this format: they are indices, which no format may round.
template <class Format>
inline constexpr bool holds_indices = std::is_same_v<Format, Native>;

/// IEEE single precision: relative error <= 2^-24 for magnitudes from 1.2e-38 to 3.4e38.
struct Float32 : detail::Floating<float> {
  using Library = Float32;
  static constexpr const char* name = "float32";
};

/// IEEE double precision.
struct Float64 : detail::Floating<double> {
  using Library = Float64;
  static constexpr const char* name = "float64";
};

}  // namespace physgen::format
