// The kernel checks on the CPU with doubles (with floats, in the other layouts: kernels_test.cpp).
#include <physgen/parallel_for.h>

#include "kernel_checks.h"

namespace physgen::fem {
namespace {

template <class Layout, template <class> class Model>
using Case = KernelCase<double, Host, Layout, Model>;
using Cases = testing::Types<Case<Aos, NeoHookean>, Case<Soa, FixedCorotated>, Case<Aosoa<32>, NeoHookean>>;
INSTANTIATE_TYPED_TEST_SUITE_P(HostInDouble, Kernels, Cases);

}  // namespace
}  // namespace physgen::fem
