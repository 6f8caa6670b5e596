// Kernels that sum long rows of terms for each of their objects. Such a kernel forms a part of a sum, and puts away the
// whole: one thread takes both, or on CUDA some lanes of a warp a part each (row_sums_cuda.h), so that they do not
// wait for one load after the other.
#pragma once

#include <fem/numerics/scalar.h>
#include <physgen/kernel.h>
#include <physgen/rows.h>

#include <algorithm>

namespace physgen::fem {

/// Some terms of a row: number, number + count, ...
struct Lane {
  int number = 0, count = 1;
};

/// zero + term(entry) + ... of a lane's entries of a row, in their order.
/// @param term of any entry, at any time: it changes nothing
template <class Rows, class Value, class Term>
[[nodiscard]] PHYSGEN_FUNCTION Value sum_of_lane(const Rows& rows, SingleObject auto row, Lane lane, const Value& zero,
                                                 const Term& term) {
#ifdef __CUDA_ARCH__
  constexpr int at_once = 4;  // terms whose loads are under way together
#else
  constexpr int at_once = 1;
#endif
  const auto range = rows.ranges()[row];
  const int begin = range.begin(), end = range.end();
  Value sum = zero;
  for (int first = begin + lane.number; first < end; first += at_once * lane.count) {
    Value terms[at_once];
    PHYSGEN_UNROLL
    for (int t = 0; t < at_once; ++t) {
      const int entry = first + t * lane.count;
      terms[t] = term(rows.entries()[index_t{entry < end ? entry : first}]);
    }
    PHYSGEN_UNROLL
    for (int t = 0; t < at_once; ++t) {
      if (first + t * lane.count < end) sum += terms[t];
    }
  }
  return sum;
}

/// Runs a kernel that sums rows.
/// @param kernel has `lanes`, how many share a row where that is faster, a power of two up to 32;
/// `part(row, Lane)`; `put(row, sum)`; and `operator()(row)`, which is put(row, part(row, Lane{}))
template <class On, class Kernel>
void run_rows(On& on, index_t rows, const Kernel& kernel) {
  on.run(rows, kernel);
}

}  // namespace physgen::fem
