// Objects of mixed element sizes, nested and with initial values, in CUDA memory: the golden schema with everything in
// it.
#include <everything.physgen.h>

#include "gpu_fixture.h"
#include "round_trip_checks.h"

namespace physgen::test {
namespace {

template <class L>
class CudaMixedObjects : public GpuTest {};
TYPED_TEST_SUITE(CudaMixedObjects, AllLayouts, LayoutName);

TYPED_TEST(CudaMixedObjects, return_bit_for_bit) {
  using Even = EvenReal<TypeParam>;
  using Odd = OddReal<TypeParam>;
  std::mt19937 random(seed());
  for (const index_t n : {0, 1, 31, 32, 33, 1003}) {
    check_round_trip<tissue::model::ShapesObject, Even, Cuda, TypeParam>(n, random);
    check_round_trip<tissue::model::EntriesObject, Odd, Cuda, TypeParam>(n, random);
    check_round_trip<tissue::model::OptionsObject, Even, Cuda, TypeParam>(n, random);
    check_round_trip<tissue::other::PatchObject, Odd, Cuda, TypeParam>(n, random);
  }
}

TYPED_TEST(CudaMixedObjects, begin_with_the_initial_values_of_the_schema) {
  using Object = tissue::model::OptionsObject;
  Array<Object, float, Cuda, TypeParam> array(33);
  ASSERT_EQ(array.getdata(32, 0), 1060);
  array.putdata(32, 0, 7);
  array.resize(100);
  const Array<Object, float, Host, Aos> expected(100);  // the host's are held to the schema by golden_run_test
  Array<Object, float, Host, Aos> back(100);
  poison(back);
  copy(back, array);
  synchronize();
  EXPECT_EQ(back.getdata(32, 0), 7);
  back.putdata(32, 0, 1060);
  EXPECT_EQ(count_different(expected, back), 0);
}

}  // namespace
}  // namespace physgen::test
