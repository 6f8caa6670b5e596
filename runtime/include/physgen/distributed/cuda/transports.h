// How the memory of devices crosses between ranks: by NCCL, from device to device; or through pinned memory of the host
// and MPI.
#pragma once

#include <physgen/distributed/cuda/nccl.h>
#include <physgen/distributed/transport.h>
#include <physgen/memory/space.h>

#include <memory>
#include <string>

namespace physgen::cuda {

/// A transport of messages in device memory, and which one it is.
struct DeviceTransport {
  std::unique_ptr<Transport> transport;
  std::string name;  ///< "NCCL 2.28.9", or "pinned memory and MPI, since ..." with the reason
};

/// Messages and gathered bytes lie in the memory of the current device. What is sent is read behind all that `stream`
/// had before begin() or gather(); what is received is there for all that it gets behind end() or gather(). Gathered
/// are as many bytes of each rank.
/// @param host crosses what is agreed on, and what goes through pinned memory
/// @param uses_nccl NCCL where all ranks have it, each with a device of its own; else pinned memory
/// @throw Error when ranks share a device without being allowed to (take_device())
[[nodiscard]] DeviceTransport make_device_transport(const Ranks& ranks, Transport& host, Stream stream, bool uses_nccl);

/// The first of all ranks' reasons; empty where none has one. All ranks call it together.
[[nodiscard]] std::string reason_of_all(const std::string& mine, Transport& host);

/// Through pinned memory. The host waits in begin() and in gather().
[[nodiscard]] std::unique_ptr<Transport> make_pinned_transport(Transport& host, Stream stream);

/// Through NCCL, in a stream beside `stream`; the host never waits, and all of it can be captured in a graph.
/// @param why_not is given the reason where this returns null, on all ranks
[[nodiscard]] std::unique_ptr<Transport> make_nccl_transport(Transport& host, Stream stream, std::string& why_not);

}  // namespace physgen::cuda
