// Rows in CUDA and pinned memory: the checks of the host test, one thread for each row.
#include <physgen/cuda/parallel_for.h>

#include "gpu_fixture.h"
#include "rows_checks.h"

namespace physgen::test {
namespace {

template <class Case>
class CudaRows : public GpuTest {};
using Cases = ::testing::Types<RowsCase<float, Cuda, Aos>, RowsCase<double, Cuda, Aosoa<32>>>;
TYPED_TEST_SUITE(CudaRows, Cases);

TYPED_TEST(CudaRows, are_visited_as_by_a_plain_loop_bit_for_bit) { check_visits<TypeParam>(); }
TYPED_TEST(CudaRows, are_made_of_lists_of_unsorted_pairs_and_of_offsets) { check_construction<TypeParam>(); }
TYPED_TEST(CudaRows, follow_changes_of_both_sets) {
  check_row_topology<TypeParam>();
  check_row_topology<RowsCase<float, PinnedHost, Soa>>();
}
TYPED_TEST(CudaRows, refuse_wrong_changes_and_stay_as_they_were) { check_refused_changes<TypeParam>(); }

}  // namespace
}  // namespace physgen::test
