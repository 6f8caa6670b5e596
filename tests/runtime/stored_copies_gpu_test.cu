// Objects that a kernel on the device assigns from objects of one format keep the bits that are stored.
#include <physgen/cuda/parallel_for.h>

#include "gpu_fixture.h"
#include "stored_copies_checks.h"

namespace physgen::test {
namespace {

class StoredCopiesGpu : public GpuTest {};

TEST_F(StoredCopiesGpu, objects_of_every_format_keep_their_bits) {
  constexpr index_t n = 203;
  std::mt19937 random(seed());
  using Object = tissue::model::StoredObject;
  using Formats = FormatsOf<Object, Cuda>;
  Array<Object, float, Host, Aos, Formats> source(n), back(n);
  fill_with_random_bits(source, random);
  Array<Object, float, Host, Soa, Formats> travelling(n);
  move_objects(travelling, source);
  Array<Object, float, Cuda, Soa> a(n), other(n);
  Array<Object, float, Cuda, Aosoa<8>> b(n);
  copy(a, travelling);
  copy(other, travelling);
  for (int time = 0; time < 100; ++time) {
    parallel_for(Cuda{}, n, CopyObjects<decltype(b.view()), decltype(a.const_view())>{b.view(), a.const_view()});
    parallel_for(Cuda{}, n, CopyObjects<decltype(a.view()), decltype(b.const_view())>{a.view(), b.const_view()});
    parallel_for(Cuda{}, n, SwapObjects<decltype(a.view())>{a.view(), other.view()});
  }
  poison(travelling);
  copy(travelling, a);
  synchronize();
  move_objects(back, travelling);
  EXPECT_EQ(count_different(source, back), 0);
}

}  // namespace
}  // namespace physgen::test
