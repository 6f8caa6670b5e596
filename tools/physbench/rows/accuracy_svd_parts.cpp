// Rows of the sets on the CPU: parts of the SVD, and other forms of it.
#include "../accuracy/host_set_rows.h"

namespace physgen::bench {

template struct HostVariant<SvdQuaternions, float>;
template struct HostVariant<SvdQuaternions, double>;
template struct HostVariant<SvdWithoutU, float>;
template struct HostVariant<SvdWithoutU, double>;
template struct HostVariant<SvdWithoutV, float>;
template struct HostVariant<SvdWithoutV, double>;
template struct HostVariant<SingularValues, float>;
template struct HostVariant<SingularValues, double>;
template struct HostVariant<PolarRotation, float>;
template struct HostVariant<PolarRotation, double>;

}  // namespace physgen::bench
