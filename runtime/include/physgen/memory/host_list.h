// Lists of plain values on the host that several threads fill: a std::vector whose new elements are not initialised, so
// that no thread writes them twice, and the one that fills a part is the first to touch its memory.
#pragma once

#include <physgen/detail/list_allocator.h>

#include <vector>

namespace physgen {

/// `HostList<int> list(n)` and resize() leave new elements without a value.
/// @tparam T a trivial type
template <class T>
using HostList = std::vector<T, detail::ListAllocator<T>>;

}  // namespace physgen
