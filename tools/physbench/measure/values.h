// Arrays as values of one object at a time, for the kernels' references.
#pragma once

#include <tuple>
#include <vector>

#include "data/operands.h"

namespace physgen::bench {

/// values[i] of the objects of a view or of a vector.
template <class View>
struct Values {
  View view;
  auto operator[](index_t i) const { return view.get(i); }
};
template <class T>
struct Values<const std::vector<T>*> {
  const std::vector<T>* vector;
  const T& operator[](index_t i) const { return (*vector)[static_cast<std::size_t>(i)]; }
};

/// Calls use(values...) with the values of each array of a tuple.
template <class Tuple, class Use>
auto with_values(const Tuple& arrays, const Use& use) {
  return std::apply([&use](const auto&... array) { return use(Values{array.view()}...); }, arrays);
}

/// The values of object i, one of each array.
template <class Tuple>
auto values_at(const Tuple& arrays, index_t i) {
  return std::apply([i](const auto&... array) { return std::make_tuple(array.view().get(i)...); }, arrays);
}

}  // namespace physgen::bench
