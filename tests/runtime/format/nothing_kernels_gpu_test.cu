// Kernels on the device over arrays that prune fields: the results are those of arrays that store all, and stores to
// pruned fields write nowhere. Compiled twice: also with PHYSGEN_CHECKED.
#include <physgen/cuda/parallel_for.h>
#include <physgen/memory/buffer.h>

#include "gpu_fixture.h"
#include "nothing_kernels.h"

namespace physgen::test {
namespace {

class NothingInKernels : public GpuTest {};

const auto on_device = [](index_t n, const auto& kernel) { parallel_for(Cuda{}, n, kernel); };

TEST_F(NothingInKernels, of_rotations_leaves_every_bit_of_stress_derivatives) {
  check_results_with_pruned_rotations<float, Cuda, Aosoa<32>>(on_device);
#ifndef PHYSGEN_CHECKED  // whose checks are the same in all layouts
  check_results_with_pruned_rotations<float, Cuda, Aos>(on_device);
  check_results_with_pruned_rotations<double, Cuda, Soa>(on_device);
#endif
}

/// The memory of an array on the device, filled with what no test value has, and read back.
void poison_there(const UntypedArray& array) {
  const std::vector<std::byte> bytes(static_cast<std::size_t>(array.bytes()), std::byte{0xA5});
  copy_memory(array.base, array.space, bytes.data(), SpaceKind::host, array.bytes());
}
void expect_only_stored_elements_written_there(UntypedArray array, const std::vector<bool>& objects) {
  synchronize();
  std::vector<std::byte> bytes(static_cast<std::size_t>(array.bytes()));
  copy_memory(bytes.data(), SpaceKind::host, array.base, array.space, array.bytes());
  array.base = bytes.data();
  expect_only_stored_elements_written(array, objects);
}

template <class Layout>
void check_stores_on_the_device() {
  Array<elasticity::DeformationSvdObject, float, Cuda, Layout, StretchesOnly> svds(77);
  Array<elasticity::StressDerivativeObject, float, Cuda, Layout, PartOfDerivative> derivatives(77);
  Array<tissue::model::EntriesObject, float, Cuda, Layout, PartOfEntries> entries(77);
  poison_there(svds.untyped());
  poison_there(derivatives.untyped());
  poison_there(entries.untyped());
  parallel_for(Cuda{}, 70,
               StoreSomeFields<decltype(svds.view()), decltype(derivatives.view()), decltype(entries.view())>{
                   svds.view(), derivatives.view(), entries.view()});
  std::vector<bool> written(77, true);
  std::fill(written.begin() + 70, written.end(), false);
  expect_only_stored_elements_written_there(svds.untyped(), written);
  expect_only_stored_elements_written_there(derivatives.untyped(), std::vector<bool>(77, false));
  expect_only_stored_elements_written_there(entries.untyped(), std::vector<bool>(77, false));
  for (int k = 18; k < 21; ++k) EXPECT_EQ(svds.getdata(69, k), 6);
  EXPECT_EQ(derivatives.take_losses().falsified(), 0U) << "1e30 would be no half, but is not stored as one";
}

TEST_F(NothingInKernels, is_what_stores_of_pruned_fields_write) {
  check_stores_on_the_device<Aos>();
  check_stores_on_the_device<Soa>();
  check_stores_on_the_device<Aosoa<32>>();
}

struct PutWhole {
  Array<elasticity::DeformationSvdObject, float, Cuda, Soa>::ConstView from;
  Array<elasticity::DeformationSvdObject, float, Cuda, Soa, StretchesOnly>::View part;
  Array<elasticity::DeformationSvdObject, float, Cuda, Soa, NoSvd>::View none;
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    part.put(i, from.get(i));
    none.put(i, from.get(i));
  }
};

TEST_F(NothingInKernels, of_whole_objects_is_put_where_they_are_pruned) {
  std::mt19937 random(seed());
  const auto full =
      random_objects<elasticity::DeformationSvdObject, float, elasticity::DeformationSvdFormats<Host>>(500, random);
  Array<elasticity::DeformationSvdObject, float, Cuda, Soa> there(500);
  copy(there, full);
  Array<elasticity::DeformationSvdObject, float, Cuda, Soa, StretchesOnly> part(500);
  Array<elasticity::DeformationSvdObject, float, Cuda, Soa, NoSvd> none(500);
  parallel_for(Cuda{}, 500, PutWhole{there.const_view(), part.view(), none.view()});
  expect_part_of(part, full);
  EXPECT_NO_THROW(synchronize());
}

}  // namespace
}  // namespace physgen::test
