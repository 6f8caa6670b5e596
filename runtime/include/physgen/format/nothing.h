// Fields of which nothing is stored: stores to them vanish, and code that reads one does not compile. So an array holds
// no more than a program needs, and the compiler proves that the program needs no more.
#pragma once

#include <physgen/detail/no_element.h>
#include <physgen/format/native.h>

#include <concepts>

namespace physgen::format {

/// No bytes. A kernel that stores such a field compiles to nothing there, and values that it computes for the field
/// alone are not computed; whatever reads it does not compile: get() of a whole object, add(), swap(), += included. A
/// copy to an array whose field is Nothing is refused, since the field would be lost: Pruned says that this is meant.
struct Nothing {
  using Library = Nothing;
  static constexpr const char* name = "nothing";
  template <class Real>
  using Stored = detail::NoElement;
  template <class Real>
  static constexpr ElementType type = ElementType::none;
  static constexpr double scale = 1, centre = 0;

  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static Real decode(detail::NoElement /*stored*/) {
    static_assert(detail::is_kept<Real>,
                  "this field is pruned: its format is Nothing, so it cannot be read. Give it another format, or read "
                  "an array that stores it");
    return Real();
  }
  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static detail::NoElement encode(Real /*value*/) {
    return {};
  }
};

/// Nothing, where the names say whose decision that was: compilers print them where code reads the field. Copies to an
/// array leave its pruned fields out.
/// @tparam Scene_, Array_, Field_ tag types, which nothing looks into
template <class Scene_, class Array_, class Field_>
struct Pruned : Nothing {
  using Library = Pruned;

  template <class Real>
  [[nodiscard]] PHYSGEN_FUNCTION static Real decode(detail::NoElement /*stored*/) {
    static_assert(detail::is_kept<Real>,
                  "this field is pruned: no kernel of the scene reads it, so it cannot be read here. Scene_, Array_ "
                  "and Field_ of Pruned say which field it is; run the kernel in the scene's program, which then keeps "
                  "the field, or read an array that stores it");
    return Real();
  }
};

/// Formats of no bytes.
template <class Format>
concept StoresNothing = std::derived_from<Format, Nothing>;

template <class Format>
  requires StoresNothing<Format>
inline constexpr bool holds_indices<Format> = true;

/// Formats of no bytes that copies leave out.
template <class Format>
inline constexpr bool is_pruned = false;
template <class Scene, class Array, class Field>
inline constexpr bool is_pruned<Pruned<Scene, Array, Field>> = true;

}  // namespace physgen::format
