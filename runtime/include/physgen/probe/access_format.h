// The storage format that tells reads and writes apart.
#pragma once

#include <physgen/format/nothing.h>
#include <physgen/probe/field_accesses.h>

namespace physgen {

/// Field number `field` of Object::fields, in the array that ArrayTag names: has the size, the type and the numbers of
/// Base, but is not plain, so that code reads through decode() and writes through encode(), whatever it is written
/// like. The code may do what a compiler instantiates of these. They compute what those of Base do.
/// @tparam ArrayTag a type with `static constexpr const char* name`, one for each array
/// @tparam Base a format of single elements, or the Quaternion of one
template <class ArrayTag, class Object, int field, class Base>
struct Probe {
  static constexpr const char* name = Base::name;
  template <class Real>
  struct Held {
    typename Base::template Stored<Real> value;
  };
  template <class Real>
  using Stored = Held<Real>;
  template <class Real>
  static constexpr ElementType type = Base::template type<Real>;
  static constexpr double scale = Base::scale, centre = Base::centre;

  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static Real decode(Held<Real> stored) {
    found<probe::detail::Access::read>();
    return Base::template decode<Real>(stored.value);
  }
  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static Held<Real> encode(Real value) {
    found<probe::detail::Access::written>();
    return {Base::template encode<Real>(value)};
  }
  /// Takes an element's address. @param stored points to const in a read-only array
  template <class Real, class Stored>
  [[nodiscard]] PHYSGEN_FUNCTION static auto address(Stored* stored) {
    static_assert(format::is_plain<Base, Real>, "only an element that is stored as it is computed has an address");
    found<probe::detail::Access::address>();
    (void)decode<Real>(*stored);
    if constexpr (!std::is_const_v<Stored>) *stored = encode<Real>(Real());
    return &stored->value;
  }

 private:
  template <probe::detail::Access access>
  PHYSGEN_FUNCTION static void found() {
#ifndef __CUDA_ARCH__
    (void)&probe::detail::Used<ArrayTag, Object, field, access>::use;
#endif
  }
};

/// The probe of a rotation: components of its quaternion are told apart from other fields, not from each other.
template <class ArrayTag, class Object, int field, class Component_>
struct Probe<ArrayTag, Object, field, format::Quaternion<Component_>> {
  static constexpr const char* name = format::Quaternion<Component_>::name;
  using Component = Probe<ArrayTag, Object, field, Component_>;
};

}  // namespace physgen
