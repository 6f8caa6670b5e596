// Copies of ranges between host arrays and every layout of one space: one source for host and CUDA memory.
#pragma once

#include <physgen/mirror.h>

#include "topology_checks.h"

namespace physgen::test {

/// Expects the bytes of the objects of a range in the form of one of two arrays, with or without what lies between
/// them: padding of records and the rest of the last tile.
template <class A, class B>
void expect_bytes(index_t bytes, const A& a, const B& b, index_t begin, index_t end) {
  if (begin == end) {
    EXPECT_EQ(bytes, 0);
    return;
  }
  const auto object_bytes = [](const UntypedArray& untyped) {
    index_t elements = 0;
    for (const FieldInfo& field : untyped.fields) elements += field.count * element_bytes(field.type);
    return elements;
  };
  const UntypedArray x = a.untyped(), y = b.untyped();
  const index_t tiles = align_up(end, index_t{64}) - begin / 64 * 64;
  EXPECT_GE(bytes, (end - begin) * std::min(object_bytes(x), object_bytes(y)));
  const bool all = begin == 0 && end == x.size;
  EXPECT_LE(bytes, all ? std::max(x.bytes(), y.bytes()) : tiles * std::max(x.record_bytes, y.record_bytes));
}

/// Copies random ranges both ways; objects of the range arrive, all others stay.
template <class Object, class HostArray, class DeviceArray>
void check_ranges_between(index_t n, std::mt19937& random) {
  Random<HostArray> host(n, random);
  Random<DeviceArray> device(n, random);
  std::uniform_int_distribution<index_t> any(0, n);
  std::vector<std::pair<index_t, index_t>> ranges = {{0, n}, {0, n / 2}, {n / 2, n}, {n / 3, n / 3}, {0, n / 64 * 64}};
  for (int r = 0; r < 4; ++r) ranges.push_back(std::minmax({any(random), any(random)}));
  bool to_device = true;
  for (const auto& [begin, end] : ranges) {
    const auto copy_part = [begin = begin, end = end](const Model& from, Model& to) {
      std::copy(from.begin() + begin, from.begin() + end, to.begin() + begin);
    };
    if (to_device) {
      randomise_objects(host.array, random);
      host.model = objects_of(host.array);
      const index_t bytes = copy_range(device.array.untyped(), host.array.untyped(), begin, end);
      copy_part(host.model, device.model);
      expect_bytes(bytes, host.array, device.array, begin, end);
    } else {
      randomise_objects(device.array, random);
      device.model = objects_of(device.array);
      const index_t bytes = copy_range(host.array.untyped(), device.array.untyped(), begin, end);
      copy_part(device.model, host.model);
      expect_bytes(bytes, host.array, device.array, begin, end);
    }
    synchronize();
    expect_sound(host.array, host.model);
    expect_sound(device.array, device.model);
    to_device = !to_device;
  }
}

template <class Space, class Layout>
void check_ranges() {
  std::mt19937 random(seed());
  for (const index_t n : {0, 1, 31, 32, 33, 1000, 5000}) {
    // The same bytes on both sides, then other layouts, then another precision (the values are floats).
    using Tet = elasticity::TetObject;
    check_ranges_between<Tet, Array<Tet, float, Host, Layout>, Array<Tet, float, Space, Layout>>(n, random);
    check_ranges_between<Tet, Array<Tet, float, Host, Aos>, Array<Tet, float, Space, Layout>>(n, random);
    check_ranges_between<Tet, Array<Tet, float, Host, Soa>, Array<Tet, float, Space, Layout>>(n, random);
    using Shape = elasticity::RestShapeObject;
    check_ranges_between<Shape, Array<Shape, double, Host, Aosoa<8>>, Array<Shape, float, Space, Layout>>(n, random);
  }
  for (const index_t n : {33, 500}) {
    using Mixed = tissue::model::ShapesObject;
    check_ranges_between<Mixed, Array<Mixed, float, Host, Layout>, Array<Mixed, float, Space, Layout>>(n, random);
    check_ranges_between<Mixed, Array<Mixed, double, Host, Soa>, Array<Mixed, float, Space, Layout>>(n, random);
    using Derivative = elasticity::StressDerivativeObject;  // of 2, 4 and 8 bytes
    check_ranges_between<Derivative, Array<Derivative, float, Host, Layout, MixedDerivative>,
                         Array<Derivative, float, Space, Layout, MixedDerivative>>(n, random);
    using Nested = tissue::other::PatchObject;
    check_ranges_between<Nested, Array<Nested, float, Host, Aosoa<32>>, Array<Nested, float, Space, Layout>>(n, random);
  }
}

/// Between arrays of different sizes, as Soa pitches then differ.
template <class Space, class Layout>
void check_ranges_of_different_sizes() {
  std::mt19937 random(seed());
  Random<elasticity::TetArray<float, Host, Layout>> host(700, random);
  Random<elasticity::TetArray<float, Space, Layout>> device(1300, random);
  copy_range(device.array.untyped(), host.array.untyped(), 100, 700);
  synchronize();
  std::copy(host.model.begin() + 100, host.model.end(), device.model.begin() + 100);
  expect_sound(device.array, device.model);
  const auto storages = std::pair(device.array.untyped(), host.array.untyped());
  for (const auto& [begin, end] : {std::pair(-1, 3), std::pair(5, 4), std::pair(0, 701)}) {
    EXPECT_THROW(copy_range(storages.first, storages.second, begin, end), Error) << begin << " to " << end;
  }
  expect_sound(device.array, device.model);
}

}  // namespace physgen::test
