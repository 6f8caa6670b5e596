// The checks of the SVD on the CPU: packs of all widths and single numbers.
#include <physgen/parallel_for.h>

#include "svd_parts_checks.h"

namespace physgen::fem {
namespace {

template <class Real, class Layout, int kLanes>
using Case = RunCase<Real, Host, Layout, kLanes>;
using Cases =
    testing::Types<Case<float, Aosoa<16>, 0>, Case<float, Aosoa<16>, 8>, Case<float, Soa, 4>, Case<float, Aos, 1>,
                   Case<double, Aosoa<16>, 0>, Case<double, Soa, 4>, Case<double, Aos, 1>>;
using PartCases = testing::Types<Case<float, Aosoa<16>, 0>, Case<double, Soa, 0>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Host, SvdOf, Cases);
INSTANTIATE_TYPED_TEST_SUITE_P(Host, SvdParts, PartCases);

}  // namespace
}  // namespace physgen::fem
