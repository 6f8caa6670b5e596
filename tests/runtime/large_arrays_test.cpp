// Arrays of more objects than 32 bits count, of more bytes than there are, and arrays that many threads read.
#include <physgen/simd/simd_access.h>

#include <array>
#include <fstream>
#include <thread>

#include "stored_records.h"

namespace physgen::test {
namespace {

/// 2 bytes in a record of 256.
struct AlignedObject : HalvesObject<1> {
  template <class Real, class Formats>
  struct Record {
    static constexpr int bytes = 2;
    static constexpr int alignment = 256;
  };
};

using Shapes = tissue::model::ShapesObject;

/// Bytes that this process can have: of the machine, and of its control group where that has a limit.
index_t free_memory() {
  index_t free = 0;
  std::ifstream machine("/proc/meminfo");
  for (std::string name, unit; machine >> name;) {
    if (name == "MemAvailable:" && machine >> free) break;
  }
  free *= 1024;
  index_t limit = 0, used = 0;
  if (std::ifstream("/sys/fs/cgroup/memory.max") >> limit && std::ifstream("/sys/fs/cgroup/memory.current") >> used) {
    free = std::min(free, limit - used);
  }
  return free;
}

TEST(Arrays, of_more_than_two_to_the_31_objects_are_ordinary) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "left out: a sanitizer makes minutes of it";
#endif
  using Two = HalvesObject<1>;
  constexpr index_t n = (index_t{1} << 31) + 100;
  constexpr index_t needed = 2 * 2 * n + (index_t{1} << 30);  // both arrays, and something to spare
  const index_t free = free_memory();
  if (free < needed) GTEST_SKIP() << "left out: " << free << " bytes of memory are free, and it takes " << needed;
  Array<Two, float, Host, Soa> channels(n);
  for (const index_t i : {index_t{0}, index_t{1} << 31, n - 1}) channels.putdata(i, 0, static_cast<double>(i % 1021));
  Array<Two, float, Host, Aosoa<64>> tiles(n);
  copy(tiles, channels);
  for (const index_t i : {index_t{0}, index_t{1} << 31, n - 1}) {
    EXPECT_EQ(tiles.getdata(i, 0), static_cast<double>(i % 1021)) << i;
  }
  EXPECT_EQ(tiles.getdata((index_t{1} << 31) - 1, 0), 0) << "the initial value";

  // In packs, too: the whole one at 2^31, and the last of the array.
  constexpr int W = native_lanes<float>;
  const auto lanes_of = [](const auto& array, const auto& pack) {
    const auto view = array.const_view();
    using At = typename std::remove_cvref_t<decltype(view)>::template CursorAt<std::remove_cvref_t<decltype(pack)>>;
    using Pitch = typename std::remove_cvref_t<decltype(view)>::Layout::Pitch;
    const At cursor(view.data(), Pitch(view.pitch()), pack, nullptr);
    std::array<float, W> lanes;
    const batch_t<float, W> batch = cursor.template element<format::Half<>, float>(0);
    batch.store_unaligned(lanes.data());
    return lanes;
  };
  const index_t at = (n - 1) / W * W;
  const auto expect_lanes = [&](const auto& array) {
    EXPECT_EQ(lanes_of(array, Pack<W>{index_t{1} << 31})[0], static_cast<float>((index_t{1} << 31) % 1021));
    const auto last = lanes_of(array, PartialPack<W>{at, 0, static_cast<int>(n - at)});
    EXPECT_EQ(last[static_cast<std::size_t>(n - 1 - at)], static_cast<float>((n - 1) % 1021));
  };
  expect_lanes(channels);
  expect_lanes(tiles);
}

TEST(Arrays, whose_padded_records_no_memory_can_count_are_refused) {
  using Aligned = Array<AlignedObject, float, Host, Aos>;
  static_assert(Aligned::record_bytes == 256);
  const std::string message = message_of([] { const Aligned array(50'000'000'000'000'000); });
  EXPECT_NE(message.find("an array of 50000000000000000 objects of 256 bytes cannot exist"), std::string::npos)
      << message;
  const std::string possible = message_of([] { const Aligned array(9'000'000'000'000'000); });
  EXPECT_NE(possible.find("cannot allocate 2304000000000000"), std::string::npos) << possible;
}

TEST(Arrays, are_copied_by_eight_threads_at_once) {
  std::mt19937 random(seed());
  const index_t n = 5000;
  const auto objects = random_objects<Shapes>(n, random);
  Array<Shapes, float, Host, Soa> source(n);
  copy(source, objects);
  Array<Shapes, float, Host, Aosoa<64>> expected(n);
  copy(expected, source);
  const Records model = records_of(expected.untyped());
  std::array<index_t, 8> wrong{};
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < wrong.size(); ++t) {
    threads.emplace_back([&, t] {
      for (int repeat = 0; repeat < 5; ++repeat) {
        Array<Shapes, float, Host, Aosoa<64>> own(n);
        copy(own, source);
        wrong[t] += count_wrong(own.untyped(), model);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const index_t count : wrong) EXPECT_EQ(count, 0);
}

}  // namespace
}  // namespace physgen::test
