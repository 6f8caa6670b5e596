// Which of many points are near to one of them: distances of as many at once as the processor's widest registers hold,
// with the same bits in each width.
#pragma once

#include <physgen/config.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>

#include "cell_grid.h"

#if defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>
#define PHYSGEN_WIDER_REGISTERS
#endif

namespace physgen::detail {

/// Entries that append_near() may write behind those that it counts.
constexpr index_t room_behind = 16;

template <class Real, int kDimensions>
struct Near {
  std::array<const Real*, kDimensions> places;
  const std::int32_t* numbers;
  index_t count;
  const CellGrid<Real, kDimensions>& grid;
};

/// Squares of distances of the points from `first` on to the point x; of up to seven points more.
template <class Real, int kDimensions>
[[gnu::always_inline]] inline void squares_of_distances(const Near<Real, kDimensions>& near, index_t first,
                                                        index_t count, const std::array<Real, kDimensions>& x,
                                                        Real* squares) {
  using Lanes [[gnu::vector_size(32)]] = Real;  // compilers find no vectors in a loop with the conditions below
  constexpr index_t lanes = sizeof(Lanes) / sizeof(Real);
  const std::array<Real, kDimensions> length = near.grid.length, half = near.grid.half;
  for (index_t j = 0; j < count; j += lanes) {
    Lanes sum{};
    for (std::size_t k = kDimensions; k-- > 0;) {
      Lanes other;
      std::memcpy(&other, near.places[k] + first + j, sizeof(Lanes));
      const Lanes difference = x[k] - other;
      add_square(sum, difference, length[k], half[k], k + 1 == kDimensions);
    }
    std::memcpy(squares + j, &sum, sizeof(Lanes));
  }
}

/// Writes the numbers whose squares are less than that of the reach. @return behind the last one
template <class Real>
[[gnu::always_inline]] inline std::int32_t* append(const Real* squares, Real square, const std::int32_t* numbers,
                                                   index_t count, std::int32_t* next) {
  for (index_t j = 0; j < count; ++j) {
    *next = numbers[j];
    next += squares[j] < square ? 1 : 0;
  }
  return next;
}

/// See append_near(). @param append as above, in wider registers or not
template <class Real, int kDimensions, class Append>
[[gnu::always_inline]] inline index_t append_near_by(const Near<Real, kDimensions>& near, index_t itself,
                                                     bool with_itself, std::int32_t* found, const Append& append) {
  constexpr index_t most = 256;
  alignas(64) std::array<Real, most + room_behind> squares;
  std::array<Real, kDimensions> x;
  for (std::size_t k = 0; k < kDimensions; ++k) x[k] = near.places[k][itself];
  std::int32_t* next = found;
  for (index_t first = 0; first < near.count; first += most) {
    const index_t count = std::min(most, near.count - first);
    squares_of_distances<Real, kDimensions>(near, first, count, x, squares.data());
    std::fill_n(squares.begin() + count, room_behind, std::numeric_limits<Real>::infinity());
    const index_t own = itself - first;
    if (!with_itself && own >= 0 && own < count) {
      squares[static_cast<std::size_t>(own)] = std::numeric_limits<Real>::infinity();
    }
    next = append(squares.data(), near.grid.square, near.numbers + first, count, next);
  }
  return next - found;
}

#ifdef PHYSGEN_WIDER_REGISTERS
/// For each set of eight lanes: its members one behind the other.
constexpr auto members_of_lanes = [] {
  std::array<std::array<std::uint8_t, 8>, 256> members{};
  for (std::size_t set = 0; set < 256; ++set) {
    std::size_t count = 0;
    for (std::uint8_t lane = 0; lane < 8; ++lane) {
      if ((set >> lane & 1) != 0) members[set][count++] = lane;
    }
  }
  return members;
}();

struct AppendEight {
  [[gnu::target("avx2,popcnt")]] static unsigned less(const float* squares, float square) {
    const __m256 lanes = _mm256_cmp_ps(_mm256_loadu_ps(squares), _mm256_set1_ps(square), _CMP_LT_OQ);
    return static_cast<unsigned>(_mm256_movemask_ps(lanes));
  }
  [[gnu::target("avx2,popcnt")]] static unsigned less(const double* squares, double square) {
    const __m256d lower = _mm256_cmp_pd(_mm256_loadu_pd(squares), _mm256_set1_pd(square), _CMP_LT_OQ);
    const __m256d upper = _mm256_cmp_pd(_mm256_loadu_pd(squares + 4), _mm256_set1_pd(square), _CMP_LT_OQ);
    return static_cast<unsigned>(_mm256_movemask_pd(lower) | _mm256_movemask_pd(upper) << 4);
  }
  /// Reads and writes up to seven numbers more.
  template <class Real>
  [[gnu::target("avx2,popcnt")]] std::int32_t* operator()(const Real* squares, Real square, const std::int32_t* numbers,
                                                          index_t count, std::int32_t* next) const {
    for (index_t j = 0; j < count; j += 8) {
      const unsigned set = less(squares + j, square);
      const __m256i members =
          _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(&members_of_lanes[set])));
      const __m256i eight = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(numbers + j));
      _mm256_storeu_si256(reinterpret_cast<__m256i*>(next), _mm256_permutevar8x32_epi32(eight, members));
      next += _mm_popcnt_u32(set);
    }
    return next;
  }
};
template <class Real, int kDimensions>
[[gnu::target("avx2,popcnt")]] index_t append_near_avx2(const Near<Real, kDimensions>& near, index_t itself,
                                                        bool with_itself, std::int32_t* found) {
  return append_near_by<Real, kDimensions>(near, itself, with_itself, found, AppendEight());
}
#endif

/// Writes the numbers of the points near to the one at `itself`, in their order, and returns how many there are. Reads
/// and writes up to `room_behind` numbers more.
template <class Real, int kDimensions>
index_t append_near(const Near<Real, kDimensions>& near, index_t itself, bool with_itself, std::int32_t* found) {
#ifdef PHYSGEN_WIDER_REGISTERS
  static const bool wide = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("popcnt") != 0;
  if (wide) return append_near_avx2<Real, kDimensions>(near, itself, with_itself, found);
#endif
  return append_near_by<Real, kDimensions>(near, itself, with_itself, found, append<Real>);
}

}  // namespace physgen::detail
