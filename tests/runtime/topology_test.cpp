// Changes of topology in ordinary host memory, and the lists of object numbers that they take.
#include <physgen/threads.h>

#include "renumber_checks.h"

namespace physgen::test {
namespace {

template <class L>
class HostTopology : public ::testing::Test {};
TYPED_TEST_SUITE(HostTopology, AllLayouts, LayoutName);

TYPED_TEST(HostTopology, changes_of_objects_are_those_of_a_vector) {
  check_changes_of_all_object_types<Host, TypeParam>();
}
TYPED_TEST(HostTopology, appends_objects_of_another_precision) { check_append_of_another_precision<Host, TypeParam>(); }
TYPED_TEST(HostTopology, changes_all_arrays_of_a_set_on_any_number_of_threads) {
  for (const int threads : {1, 2, 16}) {
    SCOPED_TRACE(threads);
    set_threads(threads);
    check_set<Host, TypeParam>();
  }
  set_threads(0);
}
TYPED_TEST(HostTopology, renumbered_tets_keep_their_nodes) { check_renumber<Host, TypeParam>(); }
TYPED_TEST(HostTopology, renumbers_one_field_and_leaves_the_others) {
  check_renumber_of_one_field_among_many<Host, TypeParam>();
}
TYPED_TEST(HostTopology, renumbers_behind_quaternions) { check_renumber_behind_quaternions<Host, TypeParam>(); }

// Lists of numbers are looked at, and memory is allocated, before any layout matters.
template <class L>
class HostTopologyErrors : public ::testing::Test {};
using LayoutsOfErrors = ::testing::Types<AosPadded, Aosoa<8>>;
TYPED_TEST_SUITE(HostTopologyErrors, LayoutsOfErrors, LayoutName);

TYPED_TEST(HostTopologyErrors, a_failure_leaves_all_arrays_of_a_set_as_they_were) {
  check_failures_of_a_set_change_nothing<Host, TypeParam>();
}
TYPED_TEST(HostTopologyErrors, memory_that_runs_out_half_way_leaves_all_arrays_of_a_set_as_they_were) {
  check_memory_that_runs_out_half_way<Host, TypeParam>();
}
TYPED_TEST(HostTopologyErrors, refuses_a_wrong_list_by_its_first_wrong_number) {
  check_refused_lists<Host, TypeParam>();
}
TYPED_TEST(HostTopologyErrors, refuses_to_renumber_what_has_no_number_by_its_first_object) {
  check_refused_renumbering<Host, TypeParam>();
}

TEST(ArraySet, refuses_arrays_of_different_sizes_and_names_them) {
  elasticity::TetArray<float> tets(4);
  elasticity::RestShapeArray<float> shapes(5);
  const std::string made = message_of([&] { ArraySet(tets, shapes); });
  EXPECT_NE(made.find("elasticity::Tet[4] in host memory, elasticity::RestShape[5] in host memory"), std::string::npos)
      << made;
  shapes.resize(4);
  ArraySet set(tets, shapes);
  shapes.resize(6);
  EXPECT_NE(message_of([&] { set.append(1); }).find("elasticity::RestShape[6]"), std::string::npos);
  EXPECT_EQ(tets.size(), 4);
}

TEST(ArraySet, changes_an_array_that_is_named_twice_once) {
  std::mt19937 random(seed());
  Random<elasticity::TetArray<float>> tets(100, random);
  const std::vector<index_t> order = random_order(100, random);
  ArraySet(tets.array, tets.array).permute(order);
  expect_sound(tets.array, picked(tets.model, order));
}

TEST(ArraySet, appends_arrays_of_the_set_to_each_other) {
  std::mt19937 random(seed());
  Random<elasticity::TetArray<float, Host, Aosoa<8>>> a(33, random);
  Random<elasticity::TetArray<double, Host, Soa>> b(33, random);
  ArraySet(a.array, b.array).append(b.array, a.array);
  Model ab = a.model;
  ab.insert(ab.end(), b.model.begin(), b.model.end());
  Model ba = b.model;
  ba.insert(ba.end(), a.model.begin(), a.model.end());
  expect_sound(a.array, ab);
  expect_sound(b.array, ba);
}

TEST(ObjectNumbers, inverse_undoes_an_order) {
  std::mt19937 random(seed());
  for (const index_t n : {0, 1, 1000}) {
    const std::vector<index_t> order = random_order(n, random);
    const std::vector<index_t> number = inverse(order);
    for (index_t i = 0; i < n; ++i) {
      ASSERT_EQ(number[static_cast<std::size_t>(order[static_cast<std::size_t>(i)])], i);
    }
    EXPECT_EQ(inverse(number), order);
  }
}

TEST(ObjectNumbers, remaining_and_new_numbers_agree_on_what_is_left) {
  const std::vector<index_t> kept = remaining(6, std::vector<index_t>{4, 0, 3});
  EXPECT_EQ(kept, (std::vector<index_t>{1, 2, 5}));
  EXPECT_EQ(new_numbers(kept, 6), (std::vector<index_t>{-1, 0, 1, -1, -1, 2}));
}

TEST(ObjectNumbers, refuse_what_names_no_object_or_one_twice) {
  using List = std::vector<index_t>;
  EXPECT_NE(message_of([] { (void)inverse(List{0, 2, 3}); }).find("number 3 at position 2"), std::string::npos);
  EXPECT_NE(message_of([] { (void)inverse(List{0, 2, 2}); }).find("it stands at position 1 already"),
            std::string::npos);
  EXPECT_NE(message_of([] { (void)new_numbers(List{0}, 0); }).find("there are none"), std::string::npos);
  EXPECT_NE(message_of([] { (void)remaining(-1, {}); }).find("there cannot be -1 objects"), std::string::npos);
}

}  // namespace
}  // namespace physgen::test
