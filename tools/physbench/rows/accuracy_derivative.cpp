// Rows of the sets on the CPU: derivatives of the stress.
#include "../accuracy/host_set_rows.h"

namespace physgen::bench {

template struct HostVariant<PlainStressDerivative, float>;
template struct HostVariant<PlainStressDerivative, double>;
template struct HostVariant<ClampedStressDerivative, float>;
template struct HostVariant<ClampedStressDerivative, double>;
template struct HostVariant<AbsoluteStressDerivative, float>;
template struct HostVariant<AbsoluteStressDerivative, double>;
template struct HostVariant<DpFromDfVariant, float>;
template struct HostVariant<DpFromDfVariant, double>;

}  // namespace physgen::bench
