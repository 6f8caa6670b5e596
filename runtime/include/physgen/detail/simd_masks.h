// Makes masks of SIMD packs that no `if` and no `?:` takes, and says what to write instead. Those of xsimd 8.1 for
// AVX-512 convert to an integer, so that `if (a > b)` would compile and mean "in any lane". Here their conversion is
// narrowed to what xsimd's own code needs. Included before the rest of xsimd.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/detail/deleted.h>
#include <physgen/detail/simd_registers.h>

#include <concepts>
#include <type_traits>
#include <xsimd/config/xsimd_arch.hpp>

namespace physgen::detail {

/// The base of masks; its name is what compilers print, some of them as that of the function's argument.
struct a_mask_is_no_bool_so_write_select_or_if_any_of_i_and_it {
  template <class Why = a_mask_is_no_bool_so_write_select_or_if_any_of_i_and_it>
  explicit operator bool() const PHYSGEN_DELETED(a_mask_is_no_bool_so_write_select_or_if_any_of_i_and_it);
};

/// The register of masks where packs have one like it.
template <class Register>
struct MaskOfLanes : Register, a_mask_is_no_bool_so_write_select_or_if_any_of_i_and_it {
  MaskOfLanes() = default;
  MaskOfLanes(typename Register::register_type lanes) : Register{lanes} {}  // NOLINT: implicit, as xsimd's own is
};

/// Packs of the widest registers. (With AVX, xsimd itself uses masks of 16 bytes before this header can change them;
/// with AVX-512 masks have registers of their own.)
template <class A>
concept OfWidestRegister = !XSIMD_WITH_AVX || std::is_base_of_v<xsimd::avx, A>;

}  // namespace physgen::detail

namespace xsimd::types {

/// Those with mask registers of their own have more special ones.
template <class T, class A>
  requires(std::is_arithmetic_v<T> && physgen::detail::OfWidestRegister<A>)
struct get_bool_simd_register<T, A> {
  using type = physgen::detail::MaskOfLanes<simd_register<T, A>>;
};

}  // namespace xsimd::types

#if XSIMD_WITH_AVX512F

namespace physgen::detail {

/// The mask register of packs of T.
template <class Register>
struct MaskRegister : a_mask_is_no_bool_so_write_select_or_if_any_of_i_and_it {
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
