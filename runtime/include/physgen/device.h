// The device and its streams: whether there is one, waiting for work, and the rule by which work is ordered.
//
// The rule of streams, for all operations of the library:
//   - An operation is ordered in the stream that it is given, or in the default stream where it takes none. It sees
//     what was ordered in that stream before it, and what is ordered there later sees its result, whichever spaces are
//     involved. So what the host does to pinned memory waits for the stream first. Ordinary host memory (Host) is
//     worked on while a call runs, never later.
//   - Access through a host view, a kernel on the host included, is not an operation: call synchronize(stream) before
//   it.
//   - While a stream is captured in a graph, an operation that would wait or allocate throws an Error that says so, and
//     orders nothing. Still possible are copies between arrays in CUDA memory, and copies without conversion between
//     pinned and CUDA memory; in checked builds only those of the latter kind.
#pragma once

#include <physgen/memory/space.h>

namespace physgen {

/// Whether this build has CUDA and the machine a usable device; found out once.
[[nodiscard]] bool cuda_available();

/// Waits until all work in `stream` is done. Nothing to do without CUDA or a device.
/// @throw Error with CUDA's message when the work failed, and when the stream is being captured
void synchronize(Stream stream = nullptr);

namespace detail {

/// @throw Error naming `what` where the stream is being captured, or, of the default stream, one that waits for it
void refuse_capture(Stream stream, const char* what);

/// Before the host works on memory of this space: waits for the stream where the device may be at it.
inline void wait_for_host_work(SpaceKind space, Stream stream = nullptr) {
  if (space == SpaceKind::pinned) synchronize(stream);
}

}  // namespace detail

}  // namespace physgen
