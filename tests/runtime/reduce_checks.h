// Reductions over objects of one space, against the same folds written out in the order that reduce.h states: one
// source for host and CUDA. Included behind parallel_reduce.h or cuda/parallel_reduce.h.
#pragma once

#include <physgen/kernel.h>
#include <physgen/launch/reduce_workspace.h>

#include <cmath>
#include <limits>

#include "test_objects.h"

namespace physgen::test {

/// The value of objects begin .. end-1, whose values are given for each object of the array; without any of the
/// library's code.
template <class V, class Join>
V by_order(const std::vector<V>& values, index_t begin, index_t end, const V& identity, const Join& join) {
  std::vector<V> blocks;
  for (index_t block = begin / 2048; block * 2048 < end && begin < end; ++block) {
    std::vector<V> lanes(32, identity);
    for (index_t i = std::max(begin, block * 2048); i < std::min(end, (block + 1) * 2048); ++i) {
      V& lane = lanes[static_cast<std::size_t>(i % 32)];
      lane = join(lane, values[static_cast<std::size_t>(i)]);
    }
    for (std::size_t step : {16, 8, 4, 2, 1}) {
      for (std::size_t l = 0; l < step; ++l) lanes[l] = join(lanes[l], lanes[l + step]);
    }
    blocks.push_back(lanes[0]);
  }
  if (blocks.empty()) return identity;
  std::vector<V> strands(std::min<std::size_t>(blocks.size(), 1024), identity);
  for (std::size_t b = 0; b < blocks.size(); ++b) strands[b % 1024] = join(strands[b % 1024], blocks[b]);
  for (std::size_t step = 512; step > 0; step /= 2) {
    for (std::size_t s = 0; s < step && s + step < strands.size(); ++s)
      strands[s] = join(strands[s], strands[s + step]);
  }
  return strands[0];
}

/// Equal bits; of NaN any.
template <class T>
void expect_same(const T& got, const T& wanted, const std::string& what) {
  if (wanted != wanted) {
    EXPECT_TRUE(got != got) << what << ": " << got << " instead of NaN";
  } else {
    EXPECT_EQ(std::memcmp(&got, &wanted, sizeof(T)), 0) << what << ": " << got << " instead of " << wanted;
  }
}

/// Vectors on the host and in a space, whose first two elements are multiplied. What lies behind the objects, in the
/// padding that packs could see, is a signalling NaN.
template <class Real, class Space, class Layout>
struct Vectors {
  using Object = elasticity::NodeForceObject;
  Array<Object, Real, Host, Aos> source;
  Array<Object, Real, Space, Layout> array;

  Vectors(index_t n, std::mt19937& random) : source(n), array(n) {
    std::uniform_real_distribution<Real> mantissa(1, 2);
    for (index_t i = 0; i < n; ++i) {
      for (int k = 0; k < 3; ++k) {
        const Real x = std::ldexp(mantissa(random), static_cast<int>(random() % 40) - 20);
        source.view()[i].f()[k] = random() % 2 == 0 ? x : -x;
      }
    }
    update();
  }
  void update() {
    copy(array, source);
    if constexpr (host_accessible(Space::kind)) {
      const auto view = array.view();
      const typename Array<Object, Real, Space, Layout>::View behind(view.data(), Layout::padded(view.size()),
                                                                     view.pitch());
      for (index_t i = view.size(); i < behind.size(); ++i) {
        for (int k = 0; k < 3; ++k) behind[i].f()[k] = std::numeric_limits<Real>::signaling_NaN();
      }
    } else {
      synchronize();
    }
  }
  [[nodiscard]] Real term(index_t i) const { return source.const_view()[i].f()[0] * source.const_view()[i].f()[1]; }
  /// of(term, i) for each object.
  template <class Of>
  auto values(const Of& of) const {
    std::vector<decltype(of(Real(), index_t()))> all;
    for (index_t i = 0; i < source.size(); ++i) all.push_back(of(term(i), i));
    return all;
  }
};

template <class View>
struct Product {
  using Scalar = typename View::Precision;
  View view;
  template <class I>
  PHYSGEN_FUNCTION lanes_t<Scalar, I> operator()(I i) const {
    const lanes_t<Scalar, I> a = view[i].f()[0], b = view[i].f()[1];
    return a * b;
  }
};
template <class View>
struct IsBelow {
  using Scalar = typename View::Precision;
  View view;
  Scalar limit;
  template <class I>
  PHYSGEN_FUNCTION auto operator()(I i) const {
    return Product<View>{view}(i) < lanes_t<Scalar, I>(limit);
  }
};
/// Three sums in one pass, of a kernel that also stores the product.
template <class View>
struct ThreeTerms {
  using Scalar = typename View::Precision;
  View view;
  template <class I>
  PHYSGEN_FUNCTION Eigen::Matrix<lanes_t<Scalar, I>, 3, 1> operator()(I i) const {
    const lanes_t<Scalar, I> product = Product<View>{view}(i), a = view[i].f()[0], b = view[i].f()[1];
    view[i].f()[2] = product;
    return {product, a * a, b};
  }
};
template <class View>
struct TwoTerms {
  using Scalar = typename View::Precision;
  View view;
  template <class I>
  PHYSGEN_FUNCTION std::array<lanes_t<Scalar, I>, 2> operator()(I i) const {
    const lanes_t<Scalar, I> a = view[i].f()[0];
    return {Product<View>{view}(i), a};
  }
};

template <class Space, class Kernel, class Fold>
auto reduce_in(index_t begin, index_t end, const Kernel& kernel, Fold fold) {
  if constexpr (std::is_same_v<Space, Host>) {
    return parallel_reduce(Space{}, begin, end, kernel, fold);
  } else {
    ReduceWorkspace workspace(end - begin, 96);
    return parallel_reduce(Space{}, begin, end, kernel, fold, workspace);
  }
}

inline constexpr auto plus = [](const auto& a, const auto& b) { return a + b; };
inline constexpr auto double_of = [](auto term, index_t) { return static_cast<double>(term); };

/// Whole arrays, and random ranges of them.
inline std::vector<std::pair<index_t, index_t>> ranges_of(index_t n, std::mt19937& random) {
  std::vector<std::pair<index_t, index_t>> ranges{{0, n}, {n, n}};
  std::uniform_int_distribution<index_t> any(0, n);
  for (int r = 0; r < 6; ++r) ranges.push_back(std::minmax({any(random), any(random)}));
  return ranges;
}
inline const std::vector<index_t> reduced_sizes{0, 1, 2, 31, 32, 33, 70, 1003, 2047, 2048, 2049, 4100, 100003};

template <class Space, class Real, class Layout>
void check_sums() {
  std::mt19937 random(seed());
  for (const index_t n : reduced_sizes) {
    Vectors<Real, Space, Layout> vectors(n, random);
    const auto view = vectors.array.view();
    const auto values = vectors.values(double_of);
    for (const auto& [begin, end] : ranges_of(n, random)) {
      const double wanted = by_order(values, begin, end, 0.0, plus);
      const std::string what = "sum of " + std::to_string(begin) + " to " + std::to_string(end);
      expect_same(reduce_in<Space>(begin, end, Product<decltype(view)>{view}, Sum{}), wanted, what);
    }
  }
}

/// A term that comes from the object's number alone.
struct Scattered {
  using Scalar = float;
  template <class I>
  PHYSGEN_FUNCTION lanes_t<float, I> operator()(I i) const {
    using S = lanes_t<float, I>;
    return math::to_real<S>(numbers(i) % 8191) * S(0.37F);
  }
};

/// Reductions of more blocks than there are strands.
template <class Space>
void check_a_sum_of_many_blocks() {
  const index_t n = 2048 * 2100 + 5;
  std::vector<double> values;
  for (index_t i = 0; i < n; ++i) values.push_back(static_cast<float>(i % 8191) * 0.37F);
  for (const index_t begin : {0, 77777}) {
    expect_same(reduce_in<Space>(begin, n, Scattered{}, Sum{}), by_order(values, begin, n, 0.0, plus),
                "sum from " + std::to_string(begin));
  }
}

template <class Space, class Real, class Layout>
void check_extrema_and_conditions() {
  std::mt19937 random(seed());
  const Real infinity = std::numeric_limits<Real>::infinity();
  for (const index_t n : reduced_sizes) {
    Vectors<Real, Space, Layout> vectors(n, random);
    for (index_t i = 0; i < n; ++i) {  // so that many are equal
      vectors.source.view()[i].f()[0] = static_cast<Real>(static_cast<int>(random() % 21) - 10);
      vectors.source.view()[i].f()[1] = 1;
    }
    vectors.update();
    const auto view = vectors.array.view();
    const Product<decltype(view)> product{view};
    for (const auto& [begin, end] : ranges_of(n, random)) {
      Real largest = -infinity, smallest = infinity;
      index_t first_largest = -1, below = 0;
      for (index_t i = begin; i < end; ++i) {
        const Real term = vectors.term(i);
        if (first_largest < 0 || term > largest) first_largest = i;
        largest = std::max(largest, term);
        smallest = std::min(smallest, term);
        below += term < 3 ? 1 : 0;
      }
      EXPECT_EQ(reduce_in<Space>(begin, end, product, Max{}), largest);
      EXPECT_EQ(reduce_in<Space>(begin, end, product, Min{}), smallest);
      const Indexed<Real> place = reduce_in<Space>(begin, end, product, Argmax{});
      EXPECT_EQ(place.index, first_largest) << "of " << begin << " to " << end;
      EXPECT_EQ(place.value, largest);
      const IsBelow<decltype(view)> is_below{view, 3};
      EXPECT_EQ(reduce_in<Space>(begin, end, is_below, Count{}), below);
      EXPECT_EQ(reduce_in<Space>(begin, end, is_below, Any{}), below > 0);
      EXPECT_EQ(reduce_in<Space>(begin, end, is_below, All{}), below == end - begin);
      EXPECT_TRUE(reduce_in<Space>(begin, end, IsBelow<decltype(view)>{view, 11}, All{}));
      EXPECT_FALSE(reduce_in<Space>(begin, end, IsBelow<decltype(view)>{view, -11}, Any{}));
    }
  }
}

/// One NaN among the terms is the sum, the largest and the smallest; the first of two is the argmax.
template <class Space, class Real>
void check_nan() {
  std::mt19937 random(seed());
  const index_t n = 5003;
  for (int trial = 0; trial < 20; ++trial) {
    Vectors<Real, Space, Soa> vectors(n, random);
    const auto a = static_cast<index_t>(random() % n), b = static_cast<index_t>(random() % n);
    for (const index_t i : {a, b}) vectors.source.view()[i].f()[0] = std::numeric_limits<Real>::quiet_NaN();
    vectors.update();
    const auto view = vectors.array.view();
    const Product<decltype(view)> product{view};
    EXPECT_TRUE(std::isnan(reduce_in<Space>(0, n, product, Sum{})));
    EXPECT_TRUE(std::isnan(reduce_in<Space>(0, n, product, Max{}))) << a << ", " << b;
    EXPECT_TRUE(std::isnan(reduce_in<Space>(0, n, product, Min{}))) << a << ", " << b;
    EXPECT_EQ(reduce_in<Space>(0, n, product, Argmax{}).index, std::min(a, b));
    EXPECT_FALSE(std::isnan(reduce_in<Space>(std::max(a, b) + 1, n, product, Sum{}))) << "NaN lies before the range";
  }
}

template <class Space, class Real, class Layout>
void check_several_terms_and_stores() {
  std::mt19937 random(seed());
  for (const index_t n : reduced_sizes) {
    Vectors<Real, Space, Layout> vectors(n, random);
    const auto view = vectors.array.view();
    const auto& was = vectors.source;
    for (const auto& [begin, end] : ranges_of(n, random)) {
      const Eigen::Vector3d sums = reduce_in<Space>(begin, end, ThreeTerms<decltype(view)>{view}, Sum{});
      const auto at = [&](index_t i, int k) { return was.const_view()[i].f()[k]; };
      const auto products = vectors.values(double_of);
      const auto squares = vectors.values([&](Real, index_t i) { return static_cast<double>(at(i, 0) * at(i, 0)); });
      const auto seconds = vectors.values([&](Real, index_t i) { return static_cast<double>(at(i, 1)); });
      expect_same(sums[0], by_order(products, begin, end, 0.0, plus), "the first of three sums");
      expect_same(sums[1], by_order(squares, begin, end, 0.0, plus), "the second");
      expect_same(sums[2], by_order(seconds, begin, end, 0.0, plus), "the third");
      for (index_t i = begin; i < end; ++i) vectors.source.view()[i].f()[2] = vectors.term(i);
      const std::array<Real, 2> largest = reduce_in<Space>(begin, end, TwoTerms<decltype(view)>{view}, Max{});
      const auto larger = [](Real a, Real b) { return a > b ? a : b; };
      const auto terms = vectors.values([](Real term, index_t) { return term; });
      const auto firsts = vectors.values([&](Real, index_t i) { return at(i, 0); });
      const Real lowest = -std::numeric_limits<Real>::infinity();
      EXPECT_EQ(largest[0], by_order(terms, begin, end, lowest, larger));
      EXPECT_EQ(largest[1], by_order(firsts, begin, end, lowest, larger));
    }
    Array<elasticity::NodeForceObject, Real, Host, Aos> stored(n);
    copy(stored, vectors.array);
    synchronize();
    EXPECT_EQ(count_different(stored, vectors.source), 0) << "fields that kernels stored, and no others, of " << n;
  }
}

}  // namespace physgen::test
