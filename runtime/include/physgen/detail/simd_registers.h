// Makes packs convert to registers of their own type alone. xsimd 8.1 lets a pack convert to its register by a plain
// conversion function, which clang takes for its own operators of vectors, and vectors for each other: floats times
// integers, `S(k)` of integers, or a mask plus a mask would compile, and calculate with bits of another type. Included
// before the rest of xsimd.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <concepts>
#include <type_traits>
#include <xsimd/types/xsimd_register.hpp>

namespace physgen::detail {

/// The type of register that a pack has. (g++ warns of a register's type as an argument of a template that is named.)
template <class R, class Pack>
concept RegisterOf = std::same_as<R, typename Pack::register_type>;

}  // namespace physgen::detail

// As xsimd's own, but for the conversion: clang's operators of vectors look at no templates.
#undef XSIMD_DECLARE_SIMD_REGISTER
#define XSIMD_DECLARE_SIMD_REGISTER(SCALAR_TYPE, ISA, VECTOR_TYPE) \
  template <>                                                      \
  struct simd_register<SCALAR_TYPE, ISA> {                         \
    using register_type = VECTOR_TYPE;                             \
    register_type data;                                            \
    template <class R>                                             \
      requires physgen::detail::RegisterOf<R, simd_register>       \
    operator R() const noexcept {                                  \
      return data;                                                 \
    }                                                              \
  };                                                               \
  template <>                                                      \
  struct has_simd_register<SCALAR_TYPE, ISA> : std::true_type {}

#pragma pop_macro("I")
