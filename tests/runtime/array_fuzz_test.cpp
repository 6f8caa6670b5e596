// Arrays of many types, layouts and sizes under random copies and changes, held against the bytes of their objects.
#include "stored_records.h"

namespace physgen::test {
namespace {

struct CompactTurns : elasticity::DeformationSvdFormats<Host> {
  using U = format::Quaternion<format::Half<>>;
  using V = format::Quaternion16;
  using s = format::Bfloat16;
};

/// Objects of one array in the form of another, each by a copy of its own: what a copy of all must give.
/// @param one, converted an AoS record in the form of each
Records converted_one_by_one(const UntypedArray& from, index_t begin, index_t end, const UntypedArray& one,
                             const UntypedArray& converted) {
  Records records;
  for (index_t i = begin; i < end; ++i) {
    const Record record = record_at(from, i);
    std::size_t read = 0;
    for (const FieldInfo& field : one.fields) {
      const auto bytes = static_cast<std::size_t>(field.count * element_bytes(field.type));
      std::memcpy(one.base + field.offset, record.data() + read, bytes);
      read += bytes;
    }
    copy(converted, one);
    records.push_back(record_at(converted, 0));
  }
  return records;
}
template <class To, class From>
Records converted_one_by_one(const From& from, index_t begin, index_t end) {
  const Array<typename From::Object, typename From::Precision, Host, Aos, typename From::Formats> one(1);
  const Array<typename To::Object, typename To::Precision, Host, Aos, typename To::Formats> converted(1);
  return converted_one_by_one(from.untyped(), begin, end, one.untyped(), converted.untyped());
}

/// Renumbers the field of indices to numbers in random order, and expects all other elements as before.
void renumber_field(const UntypedArray& untyped, const FieldInfo& field, std::mt19937& random) {
  const std::vector<index_t> numbers = random_order(1000, random);
  int first = 0;  // the field's first element, as code counts them
  for (const FieldInfo& other : untyped.fields) {
    if (other.offset == field.offset) break;
    first += other.visible_count();
  }
  const int last = first + field.visible_count();
  for (index_t i = 0; i < untyped.size; ++i) {
    for (int k = first; k < last; ++k) {  // initial values may name no object
      if (getdata(untyped, i, k) < 0) putdata(untyped, i, k, 0);
    }
  }
  const Model before = elements_of(untyped);
  renumber(untyped, field.name, numbers);
  const Model after = elements_of(untyped);
  for (std::size_t i = 0; i < before.size(); i += 7) {
    Model::value_type expected = before[i];
    for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(last); ++k) {
      expected[k] = static_cast<double>(numbers[static_cast<std::size_t>(expected[k])]);
    }
    ASSERT_EQ(after[i], expected) << "renumber " << field.name;
  }
}

template <class A, class B>
void fuzz_pair_of_size(index_t n, std::mt19937& random) {
  using Object = typename A::Object;
  A a(n);
  B b(n);
  copy(a, random_objects<Object>(n, random));
  copy(b, a);
  Records model = converted_one_by_one<B>(a, 0, n);
  expect_records(b.untyped(), model, "a copy");
  copy(a, b);
  expect_records(a.untyped(), converted_one_by_one<A>(b, 0, n), "a copy back");

  for (int repeat = 0; repeat < 3; ++repeat) {
    const auto begin = static_cast<index_t>(random() % static_cast<unsigned>(n + 1));
    const auto end = begin + static_cast<index_t>(random() % static_cast<unsigned>(n - begin + 1));
    copy(a, random_objects<Object>(n, random));
    copy_range(b.untyped(), a.untyped(), begin, end);
    const Records part = converted_one_by_one<B>(a, begin, end);
    std::copy(part.begin(), part.end(), model.begin() + begin);
    expect_records(b.untyped(), model, "a copy of " + std::to_string(begin) + " to " + std::to_string(end));
  }

  const std::vector<index_t> erased = random_part(n, random);
  Records kept;
  for (const index_t i : remaining(n, erased)) kept.push_back(model[static_cast<std::size_t>(i)]);
  erase(b, erased);
  model = kept;
  expect_records(b.untyped(), model, "erasing");

  append(b, a);
  const Records added = converted_one_by_one<B>(a, 0, n);
  model.insert(model.end(), added.begin(), added.end());
  expect_records(b.untyped(), model, "appending objects of another form");

  const B fresh(1);
  const Record initial = record_at(fresh.untyped(), 0);
  append(b, 37);
  model.insert(model.end(), 37, initial);
  expect_records(b.untyped(), model, "appending new ones");

  const index_t less = b.size() / 3;
  b.resize(less);
  b.resize(less + 70);
  model.resize(static_cast<std::size_t>(less));
  model.resize(static_cast<std::size_t>(less + 70), initial);
  expect_records(b.untyped(), model, "shrinking and growing");

  for (const FieldInfo& field : b.untyped().fields) {
    if (field.type == ElementType::int32) renumber_field(b.untyped(), field, random);
  }
}

template <class A, class B>
struct Pair {
  static void fuzz() {
    std::mt19937 random(seed());
    for (const index_t n : {0, 1, 2, 3, 31, 32, 33, 63, 64, 65, 127, 1023, 1025, 2049}) {
      // Few objects in most runs: one conversion for each is the slow part.
      fuzz_pair_of_size<A, B>(n, random);
      if (::testing::Test::HasFatalFailure()) FAIL() << A::Object::name << " of " << n << " objects";
    }
  }
};

using namespace elasticity;
using Shapes = tissue::model::ShapesObject;
using Patch = tissue::other::PatchObject;

TEST(ArrayFuzz, of_vectors) {
  Pair<Array<NodePositionObject, float, Host, Aos>, Array<NodePositionObject, float, Host, Soa>>::fuzz();
  Pair<Array<NodePositionObject, float, Host, Aosoa<2>>, Array<NodePositionObject, double, Host, Aosoa<64>>>::fuzz();
  Pair<Array<NodePositionObject, double, Host, AosPadded>, Array<NodePositionObject, float, Host, Aosoa<1024>>>::fuzz();
}
TEST(ArrayFuzz, of_indices) {
  Pair<Array<TetObject, float, Host, Soa>, Array<TetObject, float, Host, Aosoa<4>>>::fuzz();
  Pair<Array<TetObject, float, Host, AosPadded>, Array<TetObject, double, Host, Aosoa<64>>>::fuzz();
}
TEST(ArrayFuzz, of_rotations_and_quaternions) {
  using Svd = DeformationSvdObject;
  Pair<Array<Svd, float, Host, Aos>, Array<Svd, float, Host, Soa, CompactTurns>>::fuzz();
  Pair<Array<Svd, float, Host, Aosoa<64>, CompactTurns>, Array<Svd, double, Host, AosPadded>>::fuzz();
  Pair<Array<Svd, float, Host, Aos, CompactTurns>, Array<Svd, double, Host, Aosoa<4>, CompactTurns>>::fuzz();
  Pair<Array<IndexedFrameObject, float, Host, Aosoa<8>>, Array<IndexedFrameObject, float, Host, Soa>>::fuzz();
}
TEST(ArrayFuzz, of_elements_of_mixed_sizes) {
  using Derivative = StressDerivativeObject;
  Pair<Array<Derivative, float, Host, Aosoa<16>, MixedDerivative>, Array<Derivative, float, Host, Soa>>::fuzz();
  Pair<Array<Derivative, double, Host, Aos>, Array<Derivative, float, Host, Aosoa<2>, MixedDerivative>>::fuzz();
  Pair<Array<Derivative, float, Host, AosPadded, MixedDerivative>,
       Array<Derivative, double, Host, Aosoa<1024>, MixedDerivative>>::fuzz();
}
TEST(ArrayFuzz, of_nested_objects_and_every_shape) {
  Pair<Array<Shapes, float, Host, Aos>, Array<Shapes, float, Host, Soa>>::fuzz();
  Pair<Array<Shapes, double, Host, Aosoa<64>>, Array<Shapes, float, Host, Aosoa<4>>>::fuzz();
  Pair<Array<Patch, float, Host, AosPadded>, Array<Patch, float, Host, Aosoa<32>>>::fuzz();
  Pair<Array<Patch, float, Host, Soa>, Array<Patch, double, Host, Aos>>::fuzz();
}
TEST(ArrayFuzz, of_records_of_two_and_six_bytes) {
  Pair<Array<HalvesObject<1>, float, Host, Aos>, Array<HalvesObject<1>, float, Host, Aosoa<64>>>::fuzz();
  Pair<Array<HalvesObject<1>, float, Host, AosPadded>, Array<HalvesObject<1>, double, Host, Soa>>::fuzz();
  Pair<Array<HalvesObject<3>, float, Host, Aosoa<2>>, Array<HalvesObject<3>, float, Host, AosPadded>>::fuzz();
  Pair<Array<HalvesObject<3>, double, Host, Soa>, Array<HalvesObject<3>, float, Host, Aos>>::fuzz();
}

}  // namespace
}  // namespace physgen::test
