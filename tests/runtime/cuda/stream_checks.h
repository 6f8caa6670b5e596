// Numbered objects in every space, for tests of what is ordered in streams.
#pragma once

#include <physgen/arrays/array.h>

#include "gpu_fixture.h"
#include "test_objects.h"

namespace physgen::test {

/// Objects of each array.
inline constexpr index_t stream_objects = 100000;

template <class Space, class Layout = Aos, class Real = float>
using Positions = Array<elasticity::NodePositionObject, Real, Space, Layout>;

struct HalfPositions : elasticity::NodePositionFormats<Host> {
  using x = format::Half<>;
};
template <class Space>
using Halves = Array<elasticity::NodePositionObject, float, Space, Soa, HalfPositions>;

/// x[0] of object i is first + i % 1000, which a half holds.
template <class Tested>
void number(Tested& array, double first) {
  Positions<Host> numbers(array.size());
  for (index_t i = 0; i < array.size(); ++i) {
    numbers.view()[i].x() = Eigen::Vector3f::Constant(static_cast<float>(first + static_cast<double>(i % 1000)));
  }
  copy(array, numbers);
  synchronize();
}

/// Objects of host memory that are not numbered so, as a host view finds them now.
template <class Tested>
index_t wrong(const Tested& array, double first, index_t begin = 0, index_t end = stream_objects) {
  index_t count = 0;
  const auto view = array.const_view();
  for (index_t i = begin; i < end; ++i) {
    const auto x = view[i].x().get();
    count += static_cast<double>(x[2]) != first + static_cast<double>((i - begin) % 1000);
  }
  return count;
}

/// The same of any array, once the stream is done.
template <class Tested>
index_t wrong_later(const Tested& array, double first, Stream stream) {
  synchronize(stream);
  Positions<Host> objects(array.size());
  copy(objects, array);
  synchronize();
  return wrong(objects, first, 0, array.size());
}

}  // namespace physgen::test
