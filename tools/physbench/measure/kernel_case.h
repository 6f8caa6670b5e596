// The one case of all kernels: its arrays, from either provider of data, in one layout, storage and space, on either
// device.
//
// A provider of data is `template <class Kernel, class Real> class OnScene`, or OnSet, with
//
//   index_t objects(), count(Domain), results(Domain)  // that the kernel runs over; of an array; of it to be checked
//   double bytes(), memory()                           // that the kernel must move; of the host, beside the arrays
//   std::string set(); auto inputs();                  // in the row's name; a tuple of host arrays, read by the kernel
//   Accuracy check(const HostArrays<Writes, Real>&)    // of the first results(domain) of each output
//   Accuracy compare(const At& at)                     // the same, at(i) being a tuple of values of the outputs
#pragma once

#include <memory>
#include <utility>

#include "data/operands.h"
#include "measure/row.h"

namespace physgen::bench {

/// Inputs in place, and outputs.
template <class Provider, class Space, class Layout, class Scheme = SchemaFormats>
struct KernelArrays {
  using Kernel = typename Provider::Kernel;
  using Real = typename Provider::Real;
  ArraysOf<typename Kernel::Reads, Real, Space, Layout, Scheme> inputs;
  ArraysOf<typename Kernel::Writes, Real, Space, Layout, Scheme> outputs;

  explicit KernelArrays(const Provider& provider)
      : inputs(make_arrays<decltype(inputs)>(
            [&](std::size_t k) { return provider.count(domain_of<typename Kernel::Reads>(k)); })),
        outputs(make_arrays<decltype(outputs)>(
            [&](std::size_t k) { return provider.count(domain_of<typename Kernel::Writes>(k)); })) {
    copy_arrays(inputs, provider.inputs());
  }
  [[nodiscard]] auto kernel() { return kernel_over<Kernel, Real>(inputs, outputs); }
};

/// Runs a kernel over its objects, or each kernel of a chain or of a scene's program.
template <class Device, int kLanes = 0>
struct Launch {
  template <class Kernel>
  void operator()(index_t objects, const Kernel& kernel) const {
    if constexpr (requires { kernel.launch(Launch()); }) {
      kernel.launch(Launch());
    } else {
      Device::template run<kLanes>(objects, kernel);
    }
  }
};

/// @param launch launch(objects, kernel) runs it @param bytes it must move; 0: what the kernel's description says
template <class Device, class Layout, class Scheme = SchemaFormats, class Provider, class Launching>
Case kernel_case(const Provider& provider, const Launching& launch, double bytes = 0) {
  using Kernel = typename Provider::Kernel;
  struct State {
    Provider provider;
    KernelArrays<Provider, typename Device::Space, Layout, Scheme> arrays;
  };
  const auto state = std::make_shared<State>(State{provider, decltype(State::arrays)(provider)});
  Case made;
  made.bytes = bytes > 0 ? bytes : provider.bytes();
  made.run = [state, launch] {
    const auto kernel = state->arrays.kernel();
    return Device::time([&] { launch(state->provider.objects(), kernel); });
  };
  made.copy = Device::copy(made.bytes);
  made.check = [state, run = made.run] {
    for_each_array(state->arrays.outputs, [](auto& array, std::size_t /*k*/) { Device::poison(array.untyped()); });
    run();
    using Writes = typename Kernel::Writes;
    auto results = make_arrays<HostArrays<Writes, typename Provider::Real>>(
        [&](std::size_t k) { return state->provider.results(domain_of<Writes>(k)); });
    copy_arrays(results, state->arrays.outputs);
    return state->provider.check(results);
  };
  return made;
}

/// The copy alone.
template <class Device>
Case copy_case(double bytes) {
  Case made;
  made.bytes = bytes;
  made.run = made.copy = Device::copy(bytes);
  return made;
}

/// The part of a row that kernel and provider decide. @param bytes as for kernel_case()
template <class Provider>
Row describe(const Provider& provider, const std::string& layout, SpaceKind space, double bytes = 0) {
  Row row;
  row.kernel = Provider::Kernel::name;
  row.layout = layout;
  row.storage = storage_name<typename Provider::Real>();
  row.space = name(space);
  row.set = provider.set();
  row.errors_in_eps = Provider::errors_in_eps;
  row.objects = provider.objects();
  const double moved = 2 * (bytes > 0 ? bytes : provider.bytes());  // by the kernel, and by the copy beside it
  row.host_bytes = provider.memory() + (space == SpaceKind::host ? moved : 0);
  row.device_bytes = space == SpaceKind::host ? 0 : moved;
  return row;
}

/// The rows of one kernel and provider on one device.
template <class Device, class Provider>
class Adder {
 public:
  Adder(std::vector<Row>& rows, Provider provider) : rows_(rows), provider_(std::move(provider)) {}

  /// @param make make() is the row's case
  template <class Make>
  Row& add(const std::string& layout, const Make& make, double bytes = 0) const {
    Row row = describe(provider_, layout, Device::Space::kind, bytes);
    row.make = make;
    rows_.push_back(std::move(row));
    return rows_.back();
  }
  template <class Layout, int kLanes = 0>
  Row& layout(const std::string& label) const {
    return add(label, [p = provider_] { return kernel_case<Device, Layout>(p, Launch<Device, kLanes>()); });
  }
  /// In the formats of a scheme, which the row's storage names.
  template <class Scheme, class Layout>
  Row& scheme(const std::string& label) const {
    const double bytes = provider_.template bytes_in<Scheme>();
    Row& row = add(
        label, [p = provider_, bytes] { return kernel_case<Device, Layout, Scheme>(p, Launch<Device>(), bytes); },
        bytes);
    row.storage = Scheme::name;
    return row;
  }
  void copy() const {
    add("copy", [bytes = provider_.bytes()] { return copy_case<Device>(bytes); });
  }

 private:
  std::vector<Row>& rows_;
  Provider provider_;
};

}  // namespace physgen::bench
