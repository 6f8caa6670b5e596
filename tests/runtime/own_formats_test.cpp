// Formats of a program's own and scaled ones mean the same wherever they are used. Compiled twice: also without the
// processor's instructions for halves.
#include "own_formats.h"

namespace physgen::test {
namespace {

TEST(OwnFormats, mean_the_same_one_by_one_in_packs_and_in_copies) {
  for (const index_t n : {1, 33, 200}) {
    check_own_formats_on_the_host<float, Soa>(n);
    check_own_formats_on_the_host<double, Aosoa<32>>(n);
  }
  check_own_formats_on_the_host<float, AosPadded>(70);
}

template <int W>
void check_halves_around_300_in_packs_of() {
  Array<OwnObject, float, Host, Aosoa<32>, OwnDerivative> array(32);
  array.view()[Pack<W>{0}].x2211() = batch_t<float, W>(310.0F);
  array.view()[Pack<W>{0}].x2121() = batch_t<float, W>(310.0F);
  const batch_t<float, W> own = array.const_view().get(Pack<W>{0}).x2211;
  const batch_t<float, W> scaled = array.const_view().get(Pack<W>{0}).x2121;
  for (std::size_t l = 0; l < W; ++l) {
    EXPECT_EQ(own.get(l), 310.0F);
    EXPECT_NEAR(scaled.get(l), 310.0F, 1e-2F);
    EXPECT_EQ(array.getdata(static_cast<index_t>(l), 1), 310.0);
  }
}

TEST(OwnFormats, of_halves_are_not_taken_for_the_librarys_in_packs) {
#ifdef __AVX__
  check_halves_around_300_in_packs_of<8>();
#endif
#ifdef __AVX512F__
  check_halves_around_300_in_packs_of<16>();
#endif
  check_halves_around_300_in_packs_of<4>();
}

TEST(OwnFormats, keep_what_their_functions_make_even_of_the_type_computed_with) {
  Array<OwnObject, float, Host, Soa, OwnDerivative> array(3);
  array.view()[1].x3311() = 16.0F;
  float stored = 0;
  std::memcpy(&stored, array.storage().base + array.storage().fields[2].offset * array.pitch() + 4, sizeof stored);
  EXPECT_EQ(stored, 4.0F);
  EXPECT_EQ(array.getdata(1, 2), 16.0);
  EXPECT_EQ(array.const_view().get(index_t{1}).x3311, 16.0F);
}

/// A quaternion of components in a format of its own.
struct OwnTurns : elasticity::DeformationSvdFormats<Host> {
  using U = format::Quaternion<Thousandths>;
  using s = Thousandths;
};

TEST(OwnFormats, are_components_of_quaternions) {
  Array<elasticity::DeformationSvdObject, float, Host, Aosoa<8>, OwnTurns> turns(20);
  EXPECT_EQ(turns.getdata(19, 0), 1) << "a new rotation is the identity";
  elasticity::DeformationSvdArray<float> svds(20);
  Eigen::Matrix3f R;
  R << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  svds.view()[7].U() = R;
  copy(turns, svds);
  svds.view()[7].U() = Eigen::Matrix3f::Identity();
  EXPECT_LE((turns.const_view().get(index_t{7}).U - R).cwiseAbs().maxCoeff(), 2e-6F);
  copy(svds, turns);
  EXPECT_LE((svds.const_view().get(index_t{7}).U - R).cwiseAbs().maxCoeff(), 2e-6F);
}

}  // namespace
}  // namespace physgen::test
