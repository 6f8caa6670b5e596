// The storage formats of golden/everything.physgen.h, compiled and run: random values are stored through views and by
// copies, in the formats of the host, of CUDA and of a program's own, and are read back within the errors that the
// generated comments state.
#include "golden_formats.h"

namespace physgen::test {
namespace {

constexpr unsigned seed = 71;
constexpr index_t size = 43;  // a tile of the widest layout, and a part of one

template <class Real>
Array<StoredObject, Real, Host, Soa, Plain> random_values(index_t objects) {
  Random random(seed);
  Array<StoredObject, Real, Host, Soa, Plain> values(objects);
  for (index_t i = 0; i < objects; ++i) values.view().put(i, random.stored<Real>());
  return values;
}

template <class Array, class Values>
void check(const Array& array, const Values& values) {
  for (index_t i = 0; i < size && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("object " + std::to_string(i) + ", seed " + std::to_string(seed));
    expect_within<typename Array::Formats>(array.view().get(i), values.view().get(i));
  }
}

template <class Real, class Layout, class Formats>
void keeps_values() {
  SCOPED_TRACE(std::string(sizeof(Real) == 4 ? "float " : "double ") + Layout::name);
  constexpr int width = 4;  // the widest for which AVX has registers of double as well as of int
  const auto values = random_values<Real>(align_up(size, index_t{width}));
  Array<StoredObject, Real, Host, Layout, Formats> array(values.size());
  for (index_t i = 0; i < size; ++i) array.view().put(i, values.view().get(i));
  check(array, values);

  Array<StoredObject, Real, Host, Layout, Formats> copied(values.size());
  copy(copied, values);
  check(copied, values);
  Array<StoredObject, Real, Host, Soa, Plain> back(values.size());
  copy(back, array);
  for (index_t i = 0; i < size; ++i) expect_within<Formats>(back.view().get(i), values.view().get(i));
#ifdef __AVX__
  Array<StoredObject, Real, Host, Layout, Formats> packs(values.size());
  for (index_t i = 0; i < values.size(); i += width)
    packs.view().put(Pack<width>{i}, values.view().get(Pack<width>{i}));
  check(packs, values);
  Array<StoredObject, Real, Host, Soa, Plain> unpacked(values.size());
  const auto from = packs.const_view();
  for (index_t i = 0; i < values.size(); i += width) unpacked.view().put(Pack<width>{i}, from.get(Pack<width>{i}));
  for (index_t i = 0; i < size; ++i) expect_within<Formats>(unpacked.view().get(i), values.view().get(i));
#endif
}

// Formats know nothing of layouts: each meets both precisions, and by turns all layouts.
TEST(GoldenFormatsOfTheHost, keep_values_within_their_stated_errors) {
  keeps_values<float, Aosoa<8>, StoredFormats<Host>>();
  keeps_values<double, Aos, StoredFormats<Host>>();
}

TEST(GoldenFormatsOfCuda, keep_values_within_their_stated_errors) {
  keeps_values<float, Soa, StoredFormats<Cuda>>();
  keeps_values<double, Aosoa<32>, StoredFormats<Cuda>>();
}

TEST(GoldenFormatsOfAProgram, keep_values_within_their_stated_errors) {
  keeps_values<float, Aosoa<32>, Compact>();
  keeps_values<double, AosPadded, Compact>();
}

template <class Formats>
class GoldenFormats : public testing::Test {};
using AllFormats = testing::Types<StoredFormats<Host>, StoredFormats<Cuda>, Compact>;
TYPED_TEST_SUITE(GoldenFormats, AllFormats);

// Every byte that fields take is theirs alone; what is left are the ends of nested objects.
template <class Real, class Formats>
void has_bytes_of_its_own_for_every_element() {
  using Record = typename StoredObject::template Record<Real, Formats>;
  std::vector<bool> taken(Record::bytes);
  for (const FieldInfo& field : StoredObject::template fields<Real, Formats>) {
    const int element = element_bytes(field.type);
    EXPECT_EQ(field.offset % element, 0) << field.name;
    EXPECT_EQ(Record::alignment % element, 0) << field.name;
    for (int b = field.offset; b < field.offset + field.count * element; ++b) {
      ASSERT_LT(b, Record::bytes) << field.name;
      EXPECT_FALSE(taken[static_cast<std::size_t>(b)]) << field.name << " shares byte " << b;
      taken[static_cast<std::size_t>(b)] = true;
    }
  }
}

TYPED_TEST(GoldenFormats, give_every_element_bytes_of_its_own) {
  has_bytes_of_its_own_for_every_element<float, TypeParam>();
  has_bytes_of_its_own_for_every_element<double, TypeParam>();
}

TEST(GoldenFormatsOfAProgram, are_what_its_records_are_computed_from) {
  using Schemas = StoredObject::Record<float, StoredFormats<Host>>;
  using Own = StoredObject::Record<float, Compact>;
  // F 9 x 2 instead of 9 x 4, R 4 x 2 instead of 9 x 4, stress 6 x 4 instead of 6 x 2, frame 16 instead of 32.
  static_assert(Own::bytes == Schemas::bytes - 18 - 28 + 12 - 16);
  static_assert(Own::twice::offset == Schemas::twice::offset &&
                Own::R64::offset == Schemas::R64::offset);  // eight bytes still come first
  static_assert(Own::alignment == 8);
  const auto fields = StoredObject::fields<float, Compact>;
  const auto found =
      std::find_if(fields.begin(), fields.end(), [](const auto& field) { return field.name == "frame.turn"; });
  ASSERT_NE(found, fields.end());
  EXPECT_EQ(found->type, ElementType::bfloat16);
  EXPECT_EQ(found->count, 4);
  EXPECT_EQ(found->visible_count(), 9);
}

TEST(GoldenFormatsOfArrays, are_those_of_the_schema_for_the_space) {
  static_assert(std::is_same_v<StoredArray<float>::Formats, StoredFormats<Host>>);
  static_assert(std::is_same_v<StoredArray<float, Cuda>::Formats, StoredFormats<Cuda>>);
  static_assert(std::is_same_v<StoredFormats<PinnedHost>::F, StoredFormats<Host>::F>);
  static_assert(std::is_same_v<StoredFormats<Host>::F, format::Native>);
  static_assert(std::is_same_v<StoredFormats<Cuda>::F, format::Half<>>);
  static_assert(std::is_same_v<StoredFormats<Host>::load, format::Half<5>>);
  static_assert(std::is_same_v<StoredFormats<Cuda>::frames, FrameFormats<Cuda>>);
}

TEST(GoldenFormatsOfArrays, hold_the_initial_values_of_the_schema) {
  const Array<StoredObject, float, Host, Aosoa<8>, StoredFormats<Cuda>> array(3);
  const auto value = array.view().get(index_t{2});
  EXPECT_EQ(value.load, 1000);
  EXPECT_NEAR(value.angle, 0.5, 6.5 / 131068);
  EXPECT_NEAR(value.temperature, 310, 100.0 / 131068);
  EXPECT_NEAR(value.frames[1].weight, 0.25, 1.0 / 131068);
  EXPECT_EQ(value.plain_half, 0);
  EXPECT_NEAR(value.spin(2, 1), 0, 16.0 / 131068);
  EXPECT_EQ(value.count, 7);
  // Four zeros stand for no rotation.
  for (const auto& R : {value.R, value.Rhalf, value.R16, value.turns[2], value.many[32], value.frame.turn}) {
    expect_within({0, 1e-4}, R, Eigen::Matrix3f(Eigen::Matrix3f::Identity()), "a new rotation");
  }
}

TEST(GoldenFormatsOfArrays, have_elements_that_are_assigned_one_by_one) {
  StoredArray<double> array(9);
  const auto object = array.view()[8];
  object.load() = 640;
  object.load() += 64;
  EXPECT_EQ(double(object.load()), 704);
  object.halves(3) = 0.5;
  object.halves(3) *= object.halves(3);
  EXPECT_EQ(double(object.halves(3)), 0.25);
  EXPECT_EQ(double(object.halves(2)), 0);
  object.stress()(0, 2) = 1024;  // of the lower triangle
  EXPECT_EQ(double(object.stress()(2, 0)), 1024);
  object.frames(1).weight() = 1;
  EXPECT_EQ(double(object.frames(1).weight()), 1);
  EXPECT_NEAR(double(object.frames(0).weight()), 0.25, 1.0 / 131068);
  double* const plain = &object.F()(1, 2);  // as it is computed: a real reference
  *plain = 1.0 / 3;
  EXPECT_EQ(object.F().get()(1, 2), 1.0 / 3);
}

// Where hardware converts packs, it does the same.
TEST(GoldenFormatsOfPacks, are_the_same_as_of_single_objects) {
  constexpr int width = native_lanes<float>;
  Random random(seed);
  Array<FrameObject, float, Host, Aosoa<32>, FrameFormats<Cuda>> single(64), packs(64);
  Array<FrameObject, float, Host, Aos, PlainFrame> values(64);
  for (index_t i = 0; i < 64; ++i) values.view().put(i, random.frame<float>());
  for (index_t i = 0; i < 64; ++i) single.view().put(i, values.view().get(i));
  for (index_t i = 0; i < 64; i += width) packs.view().put(Pack<width>{i}, values.view().get(Pack<width>{i}));
  for (index_t i = 0; i < 64; ++i) {
    const auto a = single.view().get(i), b = packs.view().get(i);
    EXPECT_EQ(a.origin, b.origin) << i;
    EXPECT_EQ(a.weight, b.weight) << i;
    expect_within({0, 1.5e-4}, b.turn, a.turn, "turn");  // packs round the quaternion otherwise: a step
  }
}

}  // namespace
}  // namespace physgen::test
