// The kernel checks on the CPU with doubles (with floats, in the other layouts: kernels_test.cpp).
#include <physgen/parallel_for.h>

#include "kernel_checks.h"

namespace physgen::fem {
namespace {

template <class Layout, template <class> class Model>
using CaseInDouble = KernelCase<double, Host, Layout, Model>;
using CasesInDouble = testing::Types<CaseInDouble<Aos, NeoHookean>, CaseInDouble<Soa, FixedCorotated>,
                                     CaseInDouble<Aosoa<32>, NeoHookean>>;
INSTANTIATE_TYPED_TEST_SUITE_P(HostInDouble, Kernels, CasesInDouble);

}  // namespace
}  // namespace physgen::fem
