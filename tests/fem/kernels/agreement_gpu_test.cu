// CUDA against the file that a CPU run in packs wrote.
#include "agreement_checks.h"
#include "run_case.h"

namespace physgen::fem {
namespace {

using Cases = testing::Types<RunCase<float, Cuda, Aosoa<32>>, RunCase<double, Cuda, Aosoa<32>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Cuda, Agreement, Cases);

}  // namespace
}  // namespace physgen::fem
