// Rows of the CPU: from nodes to stress.
#include "../host_rows.h"

namespace physgen::bench {

template struct HostKernel<DeformationGradient>;
template struct HostKernel<Svd>;
template struct HostKernel<Stress>;

}  // namespace physgen::bench
