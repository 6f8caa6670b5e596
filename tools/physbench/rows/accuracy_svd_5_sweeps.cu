// Rows of the sets on the GPU: the SVD with 5 sweeps.
#include "../accuracy/cuda_set_rows.h"

namespace physgen::bench {

template struct CudaVariant<SvdVariant<5>, float>;
template struct CudaVariant<SvdVariant<5>, double>;

}  // namespace physgen::bench
