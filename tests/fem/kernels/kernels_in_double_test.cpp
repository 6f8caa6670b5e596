// The kernel checks on the CPU with doubles, in all layouts.
#include <physgen/parallel_for.h>

#include "kernel_checks.h"

namespace physgen::fem {
namespace {

template <class Layout, template <class> class Model>
using Case = KernelCase<double, Host, Layout, Model>;
using Cases = testing::Types<Case<Aos, FixedCorotated>, Case<AosPadded, NeoHookean>, Case<Soa, FixedCorotated>,
                             Case<Aosoa<16>, NeoHookean>>;
INSTANTIATE_TYPED_TEST_SUITE_P(HostInDouble, Kernels, Cases);

}  // namespace
}  // namespace physgen::fem
