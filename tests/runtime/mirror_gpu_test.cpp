// Copies of ranges, and mirrors between host and CUDA memory: the checks of the host test on a device.
#include "gpu_fixture.h"
#include "mirror_checks.h"

namespace physgen::test {
namespace {

template <class L>
class CudaMirror : public GpuTest {};
TYPED_TEST_SUITE(CudaMirror, AllLayouts, LayoutName);

TYPED_TEST(CudaMirror, copies_of_ranges_move_their_objects_and_no_others) { check_ranges<Cuda, TypeParam>(); }
TYPED_TEST(CudaMirror, copies_ranges_between_arrays_of_different_sizes) {
  check_ranges_of_different_sizes<Cuda, TypeParam>();
}
TYPED_TEST(CudaMirror, moves_only_the_blocks_that_changed) {
  check_mirror_moves_only_what_changed<Cuda, TypeParam, TypeParam>();
  check_mirror_moves_only_what_changed<Cuda, TypeParam, AosPadded>();
}
TYPED_TEST(CudaMirror, refuses_objects_that_changed_on_both_sides) {
  check_mirror_refuses_objects_that_changed_on_both_sides<Cuda, TypeParam>();
}
TYPED_TEST(CudaMirror, reads_what_was_written_last_under_random_use) {
  check_mirror_under_random_use<Cuda, TypeParam>();
}
TYPED_TEST(CudaMirror, lets_its_objects_change_topology) {
  check_mirror_of_objects_that_change_topology<Cuda, TypeParam>();
}
TYPED_TEST(CudaMirror, keeps_what_nobody_wrote_whatever_the_formats) {
  check_mirrors_of_different_formats<Cuda, TypeParam>();
}

}  // namespace
}  // namespace physgen::test
