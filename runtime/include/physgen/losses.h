// What storage formats could not hold. Checked builds count it wherever elements are stored; the first loss of a kind
// that falsifies is remembered with its place.
#pragma once

#include <physgen/format.h>

#include <cmath>

namespace physgen {

/// Counts of one array since it was made or last asked (Array::take_losses), or of one copy.
struct Losses {
  unsigned long long out_of_range = 0;    ///< finite, and stored as infinity or as the end of the range
  unsigned long long not_a_number = 0;    ///< NaN or infinite values, stored in 16 bits
  unsigned long long not_a_rotation = 0;  ///< matrices that are no rotation, stored as a quaternion
  unsigned long long imprecise = 0;       ///< kept with a larger relative error than the format has for ordinary values
  // The first of the upper three, where there is one:
  unsigned int has_first = 0;
  int offset = 0;       ///< of the element in the record [bytes]
  index_t object = 0;   ///< the object's number
  double value = 0;     ///< what was to be stored; of a matrix, the largest deviation from a rotation
  index_t objects = 0;  ///< of the array; what kernels store behind them, in padding, does not count

  /// How many values are wrong, not only imprecise.
  [[nodiscard]] unsigned long long falsified() const { return out_of_range + not_a_number + not_a_rotation; }
};

namespace detail {

PHYSGEN_FUNCTION inline void count_one(unsigned long long& counter) {
#ifdef __CUDA_ARCH__
  atomicAdd(&counter, 1ULL);
#else
  __atomic_fetch_add(&counter, 1ULL, __ATOMIC_RELAXED);
#endif
}

/// Whether this call is the first for `flag`.
PHYSGEN_FUNCTION inline bool claim(unsigned int& flag) {
#ifdef __CUDA_ARCH__
  return atomicExch(&flag, 1U) == 0;
#else
  return __atomic_exchange_n(&flag, 1U, __ATOMIC_RELAXED) == 0;
#endif
}

PHYSGEN_FUNCTION inline void remember(Losses& losses, unsigned long long& counter, index_t object, int offset,
                                      double value) {
  count_one(counter);
  if (!claim(losses.has_first)) return;
  losses.object = object;
  losses.offset = offset;
  losses.value = value;
}

/// Counts what became of `value`, stored in `type` and read back as `back`.
/// @param scale of the format, which divides its numbers' sizes out
PHYSGEN_FUNCTION inline void count_loss(Losses& losses, ElementType type, double scale, double value, double back,
                                        index_t object, int offset) {
  if (type == ElementType::float64 || type == ElementType::int32) return;
  if (!(std::abs(value) <= 1.7976931348623157e308)) {
    if (element_bytes(type) == 2) remember(losses, losses.not_a_number, object, offset, value);
    return;
  }
  const double error = std::abs(back - value);
  if (type == ElementType::snorm16) {
    if (error > scale / 32767) return remember(losses, losses.out_of_range, object, offset, value);
    return;  // its error is absolute
  }
  if (!(std::abs(back) <= 1.7976931348623157e308)) return remember(losses, losses.out_of_range, object, offset, value);
  const double relative = type == ElementType::half ? 0x1p-11 : type == ElementType::bfloat16 ? 0x1p-8 : 0x1p-24;
  if (error > relative * std::abs(value)) count_one(losses.imprecise);
}

/// Counts a matrix that is not orthogonal with determinant 1 to a hundredth. @param deviation from that; NaN counts
PHYSGEN_FUNCTION inline void count_deviation(Losses& losses, double deviation, index_t object, int offset) {
  if (!(deviation <= 1e-2)) remember(losses, losses.not_a_rotation, object, offset, deviation);
}

/// Largest entry of R^T R - 1, and of det R - 1; NaN where an entry is.
template <class S>
[[nodiscard]] PHYSGEN_FUNCTION inline double rotation_deviation(const Eigen::Matrix<S, 3, 3>& R) {
  double deviation = 0;
  const auto worse = [&deviation](double by) {
    const double size = std::abs(by);
    if (!(size <= deviation)) deviation = size;
  };
  for (int a = 0; a < 3; ++a) {
    for (int b = a; b < 3; ++b) {
      double dot = a == b ? -1 : 0;
      for (int k = 0; k < 3; ++k) dot += double(R(k, a)) * double(R(k, b));
      worse(dot);
      if (deviation != deviation) return deviation;
    }
  }
  double determinant = -1;
  for (int k = 0; k < 3; ++k) {
    const int u = (k + 1) % 3, v = (k + 2) % 3;
    determinant += double(R(k, 0)) * (double(R(u, 1)) * double(R(v, 2)) - double(R(v, 1)) * double(R(u, 2)));
  }
  worse(determinant);
  return deviation;
}

}  // namespace detail
}  // namespace physgen
