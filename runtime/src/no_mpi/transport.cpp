// Without MPI there is one rank.
#include <physgen/distributed/transport.h>

namespace physgen {

std::unique_ptr<Transport> make_transport(const Ranks& /*ranks*/) { return std::make_unique<SelfTransport>(); }

}  // namespace physgen
