// Checks that a generic kernel which is launched over single objects, on the host or on a device, calculates as its
// packs would: it is compiled over numbers that refuse a float beside a double (one_lane.h), and not run. Packs refuse
// that themselves.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/arrays/view.h>
#include <physgen/detail/one_lane.h>

namespace physgen {

namespace detail {

template <class I>
inline constexpr bool of_checked_numbers = std::is_same_v<I, CheckedIndex>;
template <class T>
inline constexpr bool of_checked_numbers<one_lane_of_S<T>> = true;
template <class T>
inline constexpr bool of_checked_numbers<lane_in_memory<T>> = true;
template <class I>
concept OfCheckedNumbers = of_checked_numbers<I>;

}  // namespace detail

template <class T, detail::OfCheckedNumbers I>
struct Lanes<T, I> {
  using type = detail::one_lane_of_S<T>;
};
template <class U, class T>
struct SameLanes<detail::one_lane_of_S<U>, T> {
  using type = detail::one_lane_of_S<T>;
};
template <class T>
struct LaneOf<detail::one_lane_of_S<T>> {
  using type = T;
};

/// In the place of a cursor on one object. Nothing of it is defined, as nothing of it runs.
template <class Byte, class Layout, RecordSize kRecord, detail::OfCheckedNumbers I>
class Cursor<Byte, Layout, kRecord, I> {
 public:
  template <class T>
  using Lanes = detail::one_lane_of_S<T>;
  static constexpr bool gathered = false;
  static constexpr bool of_a_local = requires { Layout::of_locals; };
  template <class T, int kCount>
  static constexpr bool joins_words = false;

  PHYSGEN_FUNCTION Cursor(Byte* base, typename Layout::Pitch pitch, I i, Losses* losses);

  template <class Shape, class Format, class T>
  [[nodiscard]] PHYSGEN_FUNCTION decltype(auto) field(int offset) const {
    if constexpr (Shape::is_scalar) {
      return element<Format, T>(offset);
    } else {
      return FieldRef<Shape, Format, T, Cursor>(nested(offset));
    }
  }
  template <class Format, class T>
  [[nodiscard]] PHYSGEN_FUNCTION decltype(auto) element(int offset, int k = 0) const {
    if constexpr (format::is_plain<Format, T> && !of_a_local) {
      return in_memory<
          std::conditional_t<std::is_const_v<Byte>, const detail::lane_in_memory<T>, detail::lane_in_memory<T>>>(offset,
                                                                                                                 k);
    } else {
      return ElementRef<Format, T, Cursor>(*this, offset, k);
    }
  }
  template <class Format, class T>
  [[nodiscard]] PHYSGEN_FUNCTION Lanes<T> load(int offset, int k) const;
  template <class Format, class T>
  PHYSGEN_FUNCTION void store(int offset, int k, const Lanes<T>& value) const;
  template <class Format, class T, int kCount>
  PHYSGEN_FUNCTION void add(LaneRange range, int offset, int k, const Lanes<T>* values) const;
  template <class Format, class T>
  [[nodiscard]] PHYSGEN_FUNCTION T* address_of(int offset, int k) const;
  template <class S>
  PHYSGEN_FUNCTION void check_rotation(const Eigen::Matrix<S, 3, 3>& R) const;
  [[nodiscard]] PHYSGEN_FUNCTION Cursor nested(int offset) const;

 private:
  template <class Lane>
  [[nodiscard]] PHYSGEN_FUNCTION Lane& in_memory(int offset, int k) const;
};

template <class I, class T, class Value>
PHYSGEN_FUNCTION void add(const I& own, detail::lane_in_memory<T>& to, const Value& value);
template <class I, class T>
PHYSGEN_FUNCTION T largest(const I& i, const detail::one_lane_of_S<T>& value);
template <class I, class T>
PHYSGEN_FUNCTION T smallest(const I& i, const detail::one_lane_of_S<T>& value);

namespace detail {

/// Whether a kernel is generic, and says with which numbers it computes in packs.
template <class Kernel>
concept Generic = requires(const Kernel& kernel, CheckedIndex i) {
  typename Kernel::Scalar;
  kernel.template operator()<CheckedIndex>(i);
};

/// Compiles kernel(i) over checked numbers, and does nothing.
#ifdef __CUDACC__
#pragma nv_exec_check_disable  // kernels may be for the device alone
#endif
template <class Kernel>
PHYSGEN_FUNCTION inline void check_numbers([[maybe_unused]] const Kernel& kernel) {
#if defined(__CUDA_ARCH__) || !defined(__CUDACC__)  // nvcc reads the source once for the device, twice for the host
  if constexpr (Generic<Kernel>) {
    constexpr bool run = false;
    if (run) (void)kernel(CheckedIndex());
  }
#endif
}

}  // namespace detail

}  // namespace physgen

#pragma pop_macro("I")
