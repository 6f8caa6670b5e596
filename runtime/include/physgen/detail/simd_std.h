// Calls of std::sqrt() and its like with packs, of which the standard library knows nothing: they are refused by types
// whose names compilers print, in place of a list of all overloads.
//
// These functions stand in namespace std, where a program may declare none [namespace.std]. Nothing else is looked up
// by a qualified call, and a batch, which is xsimd's, has no base that could convert to what std::sqrt() takes. They
// are viable for packs and references to them alone, which the standard library has no overloads for, and an
// unqualified call prefers those of packs, which are more special.
#pragma once

#include <physgen/detail/deleted.h>
#include <physgen/detail/reference_rules.h>
#include <physgen/detail/simd_registers.h>

#include <cmath>
#include <type_traits>
#include <xsimd/xsimd.hpp>

namespace physgen::detail {

struct std_has_no_functions_of_packs_so_write_the_call_without_std {};
struct functions_of_packs_take_no_references_so_write_get_of_it_without_std {};

template <class X>
inline constexpr bool is_a_pack = false;
template <class T, class A>
inline constexpr bool is_a_pack<xsimd::batch<T, A>> = true;
template <class X>
inline constexpr bool refers_to_a_pack = false;
template <class Format, class T, class Cursor>
inline constexpr bool refers_to_a_pack<ElementRef<Format, T, Cursor>> =
    is_a_pack<std::remove_const_t<typename ElementRef<Format, T, Cursor>::Value>>;

template <class... X>
concept HavePacks = (is_a_pack<X> || ...);
template <class... X>
concept HaveReferences = !HavePacks<X...> && (refers_to_a_pack<X> || ...);

}  // namespace physgen::detail

namespace std {

// What refuses is a template's argument, too, since clang names no types that functions return. This macro is undefined
// below.
#define PHYSGEN_REFUSED(function)                                                                                  \
  template <class Refused = physgen::detail::std_has_no_functions_of_packs_so_write_the_call_without_std, class X, \
            class... More>                                                                                         \
    requires physgen::detail::HavePacks<X, More...>                                                                \
  Refused function(const X&, const More&...)                                                                       \
      PHYSGEN_DELETED(std_has_no_functions_of_packs_so_write_the_call_without_std);                                \
  template <class Refused = physgen::detail::functions_of_packs_take_no_references_so_write_get_of_it_without_std, \
            class X, class... More>                                                                                \
    requires physgen::detail::HaveReferences<X, More...>                                                           \
  Refused function(const X&, const More&...)                                                                       \
      PHYSGEN_DELETED(functions_of_packs_take_no_references_so_write_get_of_it_without_std);
PHYSGEN_REFUSED(abs)
PHYSGEN_REFUSED(acos)
PHYSGEN_REFUSED(asin)
PHYSGEN_REFUSED(atan)
PHYSGEN_REFUSED(atan2)
PHYSGEN_REFUSED(cbrt)
PHYSGEN_REFUSED(ceil)
PHYSGEN_REFUSED(copysign)
PHYSGEN_REFUSED(cos)
PHYSGEN_REFUSED(cosh)
PHYSGEN_REFUSED(exp)
PHYSGEN_REFUSED(expm1)
PHYSGEN_REFUSED(fabs)
PHYSGEN_REFUSED(floor)
PHYSGEN_REFUSED(fma)
PHYSGEN_REFUSED(fmod)
PHYSGEN_REFUSED(hypot)
PHYSGEN_REFUSED(isfinite)
PHYSGEN_REFUSED(isinf)
PHYSGEN_REFUSED(isnan)
PHYSGEN_REFUSED(log)
PHYSGEN_REFUSED(log1p)
PHYSGEN_REFUSED(pow)
PHYSGEN_REFUSED(round)
PHYSGEN_REFUSED(sin)
PHYSGEN_REFUSED(sinh)
PHYSGEN_REFUSED(sqrt)
PHYSGEN_REFUSED(tan)
PHYSGEN_REFUSED(tanh)
PHYSGEN_REFUSED(trunc)
#undef PHYSGEN_REFUSED

}  // namespace std
