// Holds what probes have found in a program, for compilers that are asked by running it. Every use of a probe makes an
// object before main() begins, whether the code that uses it ever runs or not.
#pragma once

#include <physgen/detail/probe_uses.h>
#include <physgen/fields/object_info.h>
#include <physgen/memory/space.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

namespace physgen::probe {

/// The uses that a program's code makes of a field of an array.
struct FieldAccess {
  std::string array;   ///< ArrayTag::name
  std::string object;  ///< "elasticity::Tet"
  std::string field;   ///< "nodes"; of fields of nested objects "svd.U", of a fixed array of them "points.x"
  bool read = false;
  bool written = false;
  bool address_taken = false;  ///< and so read, and written where the array is not read-only

  bool operator==(const FieldAccess&) const = default;
};

/// All fields that the program's code reads or writes, one access for each field of each array, ascending. Code is
/// found that was compiled by a compiler of the host: see unseen() for the rest.
[[nodiscard]] inline std::vector<FieldAccess> registered() {
  std::vector<FieldAccess> accesses;
  for (const detail::Use* use = detail::Use::last; use != nullptr; use = use->next) {
    FieldAccess one{use->array, std::string(use->object), std::string(use->field)};
    for (std::size_t at; (at = one.field.find("[0]")) != std::string::npos;) one.field.erase(at, 3);
    auto known = std::ranges::find_if(accesses, [&](const FieldAccess& other) {
      return std::tie(other.array, other.object, other.field) == std::tie(one.array, one.object, one.field);
    });
    if (known == accesses.end()) known = accesses.insert(accesses.end(), one);
    known->read |= use->access == detail::Access::read;
    known->written |= use->access == detail::Access::written;
    known->address_taken |= use->access == detail::Access::address;
  }
  std::ranges::sort(accesses, {}, [](const FieldAccess& one) { return std::tie(one.array, one.object, one.field); });
  return accesses;
}

/// The steps and arrays of which registered() knows nothing, since compilers of the host do not read code for devices:
/// steps by perform() on CUDA, as texts that name their types; and the names of arrays of CUDA of which it has not
/// found a use, as where all kernels over them are __device__ functions. Where there are any, ask `physgen usage`.
[[nodiscard]] inline std::vector<std::string> unseen() {
  std::vector<std::string> names;
  const std::vector<FieldAccess> found = registered();
  for (const detail::ForDevice* one = detail::ForDevice::last; one != nullptr; one = one->next) {
    const bool seen =
        one->is_array && std::ranges::any_of(found, [&](const auto& access) { return access.array == one->what; });
    if (!seen) names.emplace_back(one->what);
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace physgen::probe
