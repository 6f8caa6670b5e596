// The kernel checks on CUDA: the same source as on the CPU, one thread per object.
#include <physgen/cuda/parallel_for.h>

#include "kernel_checks.h"

namespace physgen::fem {
namespace {

template <class Real, class Layout, template <class> class Model>
using Case = KernelCase<Real, Cuda, Layout, Model>;
using Cases = testing::Types<Case<float, AosPadded, FixedCorotated>, Case<float, Aosoa<32>, NeoHookean>,
                             Case<double, Soa, FixedCorotated>, Case<double, Aosoa<32>, NeoHookean>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Cuda, Kernels, Cases);

}  // namespace
}  // namespace physgen::fem
