// Arrays that grow and shrink within their memory, and loops of the host over them.
#include <everything.physgen.h>

#include <algorithm>
#include <iterator>

#include "array_model.h"

namespace physgen::test {
namespace {

template <class L>
class GrowthIn : public ::testing::Test {};
TYPED_TEST_SUITE(GrowthIn, AllLayouts, LayoutName);

struct Compact : elasticity::DeformationSvdFormats<Host> {
  using U = format::Quaternion<format::Half<>>;
  using s = format::Bfloat16;
};

/// The objects behind the last one to which packs of the last one reach.
template <class Array>
Model padding_of(const Array& array) {
  UntypedArray all = array.untyped();
  all.size = Array::Layout::padded(array.size());
  Model objects = elements_of(all);
  objects.erase(objects.begin(), objects.begin() + array.size());
  return objects;
}

/// The number of the first object that differs, -1 where there is none, or -2 where they are not as many.
index_t first_difference(const Model& a, const Model& b) {
  if (a.size() != b.size()) return -2;
  const auto [in_a, in_b] = std::mismatch(a.begin(), a.end(), b.begin());
  return in_a == a.end() ? -1 : in_a - a.begin();
}

/// Random growth and shrinking, held against a model.
template <class Array>
void check_growth(unsigned stream) {
  std::mt19937 random(seed() + stream);
  const auto below = [&random](index_t limit) { return static_cast<index_t>(random() % static_cast<unsigned>(limit)); };
  const Model fresh = elements_of(Array(1).untyped());
  Random<Array> source(97, random);
  Array stored(97);  // a quaternion that was read and stored again may differ in its last bits, and again the next time
  for (index_t i = 0; i < 97; ++i) stored.view().put(i, source.array.view().get(i));
  source.model = objects_of(stored);
  Array array;
  Model model;
  for (int step = 0; step < 400; ++step) {
    const std::byte* before = array.untyped().base;
    const index_t room = array.capacity();
    switch (below(6)) {
      case 0: {
        const index_t size = below(200);
        array.resize(size);
        model.resize(static_cast<std::size_t>(size), fresh[0]);
        if (size <= room) {
          ASSERT_EQ(array.untyped().base, before);
        } else {
          ASSERT_EQ(array.capacity(), size);
        }
        break;
      }
      case 1:
        array.reserve(below(300));
        break;
      case 2:
        if (below(4) == 0) {
          array.shrink_to_fit();
          ASSERT_EQ(array.capacity(), array.size());
        }
        break;
      case 3: {  // as kernels do, whose last pack has lanes behind the last object
        UntypedArray all = array.untyped();
        all.size = Array::Layout::padded(array.size());
        for (index_t i = array.size(); i < all.size; ++i) {
          for (int k = 0; k < Array::elements; ++k) {
            if constexpr (std::is_same_v<typename Array::Formats, Compact>) {
              if (k < 9) continue;  // elements of a quaternion are not stored one by one
            }
            putdata(all, i, k, 77);
          }
        }
        break;
      }
      default:
        for (index_t k = below(70); k > 0; --k) {
          const index_t i = below(97);
          array.push_back(source.array.view().get(i));
          model.push_back(source.model[static_cast<std::size_t>(i)]);
        }
    }
    ASSERT_EQ(array.size(), static_cast<index_t>(model.size()));
    ASSERT_GE(array.capacity(), array.size());
    ASSERT_GE(array.bytes(), Array::Layout::padded(array.capacity()) * Array::record_bytes);
    ASSERT_EQ(first_difference(objects_of(array), model), -1) << "step " << step;
    const index_t old = array.size();
    array.resize(old + 40);  // whatever was there before, new objects and those behind them have initial values
    model.resize(static_cast<std::size_t>(old) + 40, fresh[0]);
    ASSERT_EQ(first_difference(objects_of(array), model), -1) << "step " << step;
    for (const auto& object : padding_of(array)) ASSERT_EQ(object, fresh[0]) << "step " << step;
    array.resize(old);
    model.resize(static_cast<std::size_t>(old));
    for (const auto& object : padding_of(array)) ASSERT_EQ(object, fresh[0]) << "step " << step;
    const Array copied = array;
    ASSERT_EQ(first_difference(objects_of(copied), model), -1);
    ASSERT_EQ(copied.capacity(), copied.size());
  }
}

TYPED_TEST(GrowthIn, keeps_objects_and_begins_new_ones_with_initial_values) {
  check_growth<elasticity::NodePositionArray<float, Host, TypeParam>>(1);
  check_growth<elasticity::IncidenceArray<float, Host, TypeParam>>(2);
  check_growth<elasticity::DeformationSvdArray<double, Host, TypeParam, Compact>>(3);
}

TYPED_TEST(GrowthIn, moves_few_objects_while_it_grows_one_by_one) {
  elasticity::NodePositionArray<float, Host, TypeParam> array;
  int moves = 0;
  const std::byte* base = nullptr;
  elasticity::NodePosition<float> value;
  for (int k = 0; k < 100000; ++k) {
    value.x = Eigen::Vector3f::Constant(static_cast<float>(k));
    array.push_back(value);
    moves += array.untyped().base != base ? 1 : 0;
    base = array.untyped().base;
  }
  EXPECT_LE(moves, 24);
  for (index_t i = 0; i < array.size(); ++i) ASSERT_EQ(array[i].x()[2], static_cast<float>(i));
}

TYPED_TEST(GrowthIn, is_copied_to_and_from_arrays_of_another_capacity) {
  std::mt19937 random(seed());
  using Array = elasticity::DeformationSvdArray<float, Host, TypeParam>;
  const Random<Array> source(77, random);
  Array roomy;
  roomy.reserve(1000);
  roomy.resize(77);
  copy(roomy, source.array);
  EXPECT_EQ(objects_of(roomy), source.model);
  Array exact(77);
  copy(exact, roomy);
  EXPECT_EQ(objects_of(exact), source.model);
  Array taken = std::move(roomy);
  EXPECT_EQ(taken.capacity(), 1000);
  EXPECT_EQ(objects_of(taken), source.model);
  EXPECT_EQ(roomy.capacity(), 0);  // NOLINT: what a move leaves is empty
  EXPECT_EQ(roomy.size(), 0);
}

TYPED_TEST(GrowthIn, gives_references_to_its_objects) {
  elasticity::NodePositionArray<float, Host, TypeParam> array(50);
  for (auto node : array) node.x() = Eigen::Vector3f(1, 2, 3);
  array[7].x()[1] = 9;
  array[8] = array[7];
  const auto& constant = array;
  float sum = 0;
  for (const auto& node : constant) sum += node.x()[1];
  EXPECT_EQ(sum, 2 * 48 + 9 + 9);
  EXPECT_EQ(constant[8].x()[1], 9);
  static_assert(!std::is_assignable_v<decltype(constant[8].x()[1]), float>);
  EXPECT_EQ(array.end() - array.begin(), 50);
  const auto nine = std::find_if(constant.begin(), constant.end(), [](const auto& node) { return node.x()[1] == 9; });
  static_assert(!std::sortable<decltype(array.begin())>, "it would move references for objects");
  EXPECT_EQ(nine.index(), 7);
  EXPECT_EQ((array.begin() + 7)[1].x()[1], 9);
  EXPECT_EQ((*--array.end()).x()[0], 1);
  EXPECT_TRUE((elasticity::NodePositionArray<float, Host, TypeParam>().begin() ==
               elasticity::NodePositionArray<float, Host, TypeParam>().end()));
}

TEST(Growth, refuses_what_cannot_be_and_stays_as_it_is) {
  elasticity::NodePositionArray<float> array(5);
  array[4].x()[0] = 3;
  const std::string message = message_of([&] { array.resize(-1); });
  EXPECT_NE(message.find("NodePosition: an array of -1 objects of 16 bytes cannot exist; give a size from 0 to "),
            std::string::npos)
      << message;
  EXPECT_NE(message_of([&] { array.reserve(index_t{1} << 61); }).find("cannot exist"), std::string::npos);
  EXPECT_NE(message_of([&] { array.reserve(index_t{1} << 45); }), "nothing was thrown");
  EXPECT_EQ(array.size(), 5);
  EXPECT_EQ(array.capacity(), 5);
  EXPECT_EQ(array[4].x()[0], 3);
}

}  // namespace
}  // namespace physgen::test
