// Declares to formats those that tell reads and writes apart (probe.h defines them): they have the traits of the format
//  that they stand for, but nothing is plain, so that every access goes through decode() and encode().
#pragma once

#include <physgen/format/native.h>
#include <physgen/format/quaternion.h>

#include <utility>

namespace physgen {

/// Field number `field` of `Object`, stored as `Base`, in the array that `ArrayTag` names.
template <class ArrayTag, class Object, int field, class Base>
struct Probe;

namespace probe {

/// Stands in the place of an array's tag: the same array, under the index that a kernel is called with. The plain tag
/// says that the kernel forms the index, or that types do not say which it is, as for single objects.
template <class ArrayTag>
struct AtOwnIndex {
  static constexpr const char* name = ArrayTag::name;
};
/// The same where a kernel is called for the objects of a part: the array under object_of_part(first, i). On several
/// ranks these are own objects; to steps that may become one they are others, as to any `first` but 0.
template <class ArrayTag>
struct AtOwnOfPart {
  static constexpr const char* name = ArrayTag::name;
};

}  // namespace probe

namespace format {

/// Whether the format tells reads and writes of its field apart.
template <class Format>
inline constexpr bool is_probe = false;
template <class ArrayTag, class Object, int field, class Base>
inline constexpr bool is_probe<Probe<ArrayTag, Object, field, Base>> = true;

template <class ArrayTag, class Object, int field, class Base>
inline constexpr bool is_quaternion<Probe<ArrayTag, Object, field, Base>> = is_quaternion<Base>;

namespace detail {

/// A probe of a rotation's quaternion is one of its components, too.
template <class ArrayTag, class Object, int field, class Component>
struct ElementFormat<Probe<ArrayTag, Object, field, Quaternion<Component>>> {
  using type = Probe<ArrayTag, Object, field, Component>;
};

/// Returned by deleted functions, or taken by them: their names are what compilers print.
struct this_kernel_is_over_a_concrete_view_so_write_it_as_a_template_over_its_views {};

template <template <class, class, class, int> class XProbe, class ArrayTag, class Base, class Object, int first>
XProbe<probe::AtOwnIndex<ArrayTag>, Base, Object, first> at_own_index(XProbe<ArrayTag, Base, Object, first>);
template <template <class, class, class, int> class XProbe, class ArrayTag, class Base, class Object, int first>
XProbe<probe::AtOwnOfPart<ArrayTag>, Base, Object, first> at_own_of_part(XProbe<ArrayTag, Base, Object, first>);

template <class Formats, bool own, bool of_part>
struct FormatsAt {
  using type = Formats;
};

}  // namespace detail

/// Whether these are the formats of an array whose reads and writes are told apart, which generated code calls
/// XProbe.
template <class Formats>
inline constexpr bool are_probes = requires { typename Formats::array_; };

namespace detail {

template <class Formats>
  requires are_probes<Formats>
struct FormatsAt<Formats, true, false> {
  using type = decltype(at_own_index(std::declval<Formats>()));
};
template <class Formats>
  requires are_probes<Formats>
struct FormatsAt<Formats, true, true> {
  using type = decltype(at_own_of_part(std::declval<Formats>()));
};

}  // namespace detail

/// The same formats; of a probed array, those that say that the index is the kernel's own, or own and of a part.
template <class Formats, bool own, bool of_part>
using FormatsAt = typename detail::FormatsAt<Formats, own, of_part>::type;

template <class ArrayTag, class Object, int field, class Base>
inline constexpr bool holds_indices<Probe<ArrayTag, Object, field, Base>> = holds_indices<Base>;

}  // namespace format
}  // namespace physgen
