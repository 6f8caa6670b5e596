// Fields of 64-bit integers and of bool: every bit of them, in every layout, by references, values, copies, text and
// channels; in kernels of one lane; and as single elements, which are doubles.
#include <everything.physgen.h>
#include <physgen/channel.h>
#include <physgen/parallel_for.h>
#include <physgen/print.h>

#include <limits>
#include <sstream>

#include "stored_records.h"

namespace physgen::test {
namespace {

using tissue::model::Marks;
using tissue::model::MarksArray;
using tissue::model::MarksObject;

/// Integers that no double holds.
std::uint64_t odd(std::mt19937_64& random) { return random() | 0x8000000000000001U; }

Marks<float> random_marks(std::mt19937_64& random) {
  const auto number = [&] { return static_cast<std::int64_t>(odd(random)); };
  const auto flag = [&] { return random() % 2 == 1; };
  Marks<float> marks;
  marks.lowest = number();
  marks.key = odd(random);
  marks.alive = flag();
  for (int k = 0; k < 3; ++k) marks.fixed[k] = flag();
  for (int k = 0; k < 4; ++k) marks.counts(k % 2, k / 2) = number();
  for (int c = 0; c < 3; ++c)
    for (int r = c; r < 3; ++r) marks.touches(r, c) = marks.touches(c, r) = flag();
  for (int k = 0; k < 2; ++k) marks.hashes[k] = odd(random);
  for (int c = 0; c < 3; ++c)
    for (int r = c + 1; r < 3; ++r) marks.turns(c, r) = -(marks.turns(r, c) = number());
  for (bool& one : marks.flags) one = flag();
  for (std::int64_t& one : marks.history) one = number();
  marks.weight = static_cast<float>(random() % 1000);
  return marks;
}

void expect_same(const Marks<float>& a, const Marks<float>& b) {
  EXPECT_EQ(a.lowest, b.lowest);
  EXPECT_EQ(a.key, b.key);
  EXPECT_EQ(a.alive, b.alive);
  EXPECT_EQ(a.fixed, b.fixed);
  EXPECT_EQ(a.counts, b.counts);
  EXPECT_EQ(a.touches, b.touches);
  EXPECT_EQ(a.hashes, b.hashes);
  EXPECT_EQ(a.turns, b.turns);
  for (int e = 0; e < 5; ++e) EXPECT_EQ(a.flags[e], b.flags[e]);
  for (int e = 0; e < 2; ++e) EXPECT_EQ(a.history[e], b.history[e]);
  EXPECT_EQ(a.weight, b.weight);
}

template <class Layout>
struct WholeFields : ::testing::Test {};
using Layouts = ::testing::Types<Aos, AosPadded, Soa, Aosoa<2>, Aosoa<4>, Aosoa<8>, Aosoa<64>>;
TYPED_TEST_SUITE(WholeFields, Layouts, LayoutName);

TYPED_TEST(WholeFields, keep_every_bit_in_arrays_and_in_copies_from_and_to_records) {
  constexpr index_t n = 77;
  std::mt19937_64 random(seed());
  std::vector<Marks<float>> given;
  MarksArray<float, Host, TypeParam> array(n);
  MarksArray<float, Host, Aos> records(n);
  for (index_t i = 0; i < n; ++i) {
    given.push_back(random_marks(random));
    array.view().put(i, given.back());
  }
  copy(records, array);
  for (index_t i = 0; i < n; ++i) {
    expect_same(array.view().get(i), given[static_cast<std::size_t>(i)]);
    expect_same(records.view().get(i), given[static_cast<std::size_t>(i)]);
  }
  MarksArray<float, Host, TypeParam> back(n);
  copy(back, records);
  expect_records(back.untyped(), records_of(array.untyped()), "two copies");
}

TYPED_TEST(WholeFields, begin_as_the_schema_says_and_are_written_by_references) {
  MarksArray<float, Host, TypeParam> array(3);
  EXPECT_EQ(array[2].lowest(), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(array[2].key(), 18446744073709549568U);
  EXPECT_TRUE(array[2].alive());
  EXPECT_FALSE(array[2].flags(4));
  static_assert(std::is_same_v<decltype(array[0].alive()), bool&>);
  array[1].alive() = false;
  array[1].flags(3) = true;
  array[1].fixed() = Eigen::Matrix<bool, 3, 1>(true, false, true);
  array[1].history(1) = -5;
  array[1].counts()(1, 0) = 7;
  std::ostringstream out;
  out << array[1];
  EXPECT_EQ(
      out.str(),
      "{lowest = -9223372036854775808, key = 18446744073709549568, alive = false, fixed = {true, false, true}, counts "
      "= {{0, 0}, {7, 0}}, touches = {{false, false, false}, {false, false, false}, {false, false, false}}, hashes = "
      "{0, 0}, turns = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, flags = {false, false, false, true, false}, history = {0, "
      "-5}, weight [kg] = 0}");
}

template <class View>
struct CountAlive {
  View marks;
  void operator()(index_t i) const {
    if (marks[i].alive()) add(i, marks[0].history(0), std::int64_t{1} << 40);
    marks[i].key() += static_cast<std::uint64_t>(i);
  }
};

TEST(WholeFieldsInKernels, are_read_written_and_added_to_one_object_at_a_time) {
  constexpr index_t n = 1000;
  MarksArray<float, Host, Aosoa<16>> array(n);
  for (index_t i = 0; i < n; ++i) array[i].alive() = i % 3 == 0;
  parallel_for(Host{}, n, lanes<1>(CountAlive{array.view()}));
  EXPECT_EQ(array[0].history(0), 334 * (std::int64_t{1} << 40));
  EXPECT_EQ(array[999].key(), 18446744073709549568U + 999);
}

TEST(WholeFieldsAsChannels, are_plain_ranges) {
  MarksArray<float, Host, Soa> array(40);
  const std::span<bool> alive = channel<"alive">(array);
  const std::span<std::uint64_t> hash = channel<"hashes">(array, 1);
  alive[3] = false;
  hash[39] = ~std::uint64_t{0};
  EXPECT_FALSE(array[3].alive());
  EXPECT_EQ(array[39].hashes()[1], ~std::uint64_t{0});
}

TEST(WholeFieldsAsNumbers, are_refused_where_a_double_would_change_them) {
  MarksArray<float> array(2);
  EXPECT_EQ(array.getdata(1, 0), -0x1p63);
  array[1].lowest() = (std::int64_t{1} << 53) + 1;
  EXPECT_NE(message_of([&] {
              (void)array.getdata(1, 0);
            }).find("lowest holds 9007199254740993, which no double is; read it through a view"),
            std::string::npos);
  array[1].key() = ~std::uint64_t{0};
  EXPECT_NE(message_of([&] { (void)array.getdata(1, 1); }).find("key holds 18446744073709551615"), std::string::npos);
  EXPECT_NE(message_of([&] {
              array.putdata(0, 1, -1);
            }).find("-1 does not fit; key holds whole numbers from 0 to 18446744073709551615"),
            std::string::npos);
  EXPECT_NE(message_of([&] { array.putdata(0, 0, 0x1p63); }).find("does not fit; lowest holds"), std::string::npos);
  EXPECT_NE(message_of([&] { array.putdata(0, 2, 2); }).find("2 does not fit; alive holds 0 or 1"), std::string::npos);
  array.putdata(0, 2, 0);
  EXPECT_FALSE(array[0].alive());
  EXPECT_EQ(array.getdata(0, 2), 0);
}

}  // namespace
}  // namespace physgen::test
