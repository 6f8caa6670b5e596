// Copies in CUDA memory compute in the precision that copies on the host compute in.
#include "copy_precision_checks.h"
#include "gpu_fixture.h"

namespace physgen::test {
namespace {

class CopyPrecisionGpu : public GpuTest {};

TEST_F(CopyPrecisionGpu, copies_compute_in_the_wider_precision_of_the_two_arrays) {
  check_copies_between<Cuda, format::Native, format::Half<3>, FloatAround300, HalfAround300, Fine>(200);
}

}  // namespace
}  // namespace physgen::test
