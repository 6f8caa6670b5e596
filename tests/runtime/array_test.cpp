// Arrays: sizes, values, copies, addresses, and what is refused.
#include <everything.physgen.h>

#include <set>

#include "format_checks.h"
#include "test_objects.h"

namespace physgen::test {
namespace {

using elasticity::DeformationSvdArray;
using elasticity::NodePositionArray;
using elasticity::StressDerivativeArray;

template <class L>
class ArrayIn : public ::testing::Test {};
TYPED_TEST_SUITE(ArrayIn, AllLayouts, LayoutName);

// Tiles of 4 objects whose records take 8 bytes: object 6 lies in tile 1 as lane 2, and its second float in channel 4.
static_assert(law::element(index_t{0}, StaticPitch<4>(4), 8, 6, 4, 4) == 32 + 4 * 4 + 2 * 4);
static_assert(law::element(index_t{0}, AnyPitch{4}, 8, 6, 4, 4) == 32 + 4 * 4 + 2 * 4);
static_assert(law::element(index_t{0}, WholePitch(96), 8, 6, 4, 4) == 4 * 96 + 6 * 4);

TYPED_TEST(ArrayIn, puts_every_element_where_the_law_of_addresses_says) {
  for (const index_t n : {1, 32, 33, 1000}) {
    DeformationSvdArray<float, Host, TypeParam> array(n);
    const auto view = array.view();
    const UntypedArray untyped = array.untyped();
    for (index_t i = 0; i < n; ++i) {
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
          const index_t expected = address_by_law((9 + c * 3 + r) * 4, i, untyped.pitch, untyped.record_bytes, 4);
          ASSERT_EQ(reinterpret_cast<std::byte*>(&view[i].V()(r, c)) - view.data(), expected);
        }
      }
    }
  }
}

TYPED_TEST(ArrayIn, overlaps_no_two_elements_and_stays_inside_its_memory) {
  const index_t n = 77;
  elasticity::TetStiffnessArray<double, Host, TypeParam> array(n);
  const auto view = array.view();
  std::set<const std::byte*> seen;
  const auto note = [&](const double& element) {
    const auto* at = reinterpret_cast<const std::byte*>(&element);
    ASSERT_TRUE(seen.insert(at).second);
    ASSERT_GE(at, view.data());
    ASSERT_LE(at + sizeof(double), view.data() + array.bytes());
    ASSERT_EQ(reinterpret_cast<std::uintptr_t>(at) % sizeof(double), 0U);
  };
  for (index_t i = 0; i < n; ++i) {
    for (int e = 0; e < 4; ++e) {
      for (int k = 0; k < 6; ++k) note(view[i].k(e)[k]);
    }
    for (int e = 0; e < 6; ++e) {
      for (int k = 0; k < 9; ++k) note(view[i].e(e)[k]);
    }
  }
  EXPECT_EQ(seen.size(), static_cast<std::size_t>(n * array.elements));
}

TYPED_TEST(ArrayIn, reads_by_name_by_value_and_by_number_what_was_put) {
  StressDerivativeArray<float, Host, TypeParam> array(40);
  const auto view = array.view();
  for (index_t i = 0; i < 40; ++i) {
    elasticity::StressDerivative<float> value{};
    value.x1111 = static_cast<float>(i) + 0.25F;
    value.x3322 = -static_cast<float>(i);
    view.put(i, value);
    view[i].x3223() = 7;
  }
  EXPECT_EQ(view.get(39).x1111, 39.25F);
  EXPECT_EQ(array.const_view()[38].x3322(), -38);
  EXPECT_EQ(array.getdata(37, 11), 7);
  *&view[3].x1111() += 1;  // a real address: what an atomic operation needs
  EXPECT_EQ(array.getdata(3, 0), 4.25);
}

TYPED_TEST(ArrayIn, holds_zeroed_memory_for_whole_packs_behind_the_last_object) {
  NodePositionArray<float, Host, TypeParam> array(33);
  EXPECT_EQ(array.untyped().padded % padding_objects, 0);
  EXPECT_GE(array.untyped().padded, 64);
  const auto view = array.view();
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(
        *reinterpret_cast<const float*>(view.data() + address_by_law(k * 4, 63, array.pitch(), array.record_bytes, 4)),
        0);
  }
}

TEST(Array, copies_deeply_and_moves_cheaply) {
  NodePositionArray<double> a(5);
  a.view()[4].x() = Eigen::Vector3d(1, 2, 3);
  NodePositionArray<double> b = a;
  b.view()[4].x()(0) = 9;
  EXPECT_EQ(a.getdata(4, 0), 1);
  const auto* memory = a.view().data();
  const NodePositionArray<double> c = std::move(a);
  EXPECT_EQ(c.view().data(), memory);
  EXPECT_EQ(c.getdata(4, 2), 3);
}

TEST(Array, stores_the_lower_triangle_of_a_symmetric_matrix_and_gives_the_whole) {
  elasticity::NodeStiffnessArray<double> array(3);
  Eigen::Matrix3d k;
  k << 1, -1, -1, 2, 3, -1, 4, 5, 6;
  array.view()[1].K() = k;
  const Eigen::Matrix3d whole = array.view()[1].K();
  EXPECT_EQ(whole, (Eigen::Matrix3d() << 1, 2, 4, 2, 3, 5, 4, 5, 6).finished());
  EXPECT_EQ(array.elements, 6);
}

TEST(Array, refuses_a_size_that_memory_cannot_hold_and_stays_as_it_was) {
  StressDerivativeArray<float> array(10);
  array.putdata(7, 3, 2.5);
  const std::string too_large = message_of([&] { array.resize(index_t{1} << 40); });
  const index_t bytes = 52'776'558'133'248 + (checked_build ? index_t{sizeof(Losses)} : 0);  // and the counters
  EXPECT_NE(too_large.find("elasticity::StressDerivative[1099511627776]: cannot allocate " + std::to_string(bytes) +
                           " bytes of host"),
            std::string::npos)
      << too_large;
  const std::string impossible = message_of([&] { array.resize(index_t{1} << 62); });
  EXPECT_NE(impossible.find("cannot exist"), std::string::npos) << impossible;
  const std::string negative = message_of([&] { array.resize(-1); });
  EXPECT_NE(negative.find("an array of -1 objects"), std::string::npos) << negative;
  EXPECT_EQ(array.size(), 10);
  EXPECT_EQ(array.getdata(7, 3), 2.5);
}

TEST(Array, refuses_a_copy_between_sizes_and_names_both) {
  NodePositionArray<float> small(3);
  const NodePositionArray<double> large(4);
  const std::string message = message_of([&] { copy(small, large); });
  EXPECT_NE(message.find("elasticity::NodePosition[4] in host"), std::string::npos) << message;
  EXPECT_NE(message.find("elasticity::NodePosition[3] in host"), std::string::npos) << message;
}

TEST(Array, refuses_copies_of_null_storages_and_of_other_types) {
  NodePositionArray<float> array(3);
  array.putdata(2, 1, 5);
  UntypedArray null = array.untyped();
  null.base = nullptr;
  EXPECT_NE(message_of([&] { copy(null, array.untyped()); }).find("no memory (null)"), std::string::npos);
  EXPECT_NE(message_of([&] { copy(array.untyped(), null); }).find("no memory (null)"), std::string::npos);
  EXPECT_NE(message_of([&] { copy_range(array.untyped(), null, 1, 2); }).find("no memory (null)"), std::string::npos);
  const elasticity::NodeForceArray<float> forces(3);
  EXPECT_NE(message_of([&] { copy_range(array.untyped(), forces.untyped(), 1, 2); }).find("the object types differ"),
            std::string::npos);
  EXPECT_NE(message_of([&] { copy_range(array.untyped(), array.untyped(), 1, 2); }).find("they share memory"),
            std::string::npos);
  EXPECT_EQ(array.getdata(2, 1), 5);
}

TEST(Array, refuses_what_is_no_index) {
  elasticity::TetArray<float> tets(2);
  tets.putdata(1, 2, 7);
  for (const double wrong : {3e9, -3e9, 0.5, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_NE(message_of([&] { tets.putdata(1, 2, wrong); }).find("is not an index; nodes holds whole numbers"),
              std::string::npos)
        << wrong;
  }
  EXPECT_EQ(tets.getdata(1, 2), 7);
}

struct DensityInSmallHalves : tissue::model::OptionsFormats<Host> {
  using density = format::Half<-10>;  // up to 64; the initial value is 1060
};
struct DensityInOtherSteps : tissue::model::OptionsFormats<Host> {
  using density = format::Snorm16<format::Interval{0, 100}>;
};
struct DensityInSteps : tissue::model::OptionsFormats<Host> {
  using density = format::Snorm16<format::Interval{1000, 1100}>;
};

template <class Formats>
std::string message_of_two_new_objects() {
  return message_of([] { tissue::model::OptionsArray<float, Host, Soa, Formats> array(2); });
}

TEST(Array, refuses_initial_values_that_its_formats_cannot_hold) {
  for (const std::string& message :
       {message_of_two_new_objects<DensityInSmallHalves>(), message_of_two_new_objects<DensityInOtherSteps>()}) {
    EXPECT_NE(message.find("Options[2] in host memory: the initial value 1060 of density is beyond the range"),
              std::string::npos)
        << message;
  }
  const tissue::model::OptionsArray<float, Host, Soa, DensityInSteps> array(2);
  EXPECT_NEAR(array.getdata(1, 0), 1060, 1e-3);
}

TEST(Array, rotations_of_a_new_array_are_the_identity_in_every_format) {
  const elasticity::DeformationSvdArray<float, Host, Aosoa<16>> matrices(3);
  Array<elasticity::DeformationSvdObject, double, Host, Soa, CompactSvd<format::Half<>>> quaternions(3);
  EXPECT_EQ(matrices.view().get(2).U, Eigen::Matrix3f::Identity());
  EXPECT_EQ(quaternions.view().get(2).V, Eigen::Matrix3d::Identity());
  copy(quaternions, matrices);
  EXPECT_EQ(quaternions.view().get(1).U, Eigen::Matrix3d::Identity());
}

TEST(Array, refuses_a_copy_to_itself) {
  NodePositionArray<float> array(3);
  array.putdata(1, 2, 7);
  EXPECT_NE(message_of([&] { copy(array, array); }).find("they share memory; copy to an array of its own"),
            std::string::npos);
  EXPECT_EQ(array.getdata(1, 2), 7);
}

TEST(Array, refuses_an_object_or_element_that_is_not_there) {
  NodePositionArray<float> array(3);
  EXPECT_NE(message_of([&] { (void)array.getdata(3, 0); }).find("there is no object 3"), std::string::npos);
  EXPECT_NE(message_of([&] { array.putdata(0, 3, 1); }).find("there is no element 3"), std::string::npos);
  EXPECT_NE(message_of([&] { array.putdata(0, -1, 1); }).find("there is no element -1"), std::string::npos);
}

TYPED_TEST(ArrayIn, addresses_objects_beyond_two_to_the_31st) {
  // No memory stands behind these addresses; they are computed, not used.
  using View = elasticity::DeformationSvdView<float, TypeParam>;
  const index_t n = (index_t{1} << 33) + 5;
  auto* base = reinterpret_cast<std::byte*>(std::uintptr_t{1} << 20);
  const index_t pitch = TypeParam::pitch(n);
  const View view(base, n, pitch);
  for (const index_t i : {(index_t{1} << 31) + 1, (index_t{1} << 32) + 37, n - 1}) {
    const auto* element = reinterpret_cast<const std::byte*>(&view[i].s()(2));
    ASSERT_EQ(element - base, address_by_law(20 * 4, i, pitch, View::record_bytes, 4));
  }
}

TEST(View, is_a_trivially_copyable_value_of_two_or_three_words) {
  using Tiled = elasticity::StressDerivativeView<float, Aosoa<32>>;
  using Pitched = elasticity::StressDerivativeView<float, Soa>;
  static_assert(std::is_trivially_copyable_v<Tiled> && std::is_trivially_copyable_v<Pitched>);
  static_assert(checked_build || (sizeof(Tiled) == 2 * sizeof(void*) && sizeof(Pitched) == 3 * sizeof(void*)));
}

}  // namespace
}  // namespace physgen::test
