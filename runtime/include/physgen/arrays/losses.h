// Counts of values that storage formats could not hold. Checked builds count wherever elements are stored, and remember
// the first value, in the order of the objects, that is wrong and the first one that is imprecise.
#pragma once

#include <physgen/config.h>

#include <bit>

namespace physgen {

/// Counts of one array since it was made or last asked (Array::take_losses), or of one copy.
struct Losses {
  /// The first loss of a kind: that with the smallest object number, and with the smallest offset there. So it is the
  /// same one however many threads stored.
  struct FirstLoss {
    unsigned long long order = ~0ULL;  ///< grows with object and offset; the largest number where nothing is known
    unsigned int busy = 0;             ///< a thread is writing the others
    int offset = 0;                    ///< of the element in the record [bytes]
    index_t object = 0;                ///< the object's number
    double value = 0;                  ///< the value to be stored; of a matrix, the largest deviation from a rotation

    [[nodiscard]] PHYSGEN_FUNCTION bool known() const { return order != ~0ULL; }
    /// Object and offset in one number; of losses that it cannot tell apart, those beyond 2^40 objects or 8 MiB of a
    /// record, the one that came first stays.
    [[nodiscard]] PHYSGEN_FUNCTION static unsigned long long order_of(index_t object, int offset) {
      constexpr unsigned long long objects = (1ULL << 40) - 1, offsets = (1ULL << 23) - 1;
      const auto at = static_cast<unsigned long long>(object), byte = static_cast<unsigned long long>(offset);
      return (at < objects ? at : objects) << 23 | (byte < offsets ? byte : offsets);
    }
  };

  unsigned long long out_of_range = 0;    ///< finite, and stored as infinity or as the end of the range
  unsigned long long not_a_number = 0;    ///< NaN or infinite values, stored in 16 bits
  unsigned long long not_a_rotation = 0;  ///< matrices, or stored quaternions, that are not rotations
  unsigned long long imprecise = 0;       ///< kept with a larger relative error than relative_error() of the type
  FirstLoss first;                        ///< of the upper three
  FirstLoss first_imprecise;
  unsigned long long worst = 0;  ///< see worst_relative_error()
  index_t objects = 0;           ///< of the array; stores behind them, in padding, do not count

  /// The number of values that are wrong, not only imprecise.
  [[nodiscard]] unsigned long long falsified() const { return out_of_range + not_a_number + not_a_rotation; }
  /// The worst error of the imprecise values; 1 where one became 0.
  [[nodiscard]] double worst_relative_error() const { return std::bit_cast<double>(worst); }

  /// Adds counts made elsewhere. @param further added to object numbers of `other`
  void add(const Losses& other, index_t further = 0) {
    out_of_range += other.out_of_range;
    not_a_number += other.not_a_number;
    not_a_rotation += other.not_a_rotation;
    imprecise += other.imprecise;
    if (worst < other.worst) worst = other.worst;
    const auto adopt = [further](FirstLoss& known, FirstLoss from) {
      if (!from.known()) return;
      from.object += further;
      from.order = FirstLoss::order_of(from.object, from.offset);
      if (from.order < known.order) known = from;
    };
    adopt(first, other.first);
    adopt(first_imprecise, other.first_imprecise);
  }
};

}  // namespace physgen
