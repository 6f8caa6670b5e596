// Arrays that may lie on a device, for the host: programs are set up there, and results are taken.
#pragma once

#include <physgen/arrays/array.h>
#include <physgen/distributed/cuda/device.h>
#include <physgen/distributed/host_image.h>

#include <type_traits>
#include <utility>

namespace physgen::detail {

/// The array itself where the host reaches it, else one of the host with the same layout and formats.
template <class Of>
using OnHost = std::conditional_t<
    host_accessible(Of::Space::kind), Of,
    Array<typename Of::Object, typename Of::Precision, Host, typename Of::Layout, typename Of::Formats>>;

/// edit(array), or where the host does not reach it, of a copy that then takes its place.
template <class Of, class Edit>
void edit_on_host(Of& array, const Edit& edit) {
  if constexpr (host_accessible(Of::Space::kind)) {
    edit(array);
  } else {
    wait_for_device(Of::Space::kind);
    OnHost<Of> here(array.size());
    copy(here, std::as_const(array));
    edit(here);
    copy(array, std::as_const(here));
  }
}

/// An array of `size` objects; on a device, that of this rank.
template <class Of>
[[nodiscard]] Of make_array(index_t size, const Ranks& ranks, Transport& transport) {
  if constexpr (Of::Space::kind == SpaceKind::cuda) (void)cuda::take_device(ranks, transport);
  return Of(size);
}

}  // namespace physgen::detail
