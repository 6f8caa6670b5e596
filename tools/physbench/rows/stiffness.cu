// Rows of the GPU: assembly of the stiffness.
#include "../cuda_rows.h"

namespace physgen::bench {

template struct CudaKernel<TetStiffness>;
template struct CudaKernel<NodeStiffness>;
template struct CudaKernel<EdgeStiffness>;

}  // namespace physgen::bench
