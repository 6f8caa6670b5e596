// Formats of a program's own, for all ways in which elements are stored and read; and the library's that scale.
#pragma once

#include <cmath>

#include "test_objects.h"

namespace physgen::test {

/// Keeps thousandths of what is computed with.
struct Thousandths {
  static constexpr const char* name = "thousandths";
  template <class Real>
  using Stored = float;
  template <class Real>
  static constexpr ElementType type = ElementType::float32;
  static constexpr double scale = 1000, centre = 0;
  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static Real decode(float stored) {
    return static_cast<Real>(stored) * Real(1000);
  }
  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static float encode(Real value) {
    return static_cast<float>(value / Real(1000));
  }
};

/// A half of the distance from 300.
struct Around300 {
  static constexpr const char* name = "around_300";
  template <class Real>
  using Stored = std::uint16_t;
  template <class Real>
  static constexpr ElementType type = ElementType::half;
  static constexpr double scale = 1, centre = 300;
  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static Real decode(std::uint16_t stored) {
    return format::Half<>::decode<Real>(stored) + Real(300);
  }
  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static std::uint16_t encode(Real value) {
    return format::Half<>::encode<Real>(value - Real(300));
  }
};

/// The square root, in the very type that is computed with.
struct Rooted {
  static constexpr const char* name = "rooted";
  template <class Real>
  using Stored = Real;
  template <class Real>
  static constexpr ElementType type = element_type<Real>;
  static constexpr double scale = 1, centre = 0;
  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static Real decode(Real stored) {
    return stored * stored;
  }
  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static Real encode(Real value) {
    return std::sqrt(value);
  }
};

/// Zero bytes stand for 1.
struct FromOne {
  static constexpr const char* name = "from_one";
  template <class Real>
  using Stored = float;
  template <class Real>
  static constexpr ElementType type = ElementType::float32;
  static constexpr double scale = 1, centre = 0;
  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static Real decode(float stored) {
    return static_cast<Real>(stored) + Real(1);
  }
  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static float encode(Real value) {
    return static_cast<float>(value - Real(1));
  }
};

/// The library's bfloat16 by another name is a format of the program's own, and means the same.
struct DerivedBfloat : format::Bfloat16 {
  static constexpr const char* name = "derived";
};

struct OwnDerivative : elasticity::StressDerivativeFormats<Host> {
  using x1111 = Thousandths;
  using x2211 = Around300;
  using x3311 = Rooted;
  using x2222 = FromOne;
  using x3322 = DerivedBfloat;
  using x3333 = format::Scaled<format::Native, format::Affine{.scale = 1000, .centre = -7}>;
  using x2121 = format::Scaled<format::Half<>, format::Affine{.scale = 0.3, .centre = 300}>;
  using x2112 = format::Scaled<format::Half<>, format::Affine{.scale = 0.3}>;
  using x3131 = format::Scaled<format::Bfloat16, format::Affine{.scale = 3, .centre = 290}>;
  using x3113 = format::Scaled<format::Float64, format::Affine{.scale = 1e-3, .centre = 300}>;
  using x3232 = format::Snorm16<format::Interval{0, 2e-35}>;
};
/// The elements that the device converts, too.
struct ScaledDerivative : OwnDerivative {
  using x1111 = format::Native;
  using x2211 = format::Native;
  using x3311 = format::Native;
  using x2222 = format::Native;
  using x3322 = format::Native;
};

/// Random numbers that suit element k of OwnDerivative, and the error that they are kept with.
inline double own_value(int k, std::mt19937& random) {
  const double value = std::uniform_real_distribution<double>(280, 320)(random);
  return k == 10 ? (value - 280) * 5e-37 : value;
}
inline double own_error(int k) {
  switch (k) {
    case 1:
      return 20 * 0x1p-11 + 1e-4;
    case 4:
      return 320 * 0x1p-8;
    case 6:
      return 20 * 0x1p-11 + 1e-4;
    case 7:
      return 320 * 0x1p-11 + 1e-4;
    case 8:
      return 30 * 0x1p-8 + 1e-4;
    case 10:
      return 2e-35 / 131068 + 2e-42;
    default:
      return 320 * 0x1p-21;
  }
}

using OwnObject = elasticity::StressDerivativeObject;

/// All elements of all objects as they are stored.
template <class Array>
std::vector<std::vector<std::byte>> stored_elements(const Array& array) {
  using Same = physgen::Array<typename Array::Object, typename Array::Precision, Host, Aos, typename Array::Formats>;
  Same records(array.size());
  copy(records, array);
  synchronize();
  const UntypedArray untyped = records.untyped();
  std::vector<std::vector<std::byte>> result;
  for (index_t i = 0; i < untyped.size; ++i) {
    const std::byte* record = untyped.base + i * untyped.record_bytes;
    result.emplace_back(record, record + untyped.record_bytes);
  }
  return result;
}

/// To another space and back: the bits are those of a conversion on the host.
template <class Space, class Layout, class Formats>
void check_own_formats_elsewhere(index_t n) {
  std::mt19937 random(seed());
  elasticity::StressDerivativeArray<float, Host, Aos> source(n), back(n);
  for (index_t i = 0; i < n; ++i) {
    for (int k = 0; k < source.elements; ++k) source.putdata(i, k, own_value(k, random));
  }
  Array<OwnObject, float, Host, Aos, Formats> expected(n);
  Array<OwnObject, float, Space, Layout, Formats> there(n), from_pinned(n), from_own(n);
  if (n > 1) {
    EXPECT_EQ(there.getdata(n - 1, 1), expected.getdata(n - 1, 1)) << "initial values";
    EXPECT_EQ(there.getdata(n - 1, 3), expected.getdata(n - 1, 3)) << "initial values";
  }
  copy(expected, source);
  copy(there, source);
  copy(from_own, expected);
  elasticity::StressDerivativeArray<float, PinnedHost, Soa> pinned(n), pinned_back(n);
  copy(pinned, source);
  copy(from_pinned, pinned);
  EXPECT_EQ(stored_elements(there), stored_elements(expected));
  EXPECT_EQ(stored_elements(from_pinned), stored_elements(expected));
  EXPECT_EQ(stored_elements(from_own), stored_elements(expected));
  elasticity::StressDerivativeArray<float, Host, Aos> wanted(n), of_pinned(n);
  copy(wanted, expected);
  copy(back, there);
  copy(pinned_back, there);
  copy(of_pinned, pinned_back);
  synchronize();
  EXPECT_EQ(count_different(back, wanted), 0);
  EXPECT_EQ(count_different(of_pinned, wanted), 0);
  for (int k = 0; n > 0 && k < source.elements; ++k)
    EXPECT_EQ(there.getdata(n / 2, k), expected.getdata(n / 2, k)) << k;
}

}  // namespace physgen::test
