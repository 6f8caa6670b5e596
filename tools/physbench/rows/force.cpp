// Rows of the CPU: forces.
#include "../host_rows.h"

namespace physgen::bench {

template struct HostKernel<ElasticForce>;
template struct HostKernel<GatherForces>;

}  // namespace physgen::bench
