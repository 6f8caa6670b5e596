// Rows of the CPU: a kernel in every layout and storage, and the naive kernel over plain structs, which is called
// `eigen`. For the files that CMake writes from instantiate.cpp.in.
#pragma once

#include <cstring>
#include <memory>

#include "measure/host.h"
#include "measure/kernel_case.h"
#include "measure/registry.h"
#include "measure/values.h"

namespace physgen::bench {

namespace detail {

/// The inputs of a kernel, as vectors of structs.
template <class Provider>
auto structs_of(const Provider& provider) {
  using Reads = typename Provider::Kernel::Reads;
  auto rounded = make_arrays<HostArrays<Reads, typename Provider::Real>>(
      [&](std::size_t k) { return provider.count(domain_of<Reads>(k)); });
  copy_arrays(rounded, provider.inputs());
  return std::apply(
      [](const auto&... array) {
        const auto one = [](const auto& from) {
          std::vector<typename std::remove_cvref_t<decltype(from)>::Value> to(static_cast<std::size_t>(from.size()));
          const auto view = from.view();
          physgen::detail::host_loop(view.size(), [&](index_t i) { to[static_cast<std::size_t>(i)] = view.get(i); });
          return to;
        };
        return std::make_tuple(one(array)...);
      },
      rounded);
}

}  // namespace detail

/// The naive kernel over std::vectors of structs: what one writes without this project.
template <class Provider>
Case eigen_case(const Provider& provider) {
  using Kernel = typename Provider::Kernel;
  using Real = typename Provider::Real;
  using Value = typename Kernel::Output::template Value<Real>;
  auto given = detail::structs_of(provider);
  struct State {
    decltype(given) inputs;
    std::vector<Value> output;
  };
  const auto state = std::make_shared<State>(
      State{std::move(given), std::vector<Value>(static_cast<std::size_t>(provider.objects()))});
  Case made;
  made.bytes = provider.bytes();
  made.run = [state] {
    const auto n = static_cast<index_t>(state->output.size());
    auto& output = state->output;
    return HostDevice::time([&] {
      std::apply(
          [&](const auto&... input) {
            physgen::detail::for_each_index(0, n, [&](index_t i) {
              output[static_cast<std::size_t>(i)] = Kernel::template naive<Real, Real>(i, Values{&input}...);
            });
          },
          state->inputs);
    });
  };
  made.copy = HostDevice::copy(made.bytes);
  made.check = [state, provider, run = made.run] {
    // NaN, as poison() does
    std::memset(static_cast<void*>(state->output.data()), 0xff, state->output.size() * sizeof(Value));
    run();
    return provider.compare(
        [&state](index_t i) { return std::tie(std::as_const(state->output)[static_cast<std::size_t>(i)]); });
  };
  return made;
}

/// Rows of one kernel and storage: in every layout, or those that its description allows.
template <class Provider>
void add_layouts(std::vector<Row>& rows, const Provider& provider) {
  using Kernel = typename Provider::Kernel;
  const Adder<HostDevice, Provider> of(rows, provider);
  constexpr bool single = sizeof(typename Provider::Real) == sizeof(float);
  if constexpr (requires { Kernel::only_aos; }) {
    of.template layout<Aos>(Kernel::only_aos);
  } else if constexpr (requires { Kernel::few_layouts; }) {
    of.copy();
    of.template layout<Aos>("aos");
    of.template layout<Aosoa<16>>("aosoa16");
  } else {
    of.copy();
    if constexpr (single) of.add("eigen", [provider] { return eigen_case(provider); });
    // AoS by packs that collect their lanes, and object by object: which of them is faster differs.
    using Function = decltype(std::declval<KernelArrays<Provider, Host, Aos>&>().kernel());
    if constexpr (physgen::detail::widest_lanes(std::type_identity<Function>()) > 1)
      of.template layout<Aos, 1>("aos_scalar");
    of.template layout<Aos>("aos");
    of.template layout<Soa>("soa");
    of.template layout<Aosoa<16>>("aosoa16");
    if constexpr (single) of.template layout<Aosoa<32>>("aosoa32");
  }
}

}  // namespace physgen::bench
