// Inputs from the scene, references and errors of its rows. For the C++ compiler: instantiated once per kernel.
#pragma once

#include <physgen/detail/host_loop.h>

#include <map>
#include <string>
#include <utility>

#include "measure/errors.h"
#include "measure/row_bytes.h"
#include "measure/scene_data.h"
#include "measure/values.h"

namespace physgen::bench {

namespace detail {

template <class... Operand>
Masters<Operands<Operand...>> masters_of(Scene& scene, Operands<Operand...> /*list*/) {
  return {Operand::Source::of(scene)...};
}

/// The values of a kernel's outputs that are compared: all of them, or the last.
template <class Kernel, class T, class... Value>
auto observed(const Value&... value) {
  if constexpr (requires { Kernel::template observe<T>(value...); }) {
    return Kernel::template observe<T>(value...);
  } else {
    return Kernel::template observe<T>(std::get<sizeof...(Value) - 1>(std::tie(value...)));
  }
}

}  // namespace detail

/// The functions that make the arrays that kernels write, by the kernels' names. Each is added where its kernel's rows
/// are compiled, so that no other file compiles its reference again.
using Maker = const void* (*)(Scene&);
inline std::map<std::string, Maker>& makers() {
  static std::map<std::string, Maker> all;
  return all;
}

template <class Kernel>
const void* make_output(Scene& scene) {
  using Array = Master<typename Kernel::Output>;
  return &scene.once<Array>(Kernel::name, [&scene] {
    Array output(scene.count(Kernel::domain, Domain::nodes));
    const auto view = output.view();
    with_values(detail::masters_of(scene, typename Kernel::Reads()), [&view](const auto&... input) {
      physgen::detail::host_loop(view.size(),
                                 [&](index_t i) { view.put(i, Kernel::template naive<double, double>(i, input...)); });
    });
    return output;
  });
}

template <class Kernel>
const Master<typename Kernel::Output>& OutputOf<Kernel>::of(Scene& scene) {
  return *static_cast<const Master<typename Kernel::Output>*>(makers().at(Kernel::name)(scene));
}

template <class Kernel, class Real>
Masters<typename Kernel::Reads> OnScene<Kernel, Real>::inputs() const {
  return detail::masters_of(*scene_, typename Kernel::Reads());
}

template <class Kernel, class Real>
template <class At>
Accuracy OnScene<Kernel, Real>::compare(const At& at) const {
  using T = Wider<Real>;
  const auto of_object = [](index_t i, const auto&... input) {
    return Kernel::template observe<T>(Kernel::template naive<T, Real>(i, input...));
  };
  using Inputs = HostArrays<typename Kernel::Reads, Real>;
  const auto make_references = [&] {
    auto rounded = make_arrays<Inputs>([&](std::size_t k) { return count(domain_of<typename Kernel::Reads>(k)); });
    copy_arrays(rounded, inputs());
    return with_values(rounded, [&](const auto&... input) {
      std::vector<decltype(of_object(0, input...))> all(static_cast<std::size_t>(objects()));
      physgen::detail::host_loop(objects(),
                                 [&](index_t i) { all[static_cast<std::size_t>(i)] = of_object(i, input...); });
      return all;
    });
  };
  const auto& references = scene_->latest<decltype(make_references())>(
      std::string(Kernel::name) + "/" + storage_name<Real>(), make_references);
  std::vector<double> errors(references.size()), norms(references.size());
  physgen::detail::host_loop(objects(), [&](index_t i) {
    const auto& expected = references[static_cast<std::size_t>(i)];
    const auto got = std::apply([](const auto&... value) { return detail::observed<Kernel, T>(value...); }, at(i));
    errors[static_cast<std::size_t>(i)] = static_cast<double>((got - expected).norm());
    norms[static_cast<std::size_t>(i)] = static_cast<double>(expected.norm());
  });
  return relative_errors(std::move(errors), norms);
}

template <class Kernel, class Real>
Accuracy OnScene<Kernel, Real>::check(const HostArrays<typename Kernel::Writes, Real>& results) const {
  if constexpr (requires { typename Kernel::CheckedAs; }) {
    return OnScene<typename Kernel::CheckedAs, Real>(scene_).check(results);
  } else {
    for_each_array(results, [](const auto& array, std::size_t /*k*/) { check_written(array.untyped()); });
    return compare([&results](index_t i) { return values_at(results, i); });
  }
}

}  // namespace physgen::bench
