// What formats know of those that tell reads and writes apart (probe.h has their definition): they have the traits of
// the format that they stand for, but nothing is plain, so that every access goes through decode() and encode().
#pragma once

#include <physgen/format/native.h>
#include <physgen/format/quaternion.h>

namespace physgen {

/// Field number `field` of `Object`, stored as `Base`, in the array that `ArrayTag` names.
template <class ArrayTag, class Object, int field, class Base>
struct Probe;

namespace format {

namespace detail {

template <class Format>
inline constexpr bool is_probe = false;
template <class ArrayTag, class Object, int field, class Base>
inline constexpr bool is_probe<Probe<ArrayTag, Object, field, Base>> = true;

template <class ArrayTag, class Object, int field, class Base>
inline constexpr bool is_quaternion<Probe<ArrayTag, Object, field, Base>> = is_quaternion<Base>;

/// A probe of a rotation's quaternion is one of its components, too.
template <class ArrayTag, class Object, int field, class Component>
struct ElementFormat<Probe<ArrayTag, Object, field, Quaternion<Component>>> {
  using type = Probe<ArrayTag, Object, field, Component>;
};

/// Returned by deleted functions, or taken by them: their names are what compilers print.
struct a_probed_array_has_no_raw_memory_so_read_and_write_its_fields;
struct this_kernel_is_over_a_concrete_view_so_write_it_as_a_template_over_its_views {};

}  // namespace detail

/// Whether the format tells reads and writes of its field apart.
template <class Format>
inline constexpr bool is_probe = detail::is_probe<Format>;

/// Whether these are the formats of an array whose reads and writes are told apart, which generated code calls
/// XProbe.
template <class Formats>
inline constexpr bool are_probes = requires { typename Formats::array_; };

template <class ArrayTag, class Object, int field, class Base>
inline constexpr bool holds_indices<Probe<ArrayTag, Object, field, Base>> = holds_indices<Base>;

}  // namespace format
}  // namespace physgen
