// Rows of the GPU: derivatives of the stress.
#include "../cuda_rows.h"

namespace physgen::bench {

template struct CudaKernel<StressDerivative>;
template struct CudaKernel<DpFromDf>;

}  // namespace physgen::bench
