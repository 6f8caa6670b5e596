// Exchanges between arrays on devices.
#pragma once

#include <physgen/distributed/halo_exchange.h>
#include <physgen/distributed/transport.h>
#include <physgen/memory/space.h>

#include <memory>

namespace physgen::cuda {

/// Kernels pack fields into the messages and unpack them, in `stream`. Allocates where an exchange is longer than those
/// before it, which cannot be captured in a graph.
/// @param transport of device memory. @pre it and `arrays` outlive this, and cut() was called
/// @throw Error when an array of which ranks have parts lies in other memory than CUDA's
[[nodiscard]] std::unique_ptr<HaloExchange> make_device_exchange(Partition& arrays, Transport& transport,
                                                                 Stream stream);

}  // namespace physgen::cuda
