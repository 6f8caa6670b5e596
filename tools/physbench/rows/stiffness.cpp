// Rows of the CPU: assembly of the stiffness.
#include "../host_rows.h"
#include "../naive_stiffness.h"

namespace physgen::bench {

template struct HostKernel<TetStiffness>;
template struct HostKernel<NodeStiffness>;
template struct HostKernel<EdgeStiffness>;

}  // namespace physgen::bench
