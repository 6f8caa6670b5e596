// Rows of the sets on the CPU: the SVD.
#include "../accuracy/host_set_rows.h"

namespace physgen::bench {

template struct HostVariant<SvdVariant<4>, float>;
template struct HostVariant<SvdVariant<4>, double>;

}  // namespace physgen::bench
