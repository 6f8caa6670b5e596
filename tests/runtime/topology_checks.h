// Changes of topology in every layout of one space, held against a vector of objects: one source for host, pinned and
// CUDA memory.
#pragma once

#include <everything.physgen.h>
#include <physgen/topology.h>

#include "array_model.h"
#include "format_checks.h"
#include "precision_by_layout.h"

namespace physgen::test {

/// Parts of generated object types that no check here uses.
struct WithoutAccessors {
  template <class Real>
  using Value = Real;
  template <class Real, class Formats, class Cursor>
  using Ref = Cursor;
  template <class Space>
  struct Formats {};
};

/// A rotation, stored as a quaternion, and an index behind it.
struct IndexedFrameObject : WithoutAccessors {
  static constexpr std::string_view name = "test::IndexedFrame";
  template <class Real, class Formats>
  struct Record {
    static constexpr int bytes = 4 * sizeof(Real) + 4;
    static constexpr int alignment = sizeof(Real);
  };
  template <class Real, class Formats>
  static constexpr std::array<FieldInfo, 2> fields = {
      {field_info<shape::Rotation, format::Quaternion<>, Real>("R", "", 0, 1, 0),
       field_info<shape::Scalar, format::Native, std::int32_t>("node", "", 4 * sizeof(Real), 1, 0)}};
};

template <class Object, class Real, class Space, class Layout, class Formats = FormatsOf<Object, Space>>
void check_changes(index_t n, std::mt19937& random) {
  using Tested = Array<Object, Real, Space, Layout, Formats>;
  Random<Tested> tested(n, random);
  Tested& array = tested.array;
  Model& model = tested.model;

  const std::vector<index_t> order = random_order(n, random);
  permute(array, order);
  model = picked(model, order);
  expect_sound(array, model);

  const std::vector<index_t> erased = random_part(n, random);
  const std::vector<index_t> kept = remaining(n, erased);
  Tested compacted = array;
  erase(array, erased);
  compact(compacted, kept);
  model = picked(model, kept);
  expect_sound(array, model);
  expect_sound(compacted, model);

  append(array, 37);
  const Model added = objects_of(Array<Object, Real, Host, Aos>(37));
  model.insert(model.end(), added.begin(), added.end());
  expect_sound(array, model);

  Random<Tested> same(n, random);
  append(array, same.array);
  model.insert(model.end(), same.model.begin(), same.model.end());
  expect_sound(array, model);

  Random<Array<Object, Real, Host, Soa>> other(n, random);
  append(array, other.array);
  Tested converted(n);
  copy(converted, other.array);
  const Model others = objects_of(converted);
  if (is_exact(array.untyped())) {
    ASSERT_EQ(others, other.model);
  }
  model.insert(model.end(), others.begin(), others.end());
  expect_sound(array, model);

  append(array, array);
  model.reserve(2 * model.size());
  model.insert(model.end(), model.begin(), model.end());
  expect_sound(array, model);
}

/// Every object type in this layout: in floats or in doubles by turns, so that each type has both precisions among the
/// layouts, and each layout among the types.
template <class Space, class Layout>
void check_changes_of_all_object_types() {
  using Even = EvenReal<Layout>;
  using Odd = OddReal<Layout>;
  std::mt19937 random(seed());
  for (const index_t n : {0, 1, 31, 32, 33, 1000, 5000}) {
    check_changes<elasticity::NodePositionObject, Even, Space, Layout>(n, random);
    check_changes<elasticity::TetObject, float, Space, Layout>(n, random);  // the same in both precisions
  }
  for (const index_t n : {0, 1, 31, 32, 33, 500}) {
    check_changes<elasticity::DeformationSvdObject, Odd, Space, Layout>(n, random);
    check_changes<tissue::model::ShapesObject, Even, Space, Layout>(n, random);  // of 4 and 8 bytes
    check_changes<tissue::model::OptionsObject, Odd, Space, Layout>(n, random);  // with initial values
    check_changes<tissue::other::PatchObject, Even, Space, Layout>(n, random);   // nested
    // Elements of 2, 4 and 8 bytes; quaternions of halves.
    check_changes<elasticity::StressDerivativeObject, Odd, Space, Layout, MixedDerivative>(n, random);
    if constexpr (!checked_build) {  // which refuses random matrices that are no rotations
      check_changes<elasticity::DeformationSvdObject, float, Space, Layout, CompactSvd<format::Half<>>>(n, random);
    }
  }
}

/// Objects that are appended in another precision are converted.
template <class Space, class Layout>
void check_append_of_another_precision() {
  std::mt19937 random(seed());
  using Object = elasticity::RestShapeObject;
  Random<Array<Object, float, Space, Layout>> tested(45, random);
  Random<Array<Object, double, Host, Aosoa<8>>> other(77, random);  // whose values are floats, see randomise()
  append(tested.array, other.array);
  tested.model.insert(tested.model.end(), other.model.begin(), other.model.end());
  expect_sound(tested.array, tested.model);
}

/// Three arrays over the same elements, in layouts of their own; the last is the one under test.
template <class Space, class Layout>
struct ElementSet {
  Random<elasticity::TetArray<float, Host, Aos>> tets;
  Random<elasticity::RestShapeArray<double, Space, Soa>> shapes;
  Random<elasticity::StressDerivativeArray<float, Space, Layout>> derivatives;

  ElementSet(index_t n, std::mt19937& random) : tets(n, random), shapes(n, random), derivatives(n, random) {}

  [[nodiscard]] auto arrays() { return ArraySet(tets.array, shapes.array, derivatives.array); }
  void expect_sound() const {
    test::expect_sound(tets.array, tets.model);
    test::expect_sound(shapes.array, shapes.model);
    test::expect_sound(derivatives.array, derivatives.model);
  }
  void pick(const std::vector<index_t>& numbers) {
    tets.model = picked(tets.model, numbers);
    shapes.model = picked(shapes.model, numbers);
    derivatives.model = picked(derivatives.model, numbers);
  }
};

template <class Space, class Layout>
void check_set() {
  std::mt19937 random(seed());
  for (const index_t n : {0, 1, 33, 5000}) {
    ElementSet<Space, Layout> set(n, random);
    auto arrays = set.arrays();
    const std::vector<index_t> order = random_order(n, random);
    arrays.permute(order);
    set.pick(order);
    set.expect_sound();

    const std::vector<index_t> erased = random_part(n, random);
    arrays.erase(erased);
    set.pick(remaining(n, erased));
    set.expect_sound();

    ElementSet<Space, Aos> other(19, random);
    arrays.append(other.tets.array, other.shapes.array, other.derivatives.array);
    arrays.append(4);
    EXPECT_EQ(arrays.size(), n - n / 2 + 23);
    const auto extend = [](Model& model, const Model& added) {
      model.insert(model.end(), added.begin(), added.end());
      model.resize(model.size() + 4, std::vector<double>(added.front().size(), 0));
    };
    extend(set.tets.model, other.tets.model);
    extend(set.shapes.model, other.shapes.model);
    extend(set.derivatives.model, other.derivatives.model);
    set.expect_sound();
  }
}

/// Every failure of a set leaves all its arrays as they were, be it that only the last could not be built.
template <class Space, class Layout>
void check_failures_of_a_set_change_nothing() {
  std::mt19937 random(seed());
  ElementSet<Space, Layout> set(100, random);
  auto arrays = set.arrays();
  const std::vector<index_t> too_short(99, 0);
  const std::vector<index_t> not_there = {3, 100};
  ElementSet<Space, Aos> other(5, random);
  const auto fewer = elasticity::RestShapeArray<double, Space, Soa>(4);
  EXPECT_NE(message_of([&] { arrays.permute(too_short); }).find("an order of 99 numbers cannot permute 100 objects"),
            std::string::npos);
  EXPECT_NE(message_of([&] { arrays.compact(not_there); }).find("elasticity::RestShape[100]"), std::string::npos);
  EXPECT_NE(message_of([&] { arrays.erase(not_there); }).find("number 100 at position 1"), std::string::npos);
  EXPECT_NE(message_of([&] { arrays.append(other.tets.array, fewer, other.derivatives.array); }).find("same size"),
            std::string::npos);
  for (const index_t count : {index_t{1} << 40, index_t{1} << 60}) EXPECT_THROW(arrays.append(count), Error) << count;
  set.expect_sound();
}

/// An object that no machine can hold many of.
struct EnormousObject : WithoutAccessors {
  static constexpr std::string_view name = "test::Enormous";
  template <class Real, class Formats>
  struct Record {
    static constexpr int bytes = 1 << 20;
    static constexpr int alignment = sizeof(double);
  };
  template <class Real, class Formats>
  static constexpr std::array<FieldInfo, 1> fields = {
      {field_info<shape::Scalar, format::Native, Real>("value", "", 4096, 1, 0)}};
};

/// Memory lasts for the first new array of the set and not for the second.
template <class Space, class Layout>
void check_memory_that_runs_out_half_way() {
  std::mt19937 random(seed());
  Random<elasticity::IncidenceArray<float, Space, Layout>> small(3, random);
  Random<Array<EnormousObject, float, Space, Layout>> enormous(3, random);
  const index_t count = index_t{1} << 23;
  const elasticity::IncidenceArray<float, Space, Layout> memory_lasts(count);
  const std::string message = message_of([&] { ArraySet(small.array, enormous.array).append(count); });
  EXPECT_NE(message.find("test::Enormous[8388611]: cannot allocate"), std::string::npos) << message;
  expect_sound(small.array, small.model);
  expect_sound(enormous.array, enormous.model);
}

/// Faults of a list of numbers, and the messages on them.
template <class Space, class Layout>
void check_refused_lists() {
  std::mt19937 random(seed());
  Random<elasticity::NodePositionArray<float, Space, Layout>> tested(5, random);
  auto& array = tested.array;
  using List = std::vector<index_t>;
  const auto expect = [](const std::string& message, const std::string& part) {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  const auto permuting = [&](const List& order) { return message_of([&] { permute(array, order); }); };
  const auto compacting = [&](const List& kept) { return message_of([&] { compact(array, kept); }); };
  const auto erasing = [&](const List& erased) { return message_of([&] { erase(array, erased); }); };
  expect(permuting({0, 1, 2}), "elasticity::NodePosition[5] in " + std::string(name(Space::kind)) +
                                   " memory: an order of 3 numbers cannot permute 5 objects; write each object once");
  expect(permuting({0, 1, 5, -1, 4}), "number 5 at position 2 of the list: this object does not exist; write 0 to 4");
  expect(permuting({0, 1, -1, 3, 4}), "number -1 at position 2");
  expect(permuting({4, 3, 2, 3, 4}), "number 3 at position 3 of the list: it stands at position 1 already");
  expect(compacting({0, 2, 1}), "number 1 at position 2 of the list: it follows 2; sort the list");
  expect(compacting({0, 2, 2}), "number 2 at position 2 of the list: it follows 2");
  expect(compacting({0, 2, 7}), "number 7 at position 2 of the list: this object does not exist; write 0 to 4");
  expect(erasing({4, 0, 4}), "number 4 at position 2 of the list: it stands at position 0 already");
  expect(erasing({4, -3}), "number -3 at position 1 of the list: this object does not exist");
  expect(message_of([&] { append(array, -1); }), "cannot append -1 objects");
  expect(message_of([&] { append(array, std::numeric_limits<index_t>::max()); }), "cannot append 9223372036854775807");
  expect(message_of([&] { append(array, index_t{1} << 60); }), "cannot exist");
  expect_sound(array, tested.model);
}

}  // namespace physgen::test
