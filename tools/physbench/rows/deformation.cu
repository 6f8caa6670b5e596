// Rows of the GPU: from nodes to stress.
#include "../cuda_rows.h"

namespace physgen::bench {

template struct CudaKernel<DeformationGradient>;
template struct CudaKernel<Svd>;
template struct CudaKernel<Stress>;

}  // namespace physgen::bench
