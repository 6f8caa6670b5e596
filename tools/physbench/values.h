// The inputs of a kernel as values, for code that works on one object at a time.
#pragma once

#include <tuple>
#include <vector>

#include "operands.h"

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
template <class View>
Values(View) -> Values<View>;

namespace detail {
template <class Kernel, class Visit, class... Source>
void with_inputs(Dataset& data, const Visit& visit, Inputs<Source...> /*list*/) {
  visit(Source::of(data)...);
}
}  // namespace detail

/// Calls visit(inputs...) with the master arrays that a kernel reads.
template <class Kernel, class Visit>
void with_inputs(Dataset& data, const Visit& visit) {
  detail::with_inputs<Kernel>(data, visit, typename Kernel::Reads());
}

/// An input in Real: a part of its master array, rounded. In AoSoA, or as a vector of structs.
template <class Real, class Source>
auto rounded(Dataset& data, Domain kernel_domain) {
  const index_t count = data.count(Source::domain, kernel_domain);
  Array<typename Source::Object, Real, Host, Aosoa<16>> to(count);
  copy_first(to.storage(), Source::of(data).storage(), count);
  return to;
}
template <class Real, class Source>
auto structs(Dataset& data, Domain kernel_domain) {
  const auto array = rounded<Real, Source>(data, kernel_domain);
  std::vector<typename Source::Object::template Value<Real>> to(static_cast<std::size_t>(array.size()));
  const auto view = array.view();
#pragma omp parallel for schedule(static)
  for (index_t i = 0; i < view.size(); ++i) to[static_cast<std::size_t>(i)] = view.get(i);
  return to;
}

}  // namespace physgen::bench
