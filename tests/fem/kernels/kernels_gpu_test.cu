// The kernel checks on CUDA: the same source as on the CPU, one thread per object; in two layouts, since kernels know
// nothing of them. What depends on a material, agreement_gpu_test.cu holds to the bits of the CPU for all of them in
// both precisions, and fused_gpu_test.cu has sums over records.
#include <physgen/cuda/parallel_for.h>

#include "kernel_checks.h"

namespace physgen::fem {
namespace {

template <class Real, class Layout, template <class> class Model>
using Case = KernelCase<Real, Cuda, Layout, Model>;
using Cases = testing::Types<Case<float, Aosoa<32>, NeoHookean>, Case<double, Soa, FixedCorotated>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Cuda, Kernels, Cases);

}  // namespace
}  // namespace physgen::fem
