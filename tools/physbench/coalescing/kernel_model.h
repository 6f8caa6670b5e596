// Counts the sectors of a kernel over a small mesh: what the model counts does not depend on size. For the file that
// CMake writes.
#pragma once

#include "coalescing/trace.h"
#include "measure/kernel_case.h"
#include "measure/model.h"
#include "measure/scene_data.h"

namespace physgen::bench {

inline Counters counters_of(const Sectors& sectors) {
  return {{"sectors_per_request", sectors.per_request},
          {"bytes_per_sector", sectors.bytes_per_sector},
          {"requests_per_transaction", 1 / sectors.per_request}};  // a transaction is a sector
}

/// Shared by all models.
inline std::shared_ptr<Scene> small_scene() {
  static const std::shared_ptr<Scene> small = scene_of(20000);
  return small;
}

template <class Kernel, class Layout, class Scheme = SchemaFormats>
bool add_layout_model(const std::string& layout, const std::string& storage = "float") {
  return add_model(std::string(Kernel::name) + "/" + storage + "/" + layout, [] {
    const OnScene<Kernel, float> provider(small_scene());
    KernelArrays<OnScene<Kernel, float>, Host, Traced<Layout>, Scheme> arrays(provider);
    return counters_of(count_sectors(arrays.kernel(), provider.objects()));
  });
}

template <class Kernel>
bool add_kernel_model() {
  if constexpr (requires { Kernel::only_aos; }) return add_layout_model<Kernel, Aos>(Kernel::only_aos);
  if constexpr (!requires { Kernel::only_aos; } && !requires { Kernel::few_layouts; }) {
    add_layout_model<Kernel, Aos>("aos");
    add_layout_model<Kernel, Soa>("soa");
    add_layout_model<Kernel, Aosoa<32>>("aosoa32");
  }
  return true;
}

}  // namespace physgen::bench
