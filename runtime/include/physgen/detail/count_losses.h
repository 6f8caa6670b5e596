// Counts values that a storage format could not hold, from any number of threads at once, on host and device.
#pragma once

#include <physgen/arrays/losses.h>
#include <physgen/format.h>

#include <bit>
#include <cmath>

namespace physgen::detail {

PHYSGEN_FUNCTION inline void count_one(unsigned long long& counter) {
#ifdef __CUDA_ARCH__
  atomicAdd(&counter, 1ULL);
#else
  __atomic_fetch_add(&counter, 1ULL, __ATOMIC_RELAXED);
#endif
}

/// Raises `bits`, those of a double, to `value`. @pre value >= 0, so that bits are in the order of numbers
PHYSGEN_FUNCTION inline void raise(unsigned long long& bits, double value) {
  const auto raised = std::bit_cast<unsigned long long>(value);
#ifdef __CUDA_ARCH__
  atomicMax(&bits, raised);
#else
  unsigned long long before = __atomic_load_n(&bits, __ATOMIC_RELAXED);
  while (before < raised &&
         !__atomic_compare_exchange_n(&bits, &before, raised, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {
  }
#endif
}

/// Makes `first` this loss where it comes before the one that is known. Almost every call ends at the first
/// comparison; else a lock of its own keeps object and value together.
PHYSGEN_FUNCTION inline void keep_first(Losses::FirstLoss& first, index_t object, int offset, double value) {
  const unsigned long long order = Losses::FirstLoss::order_of(object, offset);
#ifdef __CUDA_ARCH__
  auto* known = const_cast<volatile Losses::FirstLoss*>(&first);
  while (order < known->order) {
    if (atomicCAS(&first.busy, 0U, 1U) != 0) continue;  // threads of a warp go on one by one
    __threadfence();
    if (order < known->order) {
      known->object = object;
      known->offset = offset;
      known->value = value;
      known->order = order;
    }
    __threadfence();
    atomicExch(&first.busy, 0U);
  }
#else
  while (order < __atomic_load_n(&first.order, __ATOMIC_RELAXED)) {
    if (__atomic_exchange_n(&first.busy, 1U, __ATOMIC_ACQUIRE) != 0) continue;
    if (order < __atomic_load_n(&first.order, __ATOMIC_RELAXED)) {
      first.object = object;
      first.offset = offset;
      first.value = value;
      __atomic_store_n(&first.order, order, __ATOMIC_RELAXED);
    }
    __atomic_store_n(&first.busy, 0U, __ATOMIC_RELEASE);
  }
#endif
}

PHYSGEN_FUNCTION inline void remember(unsigned long long& counter, Losses::FirstLoss& first, index_t object, int offset,
                                      double value) {
  count_one(counter);
  keep_first(first, object, offset, value);
}

/// Counts what became of `value`, stored in `type` and read back as `back`.
/// @param scale of the format, which divides its numbers' sizes out
PHYSGEN_FUNCTION inline void count_loss(Losses& losses, ElementType type, double scale, double value, double back,
                                        index_t object, int offset) {
  if (type == ElementType::float64 || is_whole(type)) return;
  if (!(std::abs(value) <= 1.7976931348623157e308)) {
    if (element_bytes(type) == 2) remember(losses.not_a_number, losses.first, object, offset, value);
    return;
  }
  const double error = std::abs(back - value);
  if (const int steps = facts(type).steps; steps != 0) {
    if (error > scale / steps) return remember(losses.out_of_range, losses.first, object, offset, value);
    return;  // its error is absolute
  }
  if (!(std::abs(back) <= 1.7976931348623157e308))
    return remember(losses.out_of_range, losses.first, object, offset, value);
  if (!(error > relative_error(type) * std::abs(value))) return;
  remember(losses.imprecise, losses.first_imprecise, object, offset, value);
  raise(losses.worst, error / std::abs(value));
}

/// Counts a matrix that is not orthogonal with determinant 1 to a hundredth. @param deviation from that; NaN counts
PHYSGEN_FUNCTION inline void count_deviation(Losses& losses, double deviation, index_t object, int offset) {
  if (!(deviation <= 1e-2)) remember(losses.not_a_rotation, losses.first, object, offset, deviation);
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

}  // namespace physgen::detail
