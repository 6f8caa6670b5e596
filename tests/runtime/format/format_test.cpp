// Storage formats in arrays: objects of mixed sizes, views, packs, records, losses. format/ has a test for each format.
#include <physgen/parallel_for.h>

#include "format_checks.h"

namespace physgen::test {
namespace {

template <class Layout>
class FormatsOver : public ::testing::Test {};
TYPED_TEST_SUITE(FormatsOver, AllLayouts, LayoutName);

TYPED_TEST(FormatsOver, objects_of_mixed_sizes_come_back_within_the_errors_of_their_formats) {
  for (const index_t n : {0, 1, 31, 33, 1000}) check_mixed_round_trip<Host, TypeParam>(n);
}

TYPED_TEST(FormatsOver, views_read_and_write_single_objects_and_packs_alike) {
  std::mt19937 random(seed());
  std::uniform_real_distribution<float> value(-2.0F, 2.0F);
  constexpr index_t n = 96;
  Array<elasticity::StressDerivativeObject, float, Host, TypeParam, MixedDerivative> one_by_one(n), packs(n);
  elasticity::StressDerivativeArray<float, Host, Aosoa<16>> source(n);
  for (index_t i = 0; i < n; ++i) {
    for (int k = 0; k < source.elements; ++k) source.putdata(i, k, value(random));
  }
  const auto from = source.const_view();
  for (index_t i = 0; i < n; ++i) one_by_one.view().put(i, from.get(i));
  constexpr int W = native_lanes<float>;
  for (index_t i = 0; i < n; i += W) packs.view().put(Pack<W>{i}, from.get(Pack<W>{i}));
  Array<elasticity::StressDerivativeObject, float, Host, Aos, MixedDerivative> a(n), b(n), copied(n);
  copy(a, one_by_one);
  copy(b, packs);
  copy(copied, source);
  EXPECT_EQ(count_different(a, b), 0);
  EXPECT_EQ(count_different(a, copied), 0);  // accessors and copies round alike
  for (index_t i = 0; i < n; i += W) {
    const auto read = packs.const_view().get(Pack<W>{i});
    for (int l = 0; l < W; ++l) {
      const auto single = one_by_one.const_view().get(i + l);
      ASSERT_EQ(read.x1111.get(static_cast<std::size_t>(l)), single.x1111);
      ASSERT_EQ(read.x3322.get(static_cast<std::size_t>(l)), single.x3322);
      ASSERT_EQ(read.x3311.get(static_cast<std::size_t>(l)), single.x3311);
    }
  }
}

TEST(Formats, an_element_is_assigned_added_to_and_read_as_a_number) {
  Array<elasticity::StressDerivativeObject, float, Host, Aosoa<16>, MixedDerivative> array(5);
  const auto view = array.view();
  view[3].x1111() = 1.5F;
  view[3].x1111() += 0.25F;
  view[3].x1111() *= 2.0F;
  const float read = view[3].x1111();
  EXPECT_EQ(read, 3.5F);
  view[4].x1111() = view[3].x1111();
  EXPECT_EQ(array.getdata(4, 0), 3.5);
  view[3].x2222() = 7.0F;  // stored as computed: a plain reference
  EXPECT_EQ(&view[3].x2222(), &view[3].x2222());
}

TEST(Formats, a_record_is_as_small_as_its_elements) {
  using Mixed = Array<elasticity::StressDerivativeObject, float, Host, Soa, MixedDerivative>;
  EXPECT_EQ(Mixed::record_bytes, 8 + 7 * 4 + 4 * 2);
  using Compact = Array<elasticity::DeformationSvdObject, float, Host, Soa,
                        CompactSvd<format::Snorm16<format::Interval{-1.0, 1.0}>>>;
  EXPECT_EQ(Compact::record_bytes, 8 * 2 + 3 * 2);
  EXPECT_EQ(Compact::elements, 21);
}

TEST(Formats, what_a_copy_loses_is_counted_with_its_place) { check_losses<Host>(); }

TEST(Formats, copies_between_arrays_that_share_memory_or_have_none_are_refused) {
  elasticity::StressDerivativeArray<float, Host, Soa> array(100), other(100);
  for (int k = 0; k < array.elements; ++k) array.putdata(7, k, k + 1);
  UntypedArray shifted = array.untyped();
  shifted.base += 64;
  EXPECT_NE(message_of([&] { copy(shifted, array.untyped()); }).find("share memory"), std::string::npos);
  UntypedArray nowhere = other.untyped();
  nowhere.base = nullptr;
  EXPECT_NE(message_of([&] { copy(array.untyped(), nowhere); }).find("no memory (null)"), std::string::npos);
  for (int k = 0; k < array.elements; ++k) EXPECT_EQ(array.getdata(7, k), k + 1);
}

}  // namespace
}  // namespace physgen::test
