// The headers in golden/, compiled and run: every field of every object is written through accessors and through
// values, in both precisions and by turns in every layout, one object at a time and in SIMD packs, and read back by
// every way there is.
#include "golden_run.h"

#include <gtest/gtest.h>

#include <cstring>
#include <new>
#include <set>
#include <tuple>

#include "everything.physgen.h"

namespace physgen::test {
namespace {

// The fields of each object, in order of declaration. `ref` gives accessors, `value` members.

template <Action action, class Ref, class Real>
void walk(Walk<action>& w, const Ref& ref, material::Lame<Real>& value) {
  w.one(ref.mu(), value.mu);
  w.one(ref.lambda(), value.lambda);
}

template <Action action, class Ref, class Real>
void walk(Walk<action>& w, const Ref& ref, material::Fibre<Real>& value) {
  w.many(Full{}, ref.direction(), value.direction, 3);
  w.one(ref.strength(), value.strength);
}

template <Action action, class Ref, class Real>
void walk(Walk<action>& w, const Ref& ref, tissue::Stamp<Real>& value) {
  w.one(ref.time(), value.time);
  w.one(ref.step(), value.step);
}

template <Action action, class Ref, class Real>
void walk(Walk<action>& w, const Ref& ref, tissue::model::Shapes<Real>& value) {
  w.one(ref.a(), value.a);
  w.many(Full{}, ref.v(), value.v, 3);
  w.many(Full{}, ref.nodes(), value.nodes, 4);
  w.many(Full{}, ref.F(), value.F, 9);
  w.many(Full{}, ref.B(), value.B, 6);
  w.many(Full{}, ref.row(), value.row, 4);
  w.many(Symmetric{}, ref.K(), value.K, 6);
  w.many(Symmetric{}, ref.C2(), value.C2, 3);
  w.many(Full{}, ref.s(), value.s, 3);
  w.many(Skew{}, ref.W(), value.W, 3);
  w.many(Full{}, ref.U(), value.U, 9);
  w.many(Full{}, ref.V(), value.V, 9);
  w.many(Full{}, ref.count(), value.count, 2);
  w.many(Full{}, ref.M(), value.M, 4);
}

template <Action action, class Ref, class Real>
void walk(Walk<action>& w, const Ref& ref, tissue::model::Names<Real>& value) {
  w.one(ref.value(), value.value);
  w.one(ref.entry(), value.entry);
  w.one(ref.S(), value.S);
  w.one(ref.R(), value.R);
  w.one(ref.at(), value.at);
  w.one(ref.cursor(), value.cursor);
  w.one(ref.name(), value.name);
  w.one(ref.fields(), value.fields);
  w.one(ref.Layout(), value.Layout);
  w.one(ref.host(), value.host);
  w.one(ref.plan(), value.plan);
  w.one(ref.slot(), value.slot);
  w.one(ref.stride(), value.stride);
  w.one(ref.offset(), value.offset);
  w.one(ref.format(), value.format);
  w.one(ref.Native(), value.Native);
  w.one(ref.PerSpace(), value.PerSpace);
  w.one(ref.field(), value.field);
  w.one(ref.element(), value.element);
  w.one(ref.nested(), value.nested);
  for (int e = 0; e < 2; ++e) w.one(ref.self(e), value.self[e]);
  w.one(ref.assign(), value.assign);
  w.one(ref.texts(), value.texts);
  w.one(ref.Inner(), value.Inner);
  w.many(Full{}, ref.tissue(), value.tissue, 2);
}

template <Action action, class Ref, class Real>
void walk(Walk<action>& w, const Ref& ref, tissue::model::Entries<Real>& value) {
  for (int e = 0; e < 5; ++e) w.one(ref.weights(e), value.weights[e]);
  for (int e = 0; e < 4; ++e) w.many(Symmetric{}, ref.k(e), value.k[e], 6);
  for (int e = 0; e < 3; ++e) w.one(ref.flags(e), value.flags[e]);
  for (int e = 0; e < 40; ++e) w.one(ref.history(e), value.history[e]);
  for (int e = 0; e < 6; ++e) w.many(Full{}, ref.edges(e), value.edges[e], 2);
  for (int e = 0; e < 2; ++e) w.one(ref.entry(e), value.entry[e]);
}

template <Action action, class Ref, class Real>
void walk(Walk<action>& w, const Ref& ref, tissue::model::Options<Real>& value) {
  w.one(ref.density(), value.density);
  w.one(ref.nu(), value.nu);
  w.many(Full{}, ref.direction(), value.direction, 3);
  w.many(Symmetric{}, ref.metric(), value.metric, 6);
  w.one(ref.label(), value.label);
  w.many(Full{}, ref.group(), value.group, 2);
  w.many(Skew{}, ref.spin(), value.spin, 3);
  w.one(ref.fixed(), value.fixed);
}

template <Action action, class Ref, class Real>
void walk(Walk<action>& w, const Ref& ref, tissue::model::Element<Real>& value) {
  w.one(ref.flag(), value.flag);
  walk(w, ref.lame(), value.lame);
  for (int e = 0; e < 2; ++e) walk(w, ref.fibres(e), value.fibres[e]);
  walk(w, ref.stamp(), value.stamp);
  walk(w, ref.shapes(), value.shapes);
  w.one(ref.volume(), value.volume);
}

template <Action action, class Ref, class Real>
void walk(Walk<action>& w, const Ref& ref, tissue::other::Patch<Real>& value) {
  for (int e = 0; e < 2; ++e) walk(w, ref.elements(e), value.elements[e]);
  w.one(ref.weight(), value.weight);
  walk(w, ref.options(), value.options);
}

constexpr index_t size = 70;  // more than two tiles of the widest layout, and a part of one

// Writes object(s) i, of which the first is `first`, through accessors, or through a value and put.
template <class Array, class I>
void write(const typename Array::View& view, I i, index_t first, bool by_accessors) {
  typename Array::View::template Value<I> value{};
  if (by_accessors) {
    Walk<Action::write_accessors> w(first, Array::elements);
    walk(w, view[i], value);
    EXPECT_EQ(w.elements(), Array::elements);
  } else {
    Walk<Action::fill_value> w(first, Array::elements);
    walk(w, view[i], value);
    view.put(i, value);
  }
}

// Reads object(s) i by accessors and by get.
template <class Array, class I>
void check(const typename Array::ConstView& view, I i, index_t first) {
  auto value = view.get(i);
  Walk<Action::check> w(first, Array::elements);
  walk(w, view[i], value);
}

template <class Array>
void check_all(const Array& array) {
  const typename Array::ConstView view = array.view();
  for (index_t i = 0; i < size; ++i) {
    check<Array>(view, i, i);
    for (int k = 0; k < Array::elements; ++k) {
      ASSERT_EQ(array.getdata(i, k), static_cast<double>(1 + i * Array::elements + k))
          << "object " << i << " element " << k;
    }
  }
}

template <class Object, class Real, class Layout>
void round_trips() {
  SCOPED_TRACE(std::string(Object::name) + (sizeof(Real) == 4 ? " float " : " double ") + Layout::name);
  using A = Array<Object, Real, Host, Layout>;
  for (const bool by_accessors : {true, false}) {
    A array(size);
    for (index_t i = size - 1; i >= 0; --i) write<A>(array.view(), i, i, by_accessors);
    check_all(array);
    Array<Object, double, Host, Soa> other(size);
    copy(other, array);
    check_all(other);
  }
#ifdef __AVX__
  constexpr int width = 4;  // the widest for which AVX has registers of double as well as of int
  using Index = Pack<width>;
  for (const bool by_accessors : {true, false}) {
    A array(align_up(size, index_t{width}));
    for (index_t i = 0; i < size; i += width) write<A>(array.view(), Index{i}, i, by_accessors);
    for (index_t i = 0; i < size; i += width) check<A>(array.const_view(), Index{i}, i);
    check_all(array);
  }
#endif
}

template <class Object>
class GoldenRun : public testing::Test {};

using Objects = testing::Types<material::LameObject, material::FibreObject, tissue::StampObject,
                               tissue::model::ShapesObject, tissue::model::NamesObject, tissue::model::EntriesObject,
                               tissue::model::OptionsObject, tissue::model::ElementObject, tissue::other::PatchObject>;
TYPED_TEST_SUITE(GoldenRun, Objects);

template <class Object, class... All>
constexpr std::size_t place_in(testing::Types<All...> /*list*/) {
  std::size_t place = 0, k = 0;
  ((place = std::is_same_v<Object, All> ? k : place, ++k), ...);
  return place;
}

// By turns in float and double, and in two of five layouts each, so that each object meets both precisions, and each
// layout both of them and several objects: where an element lies is said by the object's record in a precision, and by
// the layout for any record. Nothing that is generated knows of layouts.
TYPED_TEST(GoldenRun, every_field_keeps_its_value) {
  constexpr std::size_t place = place_in<TypeParam>(Objects());
  using Layouts = std::tuple<Aos, AosPadded, Soa, Aosoa<8>, Aosoa<32>>;
  using First = std::conditional_t<place % 2 == 0, float, double>;
  using Second = std::conditional_t<place % 2 == 0, double, float>;
  round_trips<TypeParam, First, std::tuple_element_t<place % 5, Layouts>>();
  round_trips<TypeParam, Second, std::tuple_element_t<(place + 2) % 5, Layouts>>();
}

TYPED_TEST(GoldenRun, fields_have_different_names) {
  std::set<std::string_view> names;
  constexpr auto& fields = TypeParam::template fields<float, typename TypeParam::template Formats<Host>>;
  for (const FieldInfo& field : fields) names.insert(field.name);
  EXPECT_EQ(names.size(), fields.size());
}

TEST(GoldenRun, new_objects_have_the_initial_values_of_the_schema) {
  using tissue::model::OptionsArray;
  const OptionsArray<double> array(3);
  const auto stored = array.view().get(index_t{2});
  const tissue::model::Options<double> made;
  for (const auto* value : {&stored, &made}) {
    EXPECT_EQ(value->density, 1060);
    EXPECT_EQ(value->nu, 0.45);
    EXPECT_EQ(value->direction, Eigen::Vector3d::Constant(0.5));
    EXPECT_EQ(value->metric, Eigen::Matrix3d::Constant(1));
    EXPECT_EQ(value->label, -1);
    EXPECT_EQ(value->group, Eigen::Vector2i::Constant(7));
    EXPECT_EQ(value->fixed, 1e-12);
  }
  EXPECT_EQ(stored.spin(1, 0), 0.25);
  EXPECT_EQ(stored.spin(0, 1), -0.25);
}

TEST(GoldenRun, arrays_have_the_layouts_and_records_the_alignment_of_the_schema) {
  using tissue::model::OptionsArray;
  using tissue::model::OptionsView;
  static_assert(std::is_same_v<OptionsArray<float>::View, OptionsView<float, Soa>>);
  static_assert(std::is_same_v<OptionsArray<float, Cuda>::View::Layout, AosPadded>);
  static_assert(std::is_same_v<OptionsArray<float, PinnedHost>::View::Layout, Soa>);
  static_assert(std::is_same_v<tissue::model::ElementArray<double, Cuda>::View::Layout, Aosoa<64>>);
  static_assert(std::is_same_v<tissue::model::ShapesArray<float>::View, tissue::model::ShapesView<float, Aosoa<16>>>);
  EXPECT_EQ((OptionsView<float, Aos>::record_bytes % 32), 0);
  EXPECT_EQ((OptionsView<double, AosPadded>::record_bytes % 32), 0);
}

/// A value that is declared where other bits lay before.
template <class Value>
const Value& declared() {
  alignas(64) static std::byte memory[sizeof(Value)];
  std::memset(memory, 0xA5, sizeof memory);
  return *new (memory) Value;
}

TEST(GoldenRun, values_that_are_declared_begin_as_0_or_as_the_schema_says_and_rotations_as_the_identity) {
  const auto& shapes = declared<tissue::model::Shapes<float>>();
  EXPECT_EQ(shapes.a, 0);
  EXPECT_EQ(shapes.F, Eigen::Matrix3f::Zero());
  EXPECT_EQ(shapes.U, Eigen::Matrix3f::Identity());
  EXPECT_EQ(shapes.nodes.cwiseAbs().maxCoeff(), 0);
  const auto& options = declared<tissue::model::Options<double>>();
  EXPECT_EQ(options.nu, 0.45);
  EXPECT_EQ(options.spin, Eigen::Matrix3d::Zero());
  const auto& element = declared<tissue::model::Element<double>>();
  EXPECT_EQ(element.fibres[1].direction, declared<material::Fibre<double>>().direction) << "nested objects do so, too";
  EXPECT_EQ(element.volume, 0);
  const auto& entries = declared<tissue::model::Entries<float>>();
  for (const auto& block : entries.k) EXPECT_EQ(block, Eigen::Matrix3f::Zero());
  for (const double value : entries.history) EXPECT_EQ(value, 0);
  using Batch = batch_t<float, native_lanes<float>>;
  const auto& packs = declared<tissue::model::Frame<Batch>>();
  for (std::size_t l = 0; l < Batch::size; ++l) {
    EXPECT_EQ(packs.weight.get(l), 0.25F);
    EXPECT_EQ(packs.origin[2].get(l), 0);
    EXPECT_EQ(packs.turn(1, 1).get(l), 1);
    EXPECT_EQ(packs.turn(0, 1).get(l), 0);
  }
}

TEST(GoldenRun, single_elements_are_real_references) {
  tissue::model::ShapesArray<float> array(5);
  float* const a = &array.view()[4].a();
  *a = 3;
  std::int32_t* const node = &array.view()[4].nodes()(2);
  *node = 17;
  EXPECT_EQ(array.view().get(4).a, 3);
  EXPECT_EQ(array.view().get(4).nodes(2), 17);
}

}  // namespace
}  // namespace physgen::test
