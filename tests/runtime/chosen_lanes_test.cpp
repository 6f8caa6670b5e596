// How many objects a kernel is called with at once: the choice that its type makes, and lanes<W>(kernel).
#include <elasticity.physgen.h>
#include <gtest/gtest.h>
#include <physgen/executor.h>
#include <physgen/fuse.h>
#include <physgen/kernel.h>
#include <physgen/row_arrays.h>
#include <quasistatic.physgen.h>

#include <Eigen/LU>
#include <cstring>
#include <random>
#include <string>
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

/// Sums over the entries of small vectors and matrices as get() hands them out, and of expressions of these.
template <class Vectors, class Matrices, class Results>
struct SumsOfEntries {
  using Scalar = typename Results::Precision;
  Vectors x, y;
  Matrices matrices;
  Results sums, products, inverses;

  template <class I>
  void operator()(I i) const {
    using namespace math;
    using S = lanes_t<Scalar, I>;
    const auto u = x[i].x().get(), v = y[i].x().get();
    const auto F = matrices[i].F().get();
    Eigen::Matrix<S, 3, 3> all;
    all.col(0) = Eigen::Matrix<S, 3, 1>(F * u);
    all.col(1) << u.dot(v), u.squaredNorm(), u.norm();
    all.col(2) << F.trace(), F.determinant(), F.squaredNorm() + F.sum();
    sums[i].F() = all;
    all = F * F.transpose();
    all.col(1) += F * F * u + (F - F.transpose()) * (F * S(Scalar(2)) + F).transpose() * (u - v);
    all.col(2) << (F * F).trace(), (u - v).dot(F * v), u.transpose() * F * v;
    products[i].F() = all;
    inverses[i].F() = F.inverse();
  }
};

template <class Real>
void expect_order_of_sums() {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<Real> value(-1, 1);
  constexpr index_t n = 256;
  using Vectors = NodePositionArray<Real, Host, Aos>;
  using Matrices = DeformationGradientArray<Real, Host, Aos>;
  Vectors x(n), y(n);
  Matrices F(n);
  for (index_t i = 0; i < n; ++i) {
    for (int k = 0; k < 3; ++k) x.view()[i].x()[k] = value(random);
    for (int k = 0; k < 3; ++k) y.view()[i].x()[k] = value(random);
    for (int k = 0; k < 9; ++k) F.view()[i].F()(k % 3, k / 3) = value(random);
  }
  std::vector<Matrices> one, many;
  const auto run = [&]<int W>(std::vector<Matrices>& results, std::integral_constant<int, W>) {
    for (int k = 0; k < 3; ++k) results.emplace_back(n);
    parallel_for(
        Host{}, n,
        lanes<W>(SumsOfEntries<typename Vectors::ConstView, typename Matrices::ConstView, typename Matrices::View>{
            x.const_view(), y.const_view(), F.const_view(), results[0].view(), results[1].view(), results[2].view()}));
  };
  run(one, std::integral_constant<int, 1>());
  run(many, std::integral_constant<int, detail::pack_lanes<Real>()>());
  for (index_t i = 0; i < n; ++i) {
    for (std::size_t result = 0; result < 3; ++result) {
      for (int k = 0; k < 9; ++k) {
        const Real a = one[result].view()[i].F()(k % 3, k / 3), b = many[result].view()[i].F()(k % 3, k / 3);
        ASSERT_EQ(std::memcmp(&a, &b, sizeof a), 0) << "object " << i << ", result " << result << ", entry " << k;
      }
    }
    const auto u = x.view()[i].x(), v = y.view()[i].x();
    const auto G = F.view()[i].F(), sums = one[0].view()[i].F();
    const auto sum = [](Real a, Real b, Real c) { return a + (b + c); };
    for (int r = 0; r < 3; ++r) ASSERT_EQ(sums(r, 0), sum(G(r, 0) * u[0], G(r, 1) * u[1], G(r, 2) * u[2])) << i;
    ASSERT_EQ(sums(0, 1), sum(u[0] * v[0], u[1] * v[1], u[2] * v[2])) << i;
    ASSERT_EQ(sums(1, 1), sum(u[0] * u[0], u[1] * u[1], u[2] * u[2])) << i;
    ASSERT_EQ(sums(0, 2), sum(G(0, 0), G(1, 1), G(2, 2))) << i;
  }
}
TEST(Lanes, have_one_order_of_sums_over_the_entries_of_what_get_returns) {
  expect_order_of_sums<float>();
  expect_order_of_sums<double>();
}

}  // namespace
}  // namespace physgen::test
