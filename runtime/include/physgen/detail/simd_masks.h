// Makes masks of SIMD packs that no `if` and no `?:` takes. Those of xsimd 8.1 for AVX-512 convert to an integer, so
// that `if (a > b)` would compile and mean "in any lane"; on other instruction sets it does not compile. Here their
// conversion is narrowed to what xsimd's own code needs. Included before the rest of xsimd.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <concepts>
#include <type_traits>
#include <xsimd/config/xsimd_arch.hpp>

#if XSIMD_WITH_AVX512F

namespace physgen::detail {

/// The mask register of packs of T.
template <class Register>
struct MaskRegister {
  using register_type = Register;
  register_type data;

  MaskRegister() = default;
  MaskRegister(register_type bits) : data(bits) {}  // NOLINT: implicit, as xsimd's own is
  /// To mask registers (xsimd names wider ones in branches that are not taken), and to nothing that these convert to:
  /// not to bool.
  template <class R>
    requires(std::same_as<R, __mmask8> || std::same_as<R, __mmask16> || std::same_as<R, __mmask32> ||
             std::same_as<R, __mmask64>)
  operator R() const noexcept {  // NOLINT: implicit, as xsimd's own is
    return static_cast<R>(data);
  }
};

}  // namespace physgen::detail

namespace xsimd::types {

template <class T>
  requires(sizeof(T) >= 4)
struct simd_avx512_bool_register<T>
    : physgen::detail::MaskRegister<std::conditional_t<sizeof(T) == 4, __mmask16, __mmask8>> {
  using simd_avx512_bool_register::MaskRegister::MaskRegister;
};

}  // namespace xsimd::types

#endif

#pragma pop_macro("I")
