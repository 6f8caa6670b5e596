// The model of coalescing that physbench reports, held against sectors counted from addresses that are written down
// here.
#include <elasticity.physgen.h>
#include <gtest/gtest.h>

#include <set>

#include "coalescing/trace.h"

namespace physgen::bench {
namespace {

/// Reads F of each object, element by element, and writes x of another array.
template <class FView, class XView>
struct ReadAndWrite {
  FView gradients;
  XView positions;
  void operator()(index_t i) const {
    const Eigen::Matrix3f F = gradients[i].F();
    positions[i].x() = Eigen::Vector3f(F.col(1));
  }
};

/// Requests of 32 lanes, as the address of element k of object i and the bytes there.
struct Expected {
  double requests = 0, sectors = 0, bytes = 0;

  template <class Address>
  void add(int elements, int element_bytes, const Address& address) {
    for (index_t warp = 0; warp < 4; ++warp) {
      for (int k = 0; k < elements; ++k) {
        std::set<index_t> touched;
        for (index_t i = 32 * warp; i < 32 * warp + 32; ++i) {
          for (int b = 0; b < element_bytes; ++b) touched.insert((address(i, k) + b) / 32);
        }
        requests += 1;
        sectors += static_cast<double>(touched.size());
        bytes += 32.0 * element_bytes;
      }
    }
  }
};

template <class FLayout, class XLayout>
Sectors counted() {
  constexpr index_t n = 128;
  Array<elasticity::DeformationGradientObject, float, Host, Traced<FLayout>> gradients(n);
  Array<elasticity::NodePositionObject, float, Host, Traced<XLayout>> positions(n);
  // The sectors of the two arrays are told apart by where they lie; that they begin a sector is what counts.
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(gradients.view().data()) % 32, 0U);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(positions.view().data()) % 32, 0U);
  const ReadAndWrite kernel{gradients.view(), positions.view()};
  return count_sectors(kernel, n);
}

void expect_equal(const Sectors& counted, const Expected& expected) {
  EXPECT_DOUBLE_EQ(counted.per_request, expected.sectors / expected.requests);
  EXPECT_DOUBLE_EQ(counted.bytes_per_sector, expected.bytes / expected.sectors);
}

TEST(Coalescing, of_records_takes_a_sector_per_lane_and_element) {
  Expected expected;
  expected.add(9, 4, [](index_t i, int k) { return 36 * i + 4 * k; });
  expected.add(3, 4, [](index_t i, int k) { return 12 * i + 4 * k; });
  expect_equal(counted<Aos, Aos>(), expected);
}

TEST(Coalescing, of_tiles_and_channels_uses_whole_sectors) {
  Expected expected;
  expected.add(9, 4, [](index_t i, int k) { return i / 32 * 32 * 36 + 4 * k * 32 + 4 * (i % 32); });
  expected.add(3, 4, [](index_t i, int k) { return 4 * k * 128 + 4 * i; });
  expect_equal(counted<Aosoa<32>, Soa>(), expected);
  EXPECT_EQ(expected.sectors / expected.requests, 4);
  EXPECT_EQ(expected.bytes / expected.sectors, 32);
}

TEST(Coalescing, of_padded_vectors_joins_their_elements_to_one_word) {
  Expected expected;
  expected.add(9, 4, [](index_t i, int k) { return 128 * 4 * k + 4 * i; });
  expected.add(1, 16, [](index_t i, int) { return 16 * i; });
  expect_equal(counted<Soa, AosPadded>(), expected);
}

TEST(Coalescing, counts_what_lanes_share_once) {
  SectorCount count;
  std::vector<std::vector<Trace::Access>> same(32), apart(32);
  for (std::uintptr_t lane = 0; lane < 32; ++lane) {
    same[lane] = {{1024, 4}};
    apart[lane] = {{4096 * lane + 28, 8}};  // across the end of a sector
  }
  count.add(same);
  EXPECT_EQ(count.result().per_request, 1);
  EXPECT_EQ(count.result().bytes_per_sector, 4);
  count.add(apart);
  EXPECT_EQ(count.result().per_request, (1 + 64) / 2.0);
  EXPECT_EQ(count.result().bytes_per_sector, (4 + 256) / 65.0);
  EXPECT_EQ(SectorCount().result().per_request, 0);
}

}  // namespace
}  // namespace physgen::bench
