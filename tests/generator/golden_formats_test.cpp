// The storage formats of golden/everything.physgen.h, compiled and run: random values are stored through views and by
// copies, in the formats of the host, of CUDA and of a program's own, and are read back within the errors that the
// generated comments state.
#include <gtest/gtest.h>
#include <physgen/runtime.h>
#include <physgen/simd_access.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "everything.physgen.h"

namespace physgen::test {
namespace {

using tissue::model::Frame;
using tissue::model::FrameFormats;
using tissue::model::FrameObject;
using tissue::model::Stored;
using tissue::model::StoredArray;
using tissue::model::StoredFormats;
using tissue::model::StoredObject;

// ---- Formats of a program's own -------------------------------------------------------------------------------------

struct PlainFrame : FrameFormats<Host> {
  using turn = format::Native;
  using weight = format::Native;
};
/// Everything as it is computed: what is stored in it is the value itself.
struct Plain : StoredFormats<Host> {
  using single = format::Native;
  using twice = format::Native;
  using narrowed = format::Native;
  using plain_half = format::Native;
  using load = format::Native;
  using wide = format::Native;
  using angle = format::Native;
  using stress = format::Native;
  using stretch = format::Native;
  using spin = format::Native;
  using R32 = format::Native;
  using R64 = format::Native;
  using Rhalf = format::Native;
  using Rbfloat = format::Native;
  using R16 = format::Native;
  using entries = format::Native;
  using halves = format::Native;
  using turns = format::Native;
  using many = format::Native;
  using frame = PlainFrame;
  using frames = PlainFrame;
};

struct CompactFrame : FrameFormats<Cuda> {
  using turn = format::Quaternion<format::Bfloat16>;
};
/// Some fields anew, of nested objects too; the others as the schema says for the host.
struct Compact : StoredFormats<Host> {
  using F = format::Bfloat16;
  using R = format::Quaternion16;
  using stress = format::Native;
  using frame = CompactFrame;
};

// ---- The errors that comments state ---------------------------------------------------------------------------------

struct Error {
  double relative = 0, absolute = 0;
};
constexpr Error exact{}, float32{6e-8, 0}, bfloat16{3.9e-3, 0};
constexpr Error half(double scale) {
  return {4.9e-4, 6.104e-5 * 4.9e-4 * scale};
}  // absolute below 6.1e-5 of the scale
constexpr Error steps(double low, double high) { return {0, (high - low) / 131068 * 1.0001}; }
constexpr Error quaternion16{0, 9e-5}, quaternion_half{0, 2e-3}, quaternion_bfloat16{0, 1.6e-2};
template <class Real>
constexpr double eps = std::numeric_limits<Real>::epsilon();
template <class Real>
constexpr Error quaternion{0, 10 * eps<Real>};

template <class Real>
struct FrameErrors {
  Error turn, origin, weight = steps(0, 1);
};
template <class Real>
struct Errors {
  Error temperature, stress, F, R, entries;
  FrameErrors<Real> frame, frames;
};

template <class Real, class Formats>
constexpr Errors<Real> errors() {
  constexpr FrameErrors<Real> host_frame{quaternion<Real>, exact}, cuda_frame{quaternion16, half(1)};
  if (std::is_same_v<Formats, StoredFormats<Cuda>>) {
    return {steps(273, 373), bfloat16, half(1), quaternion<Real>, steps(-1, 1), cuda_frame, cuda_frame};
  }
  if (std::is_same_v<Formats, Compact>) {
    return {exact, exact, bfloat16, quaternion16, half(1), {quaternion_bfloat16, half(1)}, host_frame};
  }
  return {exact, half(512), exact, exact, half(1), host_frame, host_frame};
}

/// `read` may differ by the error, and by rounding to the precision computed in.
template <class Real>
void expect_within(Error error, Real read, Real written, const char* name) {
  const bool is_exact = error.relative == 0 && error.absolute == 0;
  const double size = std::abs(static_cast<double>(written));
  const double allowed = is_exact ? 0 : error.relative * size + error.absolute + 2 * eps<Real> * size;
  EXPECT_LE(std::abs(static_cast<double>(read) - static_cast<double>(written)), allowed) << name << " = " << written;
}
template <class Real, int R, int C>
void expect_within(Error error, const Eigen::Matrix<Real, R, C>& read, const Eigen::Matrix<Real, R, C>& written,
                   const char* name) {
  for (int k = 0; k < R * C; ++k) expect_within(error, read(k % R, k / R), written(k % R, k / R), name);
}

template <class Real>
void expect_within(const FrameErrors<Real>& errors, const Frame<Real>& read, const Frame<Real>& written) {
  expect_within(errors.turn, read.turn, written.turn, "turn");
  expect_within(errors.origin, read.origin, written.origin, "origin");
  expect_within(errors.weight, read.weight, written.weight, "weight");
}

template <class Formats, class Real>
void expect_within(const Stored<Real>& read, const Stored<Real>& written) {
  constexpr Errors<Real> stated = errors<Real, Formats>();
  expect_within(float32, read.single, written.single, "single");
  expect_within(exact, read.twice, written.twice, "twice");
  expect_within(float32, read.narrowed, written.narrowed, "narrowed");
  expect_within(half(1), read.plain_half, written.plain_half, "plain_half");
  expect_within(half(32), read.load, written.load, "load");
  expect_within(bfloat16, read.wide, written.wide, "wide");
  expect_within(steps(-3.25, 3.25), read.angle, written.angle, "angle");
  expect_within(stated.temperature, read.temperature, written.temperature, "temperature");
  expect_within(stated.stress, read.stress, written.stress, "stress");
  expect_within(stated.F, read.F, written.F, "F");
  expect_within(half(1), read.stretch, written.stretch, "stretch");
  expect_within(steps(-8, 8), read.spin, written.spin, "spin");
  expect_within(stated.R, read.R, written.R, "R");
  expect_within({0, 1.2e-6}, read.R32, written.R32, "R32");
  expect_within(quaternion<Real>, read.R64, written.R64, "R64");
  expect_within(quaternion_half, read.Rhalf, written.Rhalf, "Rhalf");
  expect_within(quaternion_bfloat16, read.Rbfloat, written.Rbfloat, "Rbfloat");
  expect_within(quaternion16, read.R16, written.R16, "R16");
  expect_within(stated.entries, read.entries, written.entries, "entries");
  for (int e = 0; e < 5; ++e) expect_within(half(1), read.halves[e], written.halves[e], "halves");
  for (int e = 0; e < 3; ++e) expect_within(quaternion_half, read.turns[e], written.turns[e], "turns");
  for (int e = 0; e < 33; ++e) expect_within(quaternion16, read.many[e], written.many[e], "many");
  EXPECT_EQ(read.count, written.count);
  expect_within(stated.frame, read.frame, written.frame);
  for (int e = 0; e < 2; ++e) expect_within(stated.frames, read.frames[e], written.frames[e]);
}

// ---- Random values --------------------------------------------------------------------------------------------------

class Random {
 public:
  explicit Random(unsigned seed) : random_(seed) {}

  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  template <class Real>
  Eigen::Matrix<Real, 3, 3> rotation() {
    std::normal_distribution<double> normal;
    const Eigen::Quaterniond q(normal(random_), normal(random_), normal(random_), normal(random_));
    return q.normalized().toRotationMatrix().cast<Real>();
  }
  template <class Matrix>
  Matrix matrix(double low, double high) {
    return Matrix::NullaryExpr([&] { return static_cast<typename Matrix::Scalar>(between(low, high)); });
  }
  template <class Real>
  Frame<Real> frame() {
    return {rotation<Real>(), matrix<Eigen::Matrix<Real, 3, 1>>(-2, 2), static_cast<Real>(between(0, 1))};
  }
  template <class Real>
  Stored<Real> stored() {
    using Matrix = Eigen::Matrix<Real, 3, 3>;
    Stored<Real> value;
    value.single = static_cast<Real>(between(-1e9, 1e9));
    value.twice = static_cast<Real>(between(-1e9, 1e9));
    value.narrowed = between(-1, 1);
    value.plain_half = static_cast<Real>(between(-65504, 65504));
    value.load = static_cast<Real>(between(0, 1e6));
    value.wide = static_cast<Real>(std::pow(10.0, between(-30, 30)));
    value.angle = static_cast<Real>(between(-3.25, 3.25));
    value.temperature = static_cast<Real>(between(273, 373));
    value.stress = matrix<Matrix>(-1e7, 1e7).template selfadjointView<Eigen::Lower>();
    value.F = matrix<Matrix>(-3, 3);
    value.stretch = matrix<Eigen::Matrix<Real, 3, 1>>(-2, 4);
    const Matrix any = matrix<Matrix>(-4, 4);
    value.spin = any - any.transpose();
    for (auto* R : {&value.R, &value.R32, &value.R64, &value.Rhalf, &value.Rbfloat, &value.R16, &value.entries}) {
      *R = rotation<Real>();
    }
    for (Real& entry : value.halves) entry = static_cast<Real>(between(-100, 100));
    for (Matrix& entry : value.turns) entry = rotation<Real>();
    for (Matrix& entry : value.many) entry = rotation<Real>();
    value.count = static_cast<std::int32_t>(random_());
    value.frame = frame<Real>();
    for (Frame<Real>& entry : value.frames) entry = frame<Real>();
    return value;
  }

 private:
  std::mt19937 random_;
};

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

template <class Formats>
class GoldenFormats : public testing::Test {};
using AllFormats = testing::Types<StoredFormats<Host>, StoredFormats<Cuda>, Compact>;
TYPED_TEST_SUITE(GoldenFormats, AllFormats);

TYPED_TEST(GoldenFormats, keep_values_within_their_stated_errors_in_float) {
  keeps_values<float, Aos, TypeParam>();
  keeps_values<float, Soa, TypeParam>();
  keeps_values<float, Aosoa<8>, TypeParam>();
}

TYPED_TEST(GoldenFormats, keep_values_within_their_stated_errors_in_double) {
  keeps_values<double, AosPadded, TypeParam>();
  keeps_values<double, Aosoa<32>, TypeParam>();
}

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
