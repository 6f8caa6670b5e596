// Kernels: first steps of a fused kernel, which read what it wants of a tet only at its end. Left to itself, nvcc reads
// that where it is used: warps then wait for memory once more, with nothing left to do, and what stores come before may
// have overwritten for all it knows is read twice.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/numerics/scalar.h>
#include <physgen/kernel.h>

namespace physgen::fem {

namespace detail {

/// On CUDA a value of a register is there before what follows. Packs are on the CPU, which does as well without.
template <class Value>
PHYSGEN_FUNCTION inline void have(const Value& value) {
#ifdef __CUDA_ARCH__
  if constexpr (std::is_same_v<Value, float>) {
    asm volatile("" ::"f"(value));
  } else if constexpr (std::is_same_v<Value, double>) {
    asm volatile("" ::"d"(value));
  } else if constexpr (std::is_same_v<Value, std::int32_t>) {
    asm volatile("" ::"r"(value));
  }
#else
  (void)value;
#endif
}

}  // namespace detail

/// Loads the places that ScatterCornerForces stores to.
template <class PlaceView, class LoadedView>
struct LoadPlaces {
  using Scalar = typename PlaceView::Precision;
  PlaceView places;   ///< elasticity::TetPlaces
  LoadedView loaded;  ///< elasticity::TetPlaces, written

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    const auto from = places[i].places();
    const auto to = loaded[i].places();
    PHYSGEN_UNROLL
    for (int c = 0; c < 4; ++c) {
      const lanes_t<std::int32_t, I> place = from[c];
      detail::have(place);
      to[c] = place;
    }
  }
};

/// Loads the rest shape for a deformation gradient and for corner forces, between which there are stores.
template <class RestView, class LoadedView>
struct LoadShapes {
  using Scalar = typename RestView::Precision;
  RestView rest;      ///< elasticity::RestShape
  LoadedView loaded;  ///< elasticity::RestShape, written

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const Matrix3<S> dm_inverse = rest[i].dm_inverse();
    const S volume = rest[i].volume();
    PHYSGEN_UNROLL
    for (int c = 0; c < 3; ++c) {
      PHYSGEN_UNROLL
      for (int r = 0; r < 3; ++r) detail::have(dm_inverse(r, c));
    }
    detail::have(volume);
    loaded[i].dm_inverse() = dm_inverse;
    loaded[i].volume() = volume;
  }
};

}  // namespace physgen::fem

#pragma pop_macro("I")
