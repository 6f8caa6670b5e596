// Rows of the sets on the CPU: the SVD with 3 sweeps, in a file of its own because GCC inlines the parts of one SVD
// per file only.
#include "../accuracy/host_set_rows.h"

namespace physgen::bench {

template struct HostVariant<SvdVariant<3>, float>;
template struct HostVariant<SvdVariant<3>, double>;

}  // namespace physgen::bench
