// Rows of the CPU: derivatives of the stress.
#include "../host_rows.h"

namespace physgen::bench {

template struct HostKernel<StressDerivative>;
template struct HostKernel<DpFromDf>;

}  // namespace physgen::bench
