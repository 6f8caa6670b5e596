// How many objects a kernel is called with at once: the choice that its type makes, and lanes<W>(kernel).
#include <elasticity.physgen.h>
#include <gtest/gtest.h>
#include <physgen/executor.h>
#include <physgen/fuse.h>
#include <physgen/kernel.h>
#include <physgen/row_arrays.h>
#include <quasistatic.physgen.h>

#include <cstring>
#include <random>
#include <vector>

namespace physgen::test {
namespace {

using namespace elasticity;

// ---- The choice ----

/// A kernel that is made over views and rows.
template <class... Part>
struct MadeOver {
  using Scalar = float;
  template <class I>
  void operator()(I /*i*/) const {}
};
struct MadeOverNothing {
  using Scalar = double;
  Rows<IncidenceRangeArray<float>::ConstView, IncidenceArray<float>::ConstView> rows;
  template <class I>
  void operator()(I /*i*/) const {}
};
template <class View>
struct OfSingleObjects {
  using Scalar = float;
  void operator()(index_t /*i*/) const {}
};

constexpr int packs = detail::pack_lanes<float>();
template <class... Part>
constexpr int chosen = detail::lanes_of_calls<MadeOver<Part...>>();

using Tiles = StressArray<float>::View;
using Points = NodePositionArray<float>::View;
using ConstPoints = NodePositionArray<float>::ConstView;
using Forces = NodeForceArray<float>::View;
using SoaPoints = NodePositionArray<float, Host, Soa>::ConstView;
using Ranges = IncidenceRangeArray<float>::ConstView;
using Neighbours = Rows<Ranges, quasistatic::NodeConstraintArray<float>::ConstView>;  // entries of one number
using Incidences = Rows<Ranges, IncidenceArray<float>::ConstView>;                    // of a number and another one

// Streams and gathers with views in tiles, or in arrays of their own, are packs.
static_assert(chosen<Tiles> == packs && chosen<SoaPoints> == packs);
// Views of arrays of structs alone are single objects.
static_assert(chosen<Points> == 1 && chosen<ConstPoints, Forces, float> == 1);
static_assert(chosen<TetArray<float>::ConstView, ConstPoints, Tiles> == packs);
// Neighbours in one set are packs, whatever is const.
static_assert(chosen<Neighbours, Points> == packs && chosen<Neighbours, ConstPoints, Points, float> == packs);
// Rows that lead to other sets, or whose entries hold more, are single objects; so are rows that are given as views.
static_assert(chosen<Neighbours, Tiles, Points> == 1 && chosen<Neighbours, ConstPoints, Forces> == 1);
static_assert(chosen<Incidences, Points> == 1 && chosen<const Incidences, const Points> == 1 &&
              chosen<Ranges, Tiles, Forces> == 1);
// What is not known is packs: kernels without parts, lambdas, members that are no arguments.
static_assert(chosen<> == packs && detail::lanes_of_calls<decltype(over<float>([](auto) {}))>() == packs);
static_assert(detail::lanes_of_calls<MadeOverNothing>() == detail::pack_lanes<double>());
// A fused kernel is packs, unless none of its steps is. Locals tell what the arrays tell that they are in the place of.
template <class Layout>
using LocalPoints = Local<NodePositionObject, float, FormatsOfSpace, NodePositionObject, Layout>;
static_assert(chosen<LocalPoints<Aos>, ConstPoints> == 1 && chosen<LocalPoints<Soa>, ConstPoints> == packs);
static_assert(detail::lanes_of_calls<Fused<Locals<>, MadeOver<Incidences, Points>>>() == 1);
static_assert(detail::lanes_of_calls<Fused<Locals<>, MadeOver<Points>, Fused<Locals<>, MadeOver<Forces>>>>() == 1);
static_assert(detail::lanes_of_calls<Fused<Locals<>, MadeOver<Points>, MadeOver<Tiles>>>() == packs);
static_assert(detail::lanes_of_calls<Fused<Locals<>, MadeOver<Points>, Fused<Locals<>, MadeOver<Tiles>>>>() == packs);
// A kernel that takes no packs is called with single objects.
static_assert(detail::lanes_of_calls<OfSingleObjects<Tiles>>() == 1);
// What is stated wins, the outermost first; 0 states nothing.
static_assert(detail::lanes_of_calls<InLanes<1, MadeOver<Tiles>>>() == 1);
static_assert(detail::lanes_of_calls<InLanes<packs, MadeOver<Incidences>>>() == packs);
static_assert(detail::lanes_of_calls<InLanes<1, InLanes<packs, MadeOver<Tiles>>>>() == 1);
static_assert(detail::lanes_of_calls<InLanes<0, MadeOver<Tiles>>>() == packs);
static_assert(detail::lanes_of_calls<InLanes<0, InLanes<1, MadeOver<Tiles>>>>() == 1);

// ---- The word, in the whole vocabulary ----

/// Tells how many objects it is called with.
struct Width {
  using Scalar = float;
  template <class I>
  lanes_t<float, I> operator()(const I& i) const {
    return lanes_t<float, I>(static_cast<float>(index_width(i)));
  }
};
struct IsWide {
  using Scalar = float;
  float least;
  template <class I>
  auto operator()(const I& i) const {
    return Width()(i) >= lanes_t<float, I>(least);
  }
};

template <int W>
void expect_width() {
  constexpr index_t n = 37;
  const auto width = lanes<W>(Width());
  const auto wide = lanes<W>(IsWide{float(W)}), wider = lanes<W>(IsWide{float(W) + 1});
  EXPECT_EQ(sum(Host{}, n, width), double(n) * W);
  EXPECT_EQ(parallel_reduce(Host{}, 3, n, width, Sum{}), double(n - 3) * W);
  EXPECT_EQ(max(Host{}, n, width), float(W));
  EXPECT_EQ(min(Host{}, n, width), float(W));
  EXPECT_EQ(argmax(Host{}, 3, n, width).value, float(W));
  EXPECT_TRUE(all(Host{}, n, wide));
  EXPECT_FALSE(any(Host{}, n, wider));
  EXPECT_EQ(count(Host{}, n, wide), n);
  HostExecutor on;
  on.reduce(n, width, Max{}, [](float largest) { EXPECT_EQ(largest, float(W)); });
  std::vector<int> widths(n + 32, 0);
  const auto note = [&](const auto& i) {
    const auto& bare = detail::bare(i);
    const LaneRange range = lane_range(i);
    for (int l = range.first; l < range.last; ++l) {
      if constexpr (W == 1) {
        widths[static_cast<std::size_t>(bare)] = W;
      } else {
        widths[static_cast<std::size_t>(bare.begin + l)] = index_width(i);
      }
    }
  };
  on.run(n, lanes<W>(note));
  EXPECT_EQ(std::count(widths.begin(), widths.end(), W), n);
  widths.assign(widths.size(), 0);
  parallel_for(Host{}, 5, n, lanes<W>(note));
  EXPECT_EQ(std::count(widths.begin(), widths.end(), W), n - 5);
  widths.assign(widths.size(), 0);
  parallel_for(Host{}, n, lanes<W>(fuse(locals(), over<float>(note))));
  EXPECT_EQ(std::count(widths.begin(), widths.end(), W), n);
}
TEST(Lanes, are_those_that_the_kernel_states_in_every_word) {
  expect_width<1>();
  expect_width<4>();
  expect_width<packs>();
}

// ---- Bits ----

template <class RowsView, class View>
struct SumNeighbours {
  using Scalar = typename View::Precision;
  RowsView rows;
  View points;

  template <class I>
  auto operator()(const I& i) const {
    using S = lanes_t<Scalar, I>;
    using Vector = Eigen::Matrix<S, 3, 1>;
    const Vector x = points[i].x();
    const Vector total = rows.sum(i, x, [&](const auto& entry) -> Vector {
      const lanes_t<std::int32_t, I> j = entry.element();
      return points[j].x().get() * S(Scalar(0.3)) - x;
    });
    points[i].x() += total;
    return S(total[0] * total[1] - total[2]);
  }
};

/// The sum of the terms and all bits of the points, by a launch of n objects.
template <class Real, class Layout, int W>
std::pair<double, std::vector<std::byte>> results() {
  std::mt19937 random(7);
  constexpr index_t n = 1003;
  NodePositionArray<Real, Host, Layout> points(n);
  std::uniform_real_distribution<Real> value(-1, 1);
  std::vector<std::vector<Incidence<Real>>> lists(n);
  for (index_t i = 0; i < n; ++i) {
    points.view()[i].x() = Eigen::Matrix<Real, 3, 1>(value(random), value(random), value(random));
    for (auto k = random() % 9; k > 0; --k) lists[static_cast<std::size_t>(i)].push_back({std::int32_t(i), 0});
  }
  const auto rows = RowArrays<IncidenceRangeArray<Real>, IncidenceArray<Real>>::from_lists({"element", n}, lists);
  const double total = sum(
      Host{}, n, lanes<W>(SumNeighbours<decltype(rows.view()), decltype(points.view())>{rows.view(), points.view()}));
  std::vector<std::byte> bits;
  for (index_t i = 0; i < n; ++i) {
    const auto x = points.const_view().get(i).x;
    const auto* begin = reinterpret_cast<const std::byte*>(x.data());
    bits.insert(bits.end(), begin, begin + 3 * sizeof(Real));
  }
  return {total, bits};
}
template <class Real, class Layout>
void expect_same_bits() {
  const auto wanted = results<Real, Layout, 0>();
  EXPECT_EQ((results<Real, Layout, 1>()), wanted) << Layout::name;
  EXPECT_EQ((results<Real, Layout, detail::pack_lanes<Real>()>()), wanted) << Layout::name;
}
TEST(Lanes, change_no_bits) {
  expect_same_bits<float, Aos>();
  expect_same_bits<float, AosPadded>();
  expect_same_bits<float, Aosoa<16>>();
  expect_same_bits<double, Aos>();
  expect_same_bits<double, AosPadded>();
  expect_same_bits<double, Soa>();
}

}  // namespace
}  // namespace physgen::test
