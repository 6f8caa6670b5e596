// Rows of the sets on the GPU: derivatives of the stress.
#include "../accuracy/cuda_set_rows.h"

namespace physgen::bench {

template struct CudaVariant<PlainStressDerivative, float>;
template struct CudaVariant<PlainStressDerivative, double>;
template struct CudaVariant<ClampedStressDerivative, float>;
template struct CudaVariant<ClampedStressDerivative, double>;
template struct CudaVariant<AbsoluteStressDerivative, float>;
template struct CudaVariant<AbsoluteStressDerivative, double>;
template struct CudaVariant<DpFromDfVariant, float>;
template struct CudaVariant<DpFromDfVariant, double>;

}  // namespace physgen::bench
