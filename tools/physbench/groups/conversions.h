// The common part of the rows of conversions: objects of 36 and of 48 bytes, and the check that a copy arrived.
#pragma once

#include <elasticity.physgen.h>
#include <physgen/detail/host_loop.h>
#include <physgen/error.h>

#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "measure/registry.h"

namespace physgen::bench {

/// Object types that are converted: 9 and 12 scalars.
struct Bytes36 {
  using Object = elasticity::DeformationGradientObject;
  static constexpr const char* suffix = "36";
};
struct Bytes48 {
  using Object = elasticity::StressDerivativeObject;
  static constexpr const char* suffix = "48";
};

template <class Layout>
std::string layout_name() {
  if constexpr (requires { Layout::tile; }) {
    return Layout::name + std::to_string(Layout::tile);
  } else {
    return Layout::name;
  }
}

/// Random objects.
template <class Array>
void fill_random(Array& array) {
  const auto view = array.view();
  constexpr int elements = Array::elements;
  physgen::detail::host_loop(view.size(), [&](index_t i) {
    std::mt19937 random(static_cast<unsigned>(i));
    for (int k = 0; k < elements; ++k) array.putdata(i, k, static_cast<double>(random()) * 0x1p-31 - 1);
  });
}

/// The largest error of an element of each object; elements lie between -1 and 1. Both on the host.
template <class A, class B>
Accuracy compare_copies(const A& result, const B& expected) {
  std::vector<double> errors(static_cast<std::size_t>(result.size()));
  physgen::detail::host_loop(result.size(), [&](index_t i) {
    double worst = 0;
    for (int k = 0; k < A::elements; ++k) {
      const double error = std::abs(result.getdata(i, k) - expected.getdata(i, k));
      if (!(error <= worst)) worst = error;
    }
    errors[static_cast<std::size_t>(i)] = worst;
  });
  fem::reference::ErrorDistribution distribution;
  distribution.reserve(errors.size());
  for (const double error : errors) distribution.add(error);
  Accuracy accuracy;
  accuracy.errors = distribution.summary();
  if (!(accuracy.errors.max <= 1e-2))
    throw Error("a copy did not arrive: an element is off by " + std::to_string(accuracy.errors.max));
  return accuracy;
}

/// A copy between two arrays in spaces that the device's clock sees. @param bytes read and written per object
template <class Device, class Source, class Target>
Case conversion_case(index_t objects, double bytes) {
  using Values = Array<typename Source::Object, float, Host, Aos>;
  struct State {
    Values values;
    Source from;
    Target to;
  };
  const auto state = std::make_shared<State>(State{Values(objects), Source(objects), Target(objects)});
  fill_random(state->values);
  copy(state->from, state->values);
  synchronize();
  Case made;
  made.bytes = bytes * static_cast<double>(objects);
  made.run = [state] { return Device::time([&] { copy(state->to, state->from); }); };
  made.copy = Device::copy(made.bytes);
  made.check = [state, run = made.run] {
    Device::poison(state->to.untyped());
    run();
    Values result(state->to.size());
    copy(result, state->to);
    synchronize();
    return compare_copies(result, state->values);
  };
  return made;
}

/// The row of a conversion. @param make make() is its case
template <class Type, class Make>
void add_conversion(std::vector<Row>& rows, const std::string& kernel, const std::string& layouts, const char* storage,
                    SpaceKind space, index_t objects, const Make& make) {
  Row row;
  row.kernel = kernel + Type::suffix;
  row.layout = layouts;
  row.storage = storage;
  row.space = name(space);
  row.objects = objects;
  const double bytes = 4 * static_cast<double>(objects) * Array<typename Type::Object, float, Host, Aos>::record_bytes;
  row.host_bytes = bytes;
  row.device_bytes = space == SpaceKind::cuda ? bytes : 0;
  row.make = make;
  rows.push_back(std::move(row));
}

/// Copies on one device. @tparam ToFormats of the target
template <class Device, class Type, class From, class To,
          class ToFormats = FormatsOf<typename Type::Object, typename Device::Space>>
void add_copy(std::vector<Row>& rows, index_t objects, const char* storage = "float") {
  using Space = typename Device::Space;
  using Source = Array<typename Type::Object, float, Space, From>;
  using Target = Array<typename Type::Object, float, Space, To, ToFormats>;
  add_conversion<Type>(
      rows, "convert_", layout_name<From>() + "_to_" + layout_name<To>(), storage, Space::kind, objects, [objects] {
        return conversion_case<Device, Source, Target>(objects, Source::record_bytes + Target::record_bytes);
      });
}

}  // namespace physgen::bench
