// Formats of a program's own and scaled ones mean the same wherever they are used. Compiled twice: also without the
// processor's instructions for halves.
#include "own_formats.h"

#include <physgen/parallel_for.h>

namespace physgen::test {
namespace {

/// Numbers written one by one, in packs, by putdata() and by copies from floats and doubles are the same, and so are
/// those that are read.
template <class Real, class Layout>
void check_own_formats_on_the_host(index_t n) {
  std::mt19937 random(seed());
  elasticity::StressDerivativeArray<Real, Host, Aos> source(n);
  for (index_t i = 0; i < n; ++i) {
    for (int k = 0; k < source.elements; ++k) source.putdata(i, k, own_value(k, random));
  }
  using Own = Array<OwnObject, Real, Host, Layout, OwnDerivative>;
  Own single(n), packs(n), put(n), copied(n);
  EXPECT_EQ(single.getdata(n - 1, 3), 0) << "the initial value, which is not zero bytes";
  const auto from = source.const_view();
  const auto to = single.view();
  for (index_t i = 0; i < n; ++i) to.put(i, from.get(i));
  constexpr int W = native_lanes<Real>;
  elasticity::StressDerivativeArray<Real, Host, Soa> wide(n);
  copy(wide, source);
  for (index_t i = 0; i + W <= n; i += W) packs.view().put(Pack<W>{i}, wide.const_view().get(Pack<W>{i}));
  for (index_t i = n / W * W; i < n; ++i) packs.view().put(i, from.get(i));
  for (index_t i = 0; i < n; ++i) {
    for (int k = 0; k < source.elements; ++k) put.putdata(i, k, source.getdata(i, k));
  }
  copy(copied, source);
  const auto expected = stored_elements(single);
  EXPECT_EQ(stored_elements(packs), expected);
  EXPECT_EQ(stored_elements(copied), expected);

  elasticity::StressDerivativeArray<Real, Host, Soa> back(n);
  elasticity::StressDerivativeArray<double, Host, Aos> back_in_double(n);
  copy(back, single);
  copy(back_in_double, put);
  for (index_t i = 0; i < n; ++i) {
    const auto value = single.const_view().get(i), same = back.const_view().get(i);
    ASSERT_EQ(value.x1111, same.x1111);
    ASSERT_EQ(value.x2211, same.x2211);
    ASSERT_EQ(value.x3311, same.x3311);
    ASSERT_EQ(value.x2222, same.x2222);
    ASSERT_EQ(value.x3322, same.x3322);
    ASSERT_EQ(value.x3333, same.x3333);
    ASSERT_EQ(value.x2121, same.x2121);
    ASSERT_EQ(value.x2112, same.x2112);
    ASSERT_EQ(value.x3131, same.x3131);
    ASSERT_EQ(value.x3113, same.x3113);
    ASSERT_EQ(value.x3232, same.x3232);
    for (int k = 0; k < source.elements; ++k) {
      const double wanted = source.getdata(i, k);
      ASSERT_NEAR(single.getdata(i, k), wanted, own_error(k)) << "object " << i << " element " << k;
      ASSERT_NEAR(back.getdata(i, k), wanted, own_error(k)) << "object " << i << " element " << k;
      ASSERT_NEAR(put.getdata(i, k), wanted, own_error(k)) << "object " << i << " element " << k;
      ASSERT_NEAR(back_in_double.getdata(i, k), wanted, own_error(k)) << "object " << i << " element " << k;
    }
  }
  for (index_t i = 0; i + W <= n; i += W) {
    const auto pack = packs.const_view().get(Pack<W>{i});
    for (int l = 0; l < W; ++l) {
      const auto lane = static_cast<std::size_t>(l);
      const auto value = single.const_view().get(i + l);
      ASSERT_EQ(pack.x1111.get(lane), value.x1111);
      ASSERT_EQ(pack.x2211.get(lane), value.x2211);
      ASSERT_EQ(pack.x3311.get(lane), value.x3311);
      ASSERT_EQ(pack.x2222.get(lane), value.x2222);
      ASSERT_EQ(pack.x2121.get(lane), value.x2121);
      ASSERT_EQ(pack.x2112.get(lane), value.x2112);
      ASSERT_EQ(pack.x3131.get(lane), value.x3131);
      ASSERT_EQ(pack.x3232.get(lane), value.x3232);
    }
  }
}

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
  std::memcpy(&stored, array.untyped().base + array.untyped().fields[2].offset * array.pitch() + 4, sizeof stored);
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

struct Refuses {
  static constexpr const char* name = "refuses";
  template <class Real>
  using Stored = float;
  template <class Real>
  static constexpr ElementType type = ElementType::float32;
  static constexpr double scale = 1, centre = 0;
  template <class Real>
  static Real decode(float stored) {
    return Real(stored);
  }
  template <class Real>
  static float encode(Real value) {
    if (value > 5) throw Error("it holds no more than 5");
    return static_cast<float>(value);
  }
};
struct RefusingPositions : elasticity::NodePositionFormats<Host> {
  using x = Refuses;
};

TEST(OwnFormats, that_throw_do_so_out_of_copies) {
  elasticity::NodePositionArray<float> from(20000);
  Array<elasticity::NodePositionObject, float, Host, Aos, RefusingPositions> to(20000);
  EXPECT_NO_THROW(copy(to, from));
  from.view()[12345].x()[1] = 6;
  EXPECT_THROW(copy(to, from), Error);
}

}  // namespace
}  // namespace physgen::test
