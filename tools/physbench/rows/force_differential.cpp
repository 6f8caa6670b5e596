// Rows of the CPU: force differentials, assembled and per element.
#include "../host_rows.h"

namespace physgen::bench {

template struct HostKernel<AddForceDifferential>;
template struct HostKernel<ElementForceDifferential>;

}  // namespace physgen::bench
