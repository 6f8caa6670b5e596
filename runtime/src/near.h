// Which of many points are near to one of them: distances of as many at once as the processor's widest registers hold,
// with the same bits in each width.
#pragma once

#include <physgen/config.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#if defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>
#define PHYSGEN_WIDER_REGISTERS
#endif

namespace physgen::detail {

/// Entries that append_near() may write behind those that it counts.
constexpr std::size_t room_behind = 16;

template <class Real, int kDimensions>
struct Near {
  std::array<const Real*, kDimensions> places;
  const std::int32_t* numbers;
  index_t count;
  Real square;                           ///< of the reach
  std::array<Real, kDimensions> length;  ///< of the box, 0 where it is not periodic
};

/// Squares of distances of the points from `first` on to the point x.
template <class Real, int kDimensions>
[[gnu::always_inline]] inline void squares_of_distances(const Near<Real, kDimensions>& near, index_t first,
                                                        index_t count, const std::array<Real, kDimensions>& x,
                                                        Real* squares) {
  for (std::size_t k = kDimensions; k-- > 0;) {
    const Real* other = near.places[k] + first;
    const Real length = near.length[k], half = length > 0 ? length / 2 : std::numeric_limits<Real>::infinity();
    const Real here = x[k];
    const bool last = k + 1 == kDimensions;
    for (index_t j = 0; j < count; ++j) {
      Real d = here - other[j];
      d = d > half ? d - length : d < -half ? d + length : d;
      squares[j] = last ? d * d : d * d + squares[j];
    }
  }
}

template <class Real, int kDimensions>
[[gnu::always_inline]] inline index_t append_near_in_any_width(const Near<Real, kDimensions>& near, index_t itself,
                                                               bool with_itself, std::int32_t* found) {
  constexpr index_t most = 256;
  alignas(64) std::array<Real, most> squares;
  std::array<Real, kDimensions> x;
  for (std::size_t k = 0; k < kDimensions; ++k) x[k] = near.places[k][itself];
  std::int32_t* next = found;
  for (index_t first = 0; first < near.count; first += most) {
    const index_t count = std::min(most, near.count - first);
    squares_of_distances<Real, kDimensions>(near, first, count, x, squares.data());
    const index_t own = itself - first;
    if (!with_itself && own >= 0 && own < count) {
      squares[static_cast<std::size_t>(own)] = std::numeric_limits<Real>::infinity();
    }
    for (index_t j = 0; j < count; ++j) {
      *next = near.numbers[first + j];
      next += squares[static_cast<std::size_t>(j)] < near.square ? 1 : 0;
    }
  }
  return next - found;
}

#ifdef PHYSGEN_WIDER_REGISTERS
template <class Real, int kDimensions>
[[gnu::target("avx2")]] index_t append_near_avx2(const Near<Real, kDimensions>& near, index_t itself, bool with_itself,
                                                 std::int32_t* found) {
  return append_near_in_any_width<Real, kDimensions>(near, itself, with_itself, found);
}
template <class Real, int kDimensions>
[[gnu::target("avx512f,avx512vl,avx512dq,avx512bw,prefer-vector-width=512")]] index_t append_near_avx512(
    const Near<Real, kDimensions>& near, index_t itself, bool with_itself, std::int32_t* found) {
  return append_near_in_any_width<Real, kDimensions>(near, itself, with_itself, found);
}
#endif

/// Writes the numbers of the points near to the one at `itself`, in their order, and returns how many there are.
template <class Real, int kDimensions>
index_t append_near(const Near<Real, kDimensions>& near, index_t itself, bool with_itself, std::int32_t* found) {
#ifdef PHYSGEN_WIDER_REGISTERS
  static const int width = __builtin_cpu_supports("avx512vl") != 0 ? 512
                           : __builtin_cpu_supports("avx2") != 0   ? 256
                                                                   : 128;
  if (width == 512) return append_near_avx512<Real, kDimensions>(near, itself, with_itself, found);
  if (width == 256) return append_near_avx2<Real, kDimensions>(near, itself, with_itself, found);
#endif
  return append_near_in_any_width<Real, kDimensions>(near, itself, with_itself, found);
}

}  // namespace physgen::detail
