// The checks of the SVD on CUDA, one thread per matrix.
#include <physgen/cuda/parallel_for.h>

#include "svd_parts_checks.h"

namespace physgen::fem {
namespace {

template <class Real, class Layout>
using Case = RunCase<Real, Cuda, Layout>;
using Cases = testing::Types<Case<float, Aos>, Case<double, Aosoa<32>>>;
using PartCases = testing::Types<Case<float, Aosoa<32>>, Case<double, Aosoa<32>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Cuda, SvdOf, Cases);
INSTANTIATE_TYPED_TEST_SUITE_P(Cuda, SvdParts, PartCases);

}  // namespace
}  // namespace physgen::fem
