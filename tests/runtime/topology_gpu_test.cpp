// Changes of topology in pinned and CUDA memory: the checks of the host test on a device.
#include "gpu_fixture.h"
#include "renumber_checks.h"

namespace physgen::test {
namespace {

template <class L>
class CudaTopology : public GpuTest {};
TYPED_TEST_SUITE(CudaTopology, AllLayouts, LayoutName);

TYPED_TEST(CudaTopology, changes_of_objects_are_those_of_a_vector) {
  check_changes_of_all_object_types<Cuda, TypeParam>();
}
TYPED_TEST(CudaTopology, changes_in_pinned_memory_are_those_of_a_vector) {
  check_changes_of_all_object_types<PinnedHost, TypeParam>();
}
TYPED_TEST(CudaTopology, appends_objects_of_another_precision) {
  check_append_of_another_precision<Cuda, TypeParam>();
  check_append_of_another_precision<PinnedHost, TypeParam>();
}
TYPED_TEST(CudaTopology, changes_all_arrays_of_a_set) { check_set<Cuda, TypeParam>(); }
TYPED_TEST(CudaTopology, renumbered_tets_keep_their_nodes) {
  check_renumber<Cuda, TypeParam>();
  check_renumber<PinnedHost, TypeParam>();
}
TYPED_TEST(CudaTopology, renumbers_one_field_and_leaves_the_others) {
  check_renumber_of_one_field_among_many<Cuda, TypeParam>();
}
TYPED_TEST(CudaTopology, renumbers_behind_quaternions) { check_renumber_behind_quaternions<Cuda, TypeParam>(); }

// Lists of numbers are looked at, and memory is allocated, before any layout matters.
template <class L>
class CudaTopologyErrors : public GpuTest {};
using LayoutsOfErrors = ::testing::Types<AosPadded, Aosoa<8>>;
TYPED_TEST_SUITE(CudaTopologyErrors, LayoutsOfErrors, LayoutName);

TYPED_TEST(CudaTopologyErrors, a_failure_leaves_all_arrays_of_a_set_as_they_were) {
  check_failures_of_a_set_change_nothing<Cuda, TypeParam>();
}
TYPED_TEST(CudaTopologyErrors, memory_that_runs_out_half_way_leaves_all_arrays_of_a_set_as_they_were) {
  check_memory_that_runs_out_half_way<Cuda, TypeParam>();
}
TYPED_TEST(CudaTopologyErrors, refuses_a_wrong_list_by_its_first_wrong_number) {
  check_refused_lists<Cuda, TypeParam>();
}
TYPED_TEST(CudaTopologyErrors, refuses_to_renumber_what_has_no_number_by_its_first_object) {
  check_refused_renumbering<Cuda, TypeParam>();
}

}  // namespace
}  // namespace physgen::test
