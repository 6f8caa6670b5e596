// Rows of the sets on the GPU: the SVD.
#include "../accuracy/cuda_set_rows.h"

namespace physgen::bench {

template struct CudaVariant<SvdVariant<4>, float>;
template struct CudaVariant<SvdVariant<4>, double>;

}  // namespace physgen::bench
