// Rotations stored as unit quaternions w, x, y, z, each component in a format of its own: 4 elements instead of 9.
#pragma once

#include <physgen/detail/from_library.h>
#include <physgen/format/native.h>
#include <physgen/format/nothing.h>
#include <physgen/format/snorm16.h>
#include <physgen/kernels/quaternion.h>

namespace physgen::format {

/// @tparam Component_ how each of the four is stored: Native, Float32, Half<>, Snorm16<Interval{-1, 1}>, ...
/// Error of an entry of the matrix: 1.2e-6 for components in float, 2e-3 in half, 9e-5 in 16-bit steps. The matrix that
/// is read is orthogonal to a few eps whatever the component's format, since a quaternion is made one of length 1
/// again.
template <class Component_ = Native>
struct Quaternion {
  static_assert(!StoresNothing<Component_>, "a rotation is pruned as a whole: its format is Nothing or Pruned itself");
  static constexpr const char* name = "quaternion";
  using Component = Component_;
};

/// Components in 16-bit steps.
using Quaternion16 = Quaternion<Snorm16<Interval{-1.0, 1.0}>>;

template <class Format>
inline constexpr bool is_quaternion = false;
template <class Component>
inline constexpr bool is_quaternion<Quaternion<Component>> = true;

namespace detail {

/// The format of the elements of a field of this format.
template <class Format>
struct ElementFormat {
  using type = Format;
};
template <class Component>
struct ElementFormat<Quaternion<Component>> {
  using type = Component;
};

}  // namespace detail

/// The format of single elements: of the components, where a field is a quaternion.
template <class Format>
using ElementFormat = typename detail::ElementFormat<Format>::type;

/// Whether memory holds the very numbers of type Real that code computes with: of the library's formats alone, since
/// what functions of a program's own do to a number cannot be seen from its type.
template <class Format, class Real>
inline constexpr bool is_plain = false;
template <class Format, class Real>
  requires(!is_quaternion<Format>)
inline constexpr bool is_plain<Format, Real> =
    FromLibrary<Format> && std::is_same_v<typename Format::template Stored<Real>, Real> && Format::scale == 1 &&
    Format::centre == 0;

}  // namespace physgen::format
