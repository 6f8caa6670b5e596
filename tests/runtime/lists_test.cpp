// Scans, sorts and rows made on several threads, against plain loops, on 1, 2 and 16 threads.
#include <gtest/gtest.h>
#include <physgen/device.h>
#include <physgen/error.h>
#include <physgen/fill_rows.h>
#include <physgen/sort.h>

#include <numeric>
#include <random>

namespace {

using namespace physgen;  // NOLINT(google-build-using-namespace)

/// Calls check() with launches on each number of threads.
template <class Check>
void on_threads(const Check& check) {
  for (const int count : {1, 2, 16}) {
    SCOPED_TRACE(count);
    set_threads(count);
    check();
  }
  set_threads(0);
}

TEST(Lists, a_scan_has_the_sums_of_all_numbers_before_each) {
  std::mt19937_64 random(1);
  on_threads([&] {
    for (const std::size_t size : {0UL, 1UL, 2UL, 16383UL, 16384UL, 16385UL, 300000UL}) {
      std::vector<std::int32_t> numbers(size);
      for (auto& number : numbers) number = static_cast<std::int32_t>(random() % 50);
      std::vector<std::int32_t> expected(size);
      std::exclusive_scan(numbers.begin(), numbers.end(), expected.begin(), 0);
      const index_t total = std::accumulate(numbers.begin(), numbers.end(), index_t{0});
      EXPECT_EQ(exclusive_scan(Host{}, std::span(numbers)), total);
      EXPECT_EQ(numbers, expected);
    }
  });
}

TEST(Lists, a_scan_whose_sum_has_no_number_is_refused_and_changes_nothing) {
  std::vector<std::int32_t> numbers{2147483647, 1, 0};
  const std::vector<std::int32_t> before = numbers;
  try {
    exclusive_scan(Host{}, std::span(numbers));
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(
        error.what(),
        "physgen: a list would have 2147483648 entries, and its numbers reach 2147483647: make fewer, or spread them "
        "over several lists");
  }
  EXPECT_EQ(numbers, before);
}

template <class Key>
void expect_sorts(std::mt19937_64& random, std::uint64_t mask) {
  on_threads([&] {
    for (const std::size_t size : {0UL, 1UL, 2UL, 1000UL, 120001UL}) {
      std::vector<Key> keys(size);
      for (Key& key : keys) key = static_cast<Key>(random() & mask);
      std::vector<std::int32_t> values(size);
      std::iota(values.begin(), values.end(), 0);
      std::vector<std::int32_t> order = values;
      std::ranges::stable_sort(order, {}, [&](std::int32_t i) { return keys[static_cast<std::size_t>(i)]; });
      std::vector<Key> expected;
      for (const std::int32_t i : order) expected.push_back(keys[static_cast<std::size_t>(i)]);
      sort_by_key(Host{}, std::span(keys), std::span(values));
      EXPECT_EQ(keys, expected);
      EXPECT_EQ(values, order);
    }
  });
}

TEST(Lists, sorted_keys_ascend_and_equal_ones_keep_their_order) {
  std::mt19937_64 random(2);
  for (const std::uint64_t mask : {0ULL, 0xFFULL, 0xFF00ULL, 0xFFFF0FULL, 0xFFFFFFFFFFFFFFFFULL}) {
    expect_sorts<std::int32_t>(random, mask);
    expect_sorts<std::uint32_t>(random, mask);
    expect_sorts<std::int64_t>(random, mask);
    expect_sorts<std::uint64_t>(random, mask);
  }
  expect_sorts<std::int8_t>(random, 0xFF);
}

TEST(Lists, keys_without_a_value_each_are_refused) {
  std::vector<int> keys(3), values(2);
  EXPECT_THROW(sort_by_key(Host{}, std::span(keys), std::span(values)), Error);
}

TEST(Lists, in_memory_of_a_device_that_there_is_not_are_refused) {
  if (cuda_available()) GTEST_SKIP() << "there is a CUDA device";
  std::vector<int> keys{2, 1}, values{3, 4};
  EXPECT_THROW(exclusive_scan(Cuda{}, std::span(keys)), Error);
  EXPECT_THROW(sort_by_key(Cuda{}, std::span(keys), std::span(values)), Error);
  EXPECT_EQ(keys, (std::vector<int>{2, 1}));
}

struct Entry {
  std::int32_t item, place;
  auto operator<=>(const Entry&) const = default;
};

void expect_rows(index_t rows, const std::vector<std::array<std::int32_t, 3>>& items) {
  std::vector<std::vector<Entry>> expected(static_cast<std::size_t>(rows));
  for (std::size_t i = 0; i < items.size(); ++i) {
    for (std::int32_t k = 0; k < 3; ++k) {
      const std::int32_t row = items[i][static_cast<std::size_t>(k)];
      if (row >= 0) expected[static_cast<std::size_t>(row)].push_back({static_cast<std::int32_t>(i), k});
    }
  }
  on_threads([&] {
    HostList<std::int32_t> first, appended_first;
    HostList<Entry> entries, appended;
    fill_rows(
        Host{}, rows, static_cast<index_t>(items.size()),
        [&](index_t i, const auto& put) {
          for (std::int32_t k = 0; k < 3; ++k) {
            const std::int32_t row = items[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
            if (row >= 0) put(row, Entry{static_cast<std::int32_t>(i), k});
          }
        },
        first, entries);
    append_rows(
        Host{}, rows, [] { return std::vector<Entry>(); },
        [&](index_t r, std::vector<Entry>& scratch, std::vector<Entry>& row) {
          scratch = expected[static_cast<std::size_t>(r)];
          row.insert(row.end(), scratch.begin(), scratch.end());
        },
        appended_first, appended);
    ASSERT_EQ(std::ssize(first), rows + 1);
    EXPECT_EQ(first, appended_first);
    EXPECT_EQ(entries, appended);
    for (std::size_t r = 0; r < expected.size(); ++r) {
      EXPECT_EQ(std::vector<Entry>(entries.begin() + first[r], entries.begin() + first[r + 1]), expected[r]) << r;
    }
    EXPECT_EQ(std::cmp_equal(first.back(), entries.size()), true);
  });
}

TEST(Lists, rows_have_the_entries_of_all_items_ascending) {
  std::mt19937_64 random(3);
  expect_rows(0, {});
  expect_rows(1, {});
  expect_rows(1, {{0, 0, -1}});
  for (const int rows : {1, 7, 20000}) {
    std::vector<std::array<std::int32_t, 3>> items(30000);
    for (auto& item : items) {
      for (auto& row : item) row = static_cast<std::int32_t>(random() % static_cast<unsigned>(rows + 1)) - 1;
    }
    expect_rows(rows, items);
  }
}

TEST(Lists, what_an_appended_row_throws_comes_out) {
  HostList<std::int32_t> first;
  HostList<int> entries;
  const auto refuse = [](index_t r, int& /*scratch*/, std::vector<int>& /*row*/) {
    if (r == 700) throw Error("row 700");
  };
  EXPECT_THROW(append_rows(Host{}, 1000, [] { return 0; }, refuse, first, entries), Error);
}

TEST(Lists, a_list_that_the_memory_cannot_hold_is_refused_with_its_bytes) {
  try {
    const HostList<std::array<char, 16>> list(std::size_t{1} << 50);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("1125899906842624 entries of 16 bytes"), std::string::npos);
  }
}

TEST(Lists, keep_their_values_where_they_grow) {
  HostList<int> list;
  for (int i = 0; i < 100000; ++i) list.push_back(i);
  list.resize(200000);
  for (int i = 0; i < 100000; ++i) ASSERT_EQ(list[static_cast<std::size_t>(i)], i);
  EXPECT_EQ((HostList<int>{1, 2, 3}), (std::vector<int>{1, 2, 3}));
  EXPECT_FALSE((HostList<int>{1, 2, 3}) == (std::vector<int>{1, 2}));
}

}  // namespace
