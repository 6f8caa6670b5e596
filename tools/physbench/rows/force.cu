// Rows of the GPU: forces.
#include "../cuda_rows.h"

namespace physgen::bench {

template struct CudaKernel<ElasticForce>;
template struct CudaKernel<GatherForces>;

}  // namespace physgen::bench
