// Rows of the sets on the GPU: parts of the SVD, and other forms of it.
#include "../accuracy/cuda_set_rows.h"

namespace physgen::bench {

template struct CudaVariant<SvdQuaternions, float>;
template struct CudaVariant<SvdQuaternions, double>;
template struct CudaVariant<SvdWithoutU, float>;
template struct CudaVariant<SvdWithoutU, double>;
template struct CudaVariant<SvdWithoutV, float>;
template struct CudaVariant<SvdWithoutV, double>;
template struct CudaVariant<SingularValues, float>;
template struct CudaVariant<SingularValues, double>;
template struct CudaVariant<PolarRotation, float>;
template struct CudaVariant<PolarRotation, double>;

}  // namespace physgen::bench
