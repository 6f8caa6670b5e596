// The bytes that a row must move, from what its kernels are: probes find which fields they read and write, the formats
// say how many bytes these take, and the row how many objects there are. For the C++ compiler: once per kernel.
//
// - A field that a launch reads counts once per object, however many objects gather it.
// - A field of an output that is written counts once. What a launch reads of a field that it also writes is a sum under
//   way, and so is what an earlier launch cleared: neither counts. Outputs of rows begin without values.
// - A field that one launch writes and a later one reads lies in memory in between, and so counts twice; what launches
//   hand on in locals of a fused group lies in no array, and counts nothing.
// - A row that runs a scene's program has one launch here: each of its fields is read by one step at most.
#pragma once

#include <physgen/probe.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "measure/scene_data.h"
#include "measure/set_data.h"

namespace physgen::bench {

namespace detail {

/// Whether the row runs a scene's program, whose steps are looked at together: what one of them writes others read, and
/// none is a sum under way.
template <class Kernel>
concept ProgramRow = requires { Kernel::is_program; };

template <class Array>
constexpr const char* text_that_names() {
  return __PRETTY_FUNCTION__;
}

/// Array k of the inputs or of the outputs of a row, as one of its launches sees it.
template <class Kernel, class Real, class Scheme, std::size_t launch, bool output, std::size_t k>
struct RowArray {
  static constexpr const char* name = text_that_names<RowArray>();
};

/// The probes of ArraysOf<List, ...>.
template <class Kernel, class Real, class Scheme, std::size_t launch, bool output>
auto row_probes() {
  using List = std::conditional_t<output, typename Kernel::Writes, typename Kernel::Reads>;
  using Arrays = ArraysOf<List, Real, Host, Aosoa<16>, Scheme>;
  return []<std::size_t... k>(std::index_sequence<k...> /*which*/) {
    return std::tuple<ProbeOf<std::tuple_element_t<k, Arrays>, RowArray<Kernel, Real, Scheme, launch, output, k>>...>();
  }(std::make_index_sequence<std::tuple_size_v<Arrays>>());
}

template <class Kernel, class Real, class Scheme, std::size_t launch>
auto probed_kernel() {
  const auto inputs = row_probes<Kernel, Real, Scheme, launch, false>();
  auto outputs = row_probes<Kernel, Real, Scheme, launch, true>();
  return kernel_over<Kernel, Real>(inputs, outputs);
}

/// The number of launches of a row.
template <class Kernel, class Real, class Scheme>
constexpr std::size_t launches() {
  using Launched = decltype(probed_kernel<Kernel, Real, Scheme, 0>());
  if constexpr (requires(const Launched& launched) { launched.links; }) {
    return std::tuple_size_v<decltype(Launched::links)>;
  } else {
    return 1;
  }
}

/// Makes a launch known to the compiler; runs nothing.
template <class Kernel, class Real, class Scheme, std::size_t launch>
void look_at_launch() {
  const auto launched = probed_kernel<Kernel, Real, Scheme, launch>();
  ProbeExecutor<Host> on;
  if constexpr (requires { launched.links; }) {
    on.run(0, std::get<launch>(launched.links).kernel);
  } else if constexpr (ProgramRow<Kernel>) {
    launched.launch([&on](index_t objects, const auto& kernel) { on.run(objects, kernel); });
  } else if constexpr (requires { Kernel::perform(launched); }) {
    on.perform([&launched](Stream /*stream*/) { Kernel::perform(launched); });
  } else {
    on.run(0, launched);
  }
}

/// The uses that a launch makes of a field of one of its arrays.
inline probe::FieldAccess access_of(const std::string& array, std::string field) {
  static const std::vector<probe::FieldAccess> all = probe::registered();
  for (std::size_t at; (at = field.find('[')) != std::string::npos;) field.erase(at, field.find(']') + 1 - at);
  const auto found =
      std::ranges::find_if(all, [&](const auto& row) { return row.array == array && row.field == field; });
  return found == all.end() ? probe::FieldAccess{} : *found;
}

/// The number of times that the row moves field f of an array.
template <class Kernel, class Real, class Scheme, bool output, std::size_t k>
int times_moved(const std::string& field) {
  return []<std::size_t... launch>(const std::string& of, std::index_sequence<launch...> /*which*/) {
    int reads = 0;
    bool written = false;
    const auto add = [&](const probe::FieldAccess& use) {
      if (use.read && (!use.written || ProgramRow<Kernel>)) ++reads;
      written |= use.written;
    };
    (add(access_of(RowArray<Kernel, Real, Scheme, launch, output, k>::name, of)), ...);
    return reads + (written ? 1 : 0);
  }(field, std::make_index_sequence<launches<Kernel, Real, Scheme>()>());
}

/// The bytes of the inputs or of the outputs.
template <class Kernel, class Real, class Scheme, bool output, class Count>
double bytes_of_arrays(const Count& count) {
  using List = std::conditional_t<output, typename Kernel::Writes, typename Kernel::Reads>;
  using Arrays = ArraysOf<List, Real, Host, Aosoa<16>, Scheme>;
  double bytes = 0;
  const auto add = [&]<std::size_t k>(std::integral_constant<std::size_t, k> /*which*/) {
    using Array = std::tuple_element_t<k, Arrays>;
    for (const FieldInfo& field : Array::Object::template fields<Real, typename Array::Formats>) {
      bytes += times_moved<Kernel, Real, Scheme, output, k>(std::string(field.name)) *
               static_cast<double>(element_bytes(field.type) * field.count) *
               static_cast<double>(count(domain_of<List>(k)));
    }
  };
  [&]<std::size_t... k>(std::index_sequence<k...> /*which*/) {
    (add(std::integral_constant<std::size_t, k>()), ...);
  }(std::make_index_sequence<std::tuple_size_v<Arrays>>());
  return bytes;
}

}  // namespace detail

/// @tparam Kernel a kernel's description: its launches are those of Kernel::run(), or the code of Kernel::perform()
/// @tparam Scheme names the formats
/// @param count count(domain): how many objects arrays of a Domain have
template <class Kernel, class Real, class Scheme = SchemaFormats, class Count>
[[nodiscard]] double row_bytes(const Count& count) {
  if (false) {
    []<std::size_t... launch>(std::index_sequence<launch...> /*which*/) {
      (detail::look_at_launch<Kernel, Real, Scheme, launch>(), ...);
    }(std::make_index_sequence<detail::launches<Kernel, Real, Scheme>()>());
  }
  return detail::bytes_of_arrays<Kernel, Real, Scheme, false>(count) +
         detail::bytes_of_arrays<Kernel, Real, Scheme, true>(count);
}

template <class Kernel, class Real>
double OnScene<Kernel, Real>::bytes() const {
  return bytes_in<SchemaFormats>();
}
template <class Kernel, class Real>
template <class Scheme>
double OnScene<Kernel, Real>::bytes_in() const {
  return row_bytes<Kernel, Real, Scheme>([this](Domain domain) { return count(domain); });
}
template <class Kernel, class Real>
double OnSet<Kernel, Real>::bytes() const {
  return row_bytes<Kernel, Real>([this](Domain domain) { return count(domain); });
}

}  // namespace physgen::bench
