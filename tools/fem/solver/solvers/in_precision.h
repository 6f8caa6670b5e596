// Precisions that are chosen at run time, as types.
#pragma once

#include <fem/solver/arrays/stored.h>
#include <fem/solver/settings.h>

namespace physgen::fem {

/// Calls make.operator()<Real, Stored>() for a precision: of the tangent, and how preconditioners store their matrices.
template <class Make>
auto in_precision(TangentPrecision precision, const Make& make) {
  switch (precision) {
    case TangentPrecision::half:
      return make.template operator()<float, StoredInHalf>();
    case TangentPrecision::float32:
      return make.template operator()<float, StoredAsComputed>();
    case TangentPrecision::float64:
      break;
  }
  return make.template operator()<double, StoredAsComputed>();
}

}  // namespace physgen::fem
