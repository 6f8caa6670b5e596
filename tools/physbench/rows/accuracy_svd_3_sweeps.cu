// Rows of the sets on the GPU: the SVD with 3 sweeps.
#include "../accuracy/cuda_set_rows.h"

namespace physgen::bench {

template struct CudaVariant<SvdVariant<3>, float>;
template struct CudaVariant<SvdVariant<3>, double>;

}  // namespace physgen::bench
