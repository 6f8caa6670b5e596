// Rows of the GPU: force differentials, assembled and per element.
#include "../cuda_rows.h"

namespace physgen::bench {

template struct CudaKernel<AddForceDifferential>;
template struct CudaKernel<ElementForceDifferential>;

}  // namespace physgen::bench
