// Memory of the host below and above the sizes from which on it is taken in other ways.
#include <gtest/gtest.h>
#include <physgen/memory/buffer.h>
#include <physgen/memory/host_list.h>
#include <physgen/threads.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <vector>

namespace physgen {
namespace {

constexpr index_t huge_page = index_t{2} << 20;

std::vector<index_t> sizes() {
  std::vector<index_t> sizes{1, 255, 256, 257, 4095, 4097};
  for (const index_t pages : {1, 2, 4, 9}) {
    for (const index_t more : {-4097, -257, -1, 0, 1, 257, 4097}) sizes.push_back(pages * huge_page + more);
  }
  return sizes;
}

/// What the process has mapped [bytes].
index_t mapped() {
  index_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<index_t>(sysconf(_SC_PAGESIZE));
}

TEST(Buffers, are_clear_and_aligned_also_where_others_were_written) {
  for (const int count : {1, 2, 16}) {
    set_threads(count);
    for (int round = 0; round < 2; ++round) {
      for (const index_t size : sizes()) {
        const Buffer first(SpaceKind::host, size, "first"), second(SpaceKind::host, size, "second");
        for (const Buffer* buffer : {&first, &second}) {
          ASSERT_EQ(reinterpret_cast<std::uintptr_t>(buffer->data()) % buffer_alignment, 0U);
          ASSERT_EQ(std::count(buffer->data(), buffer->data() + size, std::byte{0}), size);
        }
        std::memset(first.data(), 0xFF, static_cast<std::size_t>(size));
        ASSERT_EQ(second.data()[0], std::byte{0}) << size;
        ASSERT_EQ(second.data()[size - 1], std::byte{0}) << size;
        std::memset(second.data(), 0xEE, static_cast<std::size_t>(size));
        ASSERT_EQ(first.data()[0], std::byte{0xFF}) << size;
        ASSERT_EQ(first.data()[size - 1], std::byte{0xFF}) << size;
      }
    }
  }
  set_threads(0);
}

TEST(Buffers, give_all_of_their_memory_back) {
  const auto take_each = [] {
    for (const index_t size : sizes()) const Buffer buffer(SpaceKind::host, size, "buffer");
  };
  for (int round = 0; round < 5; ++round) take_each();
  const index_t before = mapped(), all = 50 * 128 * huge_page;
  for (int round = 0; round < 50; ++round) take_each();
  EXPECT_LE(mapped(), before + all / 100);  // small ones are kept for the next
}

TEST(Lists, of_any_size_hold_what_is_written) {
  for (const index_t size : sizes()) {
    HostList<std::uint8_t> first(static_cast<std::size_t>(size)), second(first.size());
    std::ranges::fill(first, std::uint8_t{0xFF});
    std::ranges::fill(second, std::uint8_t{0xEE});
    ASSERT_EQ(std::ranges::count(first, 0xFF), size);
    first.resize(first.size() + 1);
    first.back() = 0;
    ASSERT_EQ(std::ranges::count(first, 0xFF), size);
    ASSERT_EQ(std::ranges::count(second, 0xEE), size);
  }
}

}  // namespace
}  // namespace physgen
