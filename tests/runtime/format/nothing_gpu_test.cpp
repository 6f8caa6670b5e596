// Arrays that prune fields in pinned and CUDA memory: copies, changes of topology, mirrors and gathered arrays, and
// what they refuse. Compiled twice: also with PHYSGEN_CHECKED.
#include "gpu_fixture.h"
#include "nothing_checks.h"

namespace physgen::test {
namespace {

class NothingOnCuda : public GpuTest {};

template <class Space, class Layout>
void check_space() {
  std::mt19937 random(seed());
  for (const index_t n : {1, 33, 500}) {
    check_copies<elasticity::DeformationSvdObject, float, Space, Layout, StretchesOnly,
                 elasticity::DeformationSvdFormats<Host>>(n, random);
    check_copies<elasticity::StressDerivativeObject, float, Space, Layout, PartOfDerivative, FullDerivative>(n, random);
    check_copies<tissue::other::PatchObject, float, Space, Layout, PartOfPatch, tissue::other::PatchFormats<Host>>(
        n, random);
    check_topology<elasticity::DeformationSvdObject, float, Space, Layout, StretchesOnly,
                   elasticity::DeformationSvdFormats<Host>>(n, random);
    check_topology<tissue::other::PatchObject, float, Space, Layout, PartOfPatch, tissue::other::PatchFormats<Host>>(
        n, random);
  }
  check_only_pruned_fields<Space, Layout>();
  check_mirror<Space, Layout>();
  check_gather<Space, Layout>();
}

TEST_F(NothingOnCuda, is_stored_of_pruned_fields_in_records) { check_space<Cuda, Aos>(); }
TEST_F(NothingOnCuda, is_stored_of_pruned_fields_in_padded_records) { check_space<Cuda, AosPadded>(); }
TEST_F(NothingOnCuda, is_stored_of_pruned_fields_in_channels) { check_space<Cuda, Soa>(); }
TEST_F(NothingOnCuda, is_stored_of_pruned_fields_in_tiles) { check_space<Cuda, Aosoa<32>>(); }
TEST_F(NothingOnCuda, is_stored_of_pruned_fields_in_pinned_memory) { check_space<PinnedHost, Aosoa<8>>(); }

/// Many objects: transfers in chunks, and transpositions of whole blocks.
TEST_F(NothingOnCuda, is_stored_of_pruned_fields_of_many_objects) {
  using Object = elasticity::DeformationSvdObject;
  std::mt19937 random(seed());
  const auto full = random_objects<Object, float, elasticity::DeformationSvdFormats<Host>>(300001, random);
  Array<Object, float, PinnedHost, Aosoa<16>> pinned(full.size());
  copy(pinned, full);
  Array<Object, float, Cuda, Aosoa<32>, StretchesOnly> tiles(full.size()), from_pinned(full.size());
  Array<Object, float, Cuda, Soa, StretchesOnly> channels(full.size());
  Array<Object, float, Cuda, Aos, StretchesOnly> records(full.size());
  copy(tiles, full);
  copy(from_pinned, pinned);
  copy(channels, tiles);
  copy(records, channels);
  const auto wanted = on_host(tiles);
  EXPECT_EQ(count_different(on_host(from_pinned), wanted), 0);
  EXPECT_EQ(count_different(on_host(channels), wanted), 0);
  EXPECT_EQ(count_different(on_host(records), wanted), 0);
  for (const index_t i : {index_t{0}, index_t{123456}, index_t{300000}}) {
    for (int k = 18; k < 21; ++k) EXPECT_EQ(records.getdata(i, k), full.getdata(i, k));
  }
}

/// The host alone has the functions of such a format, and nobody needs them for a field that is left out.
TEST_F(NothingOnCuda, is_stored_of_a_pruned_field_that_another_array_keeps_in_a_format_of_the_programs_own) {
  std::mt19937 random(seed());
  const auto full = random_objects<elasticity::StressDerivativeObject, float, OwnOfAll>(500, random);
  Array<elasticity::StressDerivativeObject, float, Cuda, Aosoa<32>, OwnOfAll> there(500);
  Array<elasticity::StressDerivativeObject, float, Cuda, Soa, OwnOfPart> part(500), from_host(500);
  copy(there, full);
  copy(part, there);
  copy(from_host, full);
  expect_part_of(part, full);
  expect_part_of(from_host, full);
}

TEST_F(NothingOnCuda, is_refused_where_its_field_is_needed) {
  check_refusals<Cuda>();
  check_refusals<PinnedHost>();
}

}  // namespace
}  // namespace physgen::test
