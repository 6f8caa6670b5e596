// SIMD access: packs and gathered batches read and write the same elements as plain indices do, in every layout.
#include <physgen/kernels/add.h>
#include <physgen/parallel_for.h>

#include <algorithm>
#include <thread>

#include "in_packs.h"
#include "test_objects.h"

namespace physgen::test {
namespace {

template <class L>
class SimdAccess : public ::testing::Test {};
TYPED_TEST_SUITE(SimdAccess, AllLayouts, LayoutName);

template <class Real, class Layout>
elasticity::DeformationSvdArray<Real, Host, Layout> random_array(index_t n) {
  std::mt19937 random(seed());
  Array<elasticity::DeformationSvdObject, Real, Host, Aos> source(n);
  randomise(source, random);
  elasticity::DeformationSvdArray<Real, Host, Layout> array(n);
  copy(array, source);
  return array;
}

template <class Real, class Layout>
void check_packs() {
  constexpr int width = native_lanes<Real>;
  const auto array = random_array<Real, Layout>(67);
  const auto view = array.view();
  elasticity::DeformationSvdArray<Real, Host, Layout> written(67);
  for (index_t begin = 0; begin + width <= 67; begin += width) {
    const auto value = view.get(Pack<width>{begin});
    for (int l = 0; l < width; ++l) {
      const auto one = view.get(begin + l);
      for (int k = 0; k < 9; ++k) {
        ASSERT_EQ(value.U(k % 3, k / 3).get(static_cast<std::size_t>(l)), one.U(k % 3, k / 3));
        ASSERT_EQ(value.V(k % 3, k / 3).get(static_cast<std::size_t>(l)), one.V(k % 3, k / 3));
      }
      for (int k = 0; k < 3; ++k) ASSERT_EQ(value.s(k).get(static_cast<std::size_t>(l)), one.s(k));
    }
    written.view().put(Pack<width>{begin}, value);
  }
  for (index_t i = 0; i < 67 / width * width; ++i) {
    for (int k = 0; k < array.elements; ++k) ASSERT_EQ(written.getdata(i, k), array.getdata(i, k));
  }
}

TYPED_TEST(SimdAccess, packs_read_and_write_what_plain_indices_do) {
  check_packs<float, TypeParam>();
  check_packs<double, TypeParam>();
}

TYPED_TEST(SimdAccess, a_batch_of_indices_gathers_the_objects_at_them) {
  constexpr int width = native_lanes<float>;
  auto array = random_array<float, TypeParam>(1000);
  const auto view = array.view();
  std::mt19937 random(seed());
  alignas(64) std::array<std::int32_t, width> indices{};
  for (auto& index : indices) index = static_cast<std::int32_t>(random() % 1000);
  const auto batch = batch_t<std::int32_t, width>::load_aligned(indices.data());
  const auto gathered = view.get(batch);
  for (int l = 0; l < width; ++l) {
    const auto lane = static_cast<std::size_t>(l);
    for (int k = 0; k < 3; ++k) ASSERT_EQ(gathered.s(k).get(lane), view[indices[lane]].s()(k));
  }
}

/// Gathers by W indices: runs from every place of two tiles and up to the last object, and such as only look like runs.
template <class Real, class Layout, int W>
void check_runs() {
  constexpr index_t n = 131;  // the last run ends in the middle of a tile of any layout
  const auto array = random_array<Real, Layout>(n);
  const auto view = array.view();
  std::mt19937 random(seed());
  const auto check = [&](const std::array<std::int32_t, W>& indices) {
    alignas(64) auto aligned = indices;
    const auto gathered = view.get(batch_t<std::int32_t, W>::load_aligned(aligned.data()));
    for (int l = 0; l < W; ++l) {
      const auto lane = static_cast<std::size_t>(l);
      const auto one = view.get(indices[lane]);
      for (int k = 0; k < 9; ++k) ASSERT_EQ(gathered.V(k % 3, k / 3).get(lane), one.V(k % 3, k / 3));
      for (int k = 0; k < 3; ++k) ASSERT_EQ(gathered.s(k).get(lane), one.s(k)) << "lane " << l << " of " << indices[0];
    }
  };
  for (std::int32_t begin = 0; begin + W <= n; ++begin) {
    std::array<std::int32_t, W> run, other;
    for (int l = 0; l < W; ++l) run[static_cast<std::size_t>(l)] = begin + l;
    check(run);
    other = run;
    other[random() % W] = static_cast<std::int32_t>(random() % n);  // the first and the last are often those of a run
    check(other);
    for (auto& index : other) index = std::max(index - 3, 0);  // a neighbour behind the edge of a grid
    check(other);
    std::reverse(run.begin(), run.end());
    check(run);
  }
}

TYPED_TEST(SimdAccess, indices_that_follow_each_other_gather_as_any_others_do) {
  check_runs<float, TypeParam, native_lanes<float>>();
  check_runs<float, TypeParam, 4>();
  check_runs<double, TypeParam, native_lanes<double>>();
}

TEST(Add, from_two_threads_of_the_program_loses_nothing) {
  constexpr int each = 200000;
  elasticity::NodeForceArray<double> forces(1);
  const auto view = forces.view();
  const Eigen::Vector3d one(1, 2, 3);
  add(index_t{0}, view[0].f(), one);
  const auto work = [&] {
    for (int k = 0; k < each; ++k) add(index_t{0}, view[0].f(), one);
  };
  std::thread first(work), second(work);
  first.join();
  second.join();
  add(index_t{0}, view[0].f(), one);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(view[0].f()(k), (k + 1) * (2.0 * each + 2));
}

template <class Layout>
struct CountVisits {
  using Scalar = float;
  elasticity::NodeForceView<float, Layout> visits;
  template <class I>
  void operator()(I i) const {
    auto value = visits.get(i);
    value.f(1) += 1.0F;
    visits.put(i, value);
  }
};

TYPED_TEST(SimdAccess, parallel_for_visits_every_object_once) {
  for (const index_t n : {0, 1, 31, 33, 20011}) {
    elasticity::NodeForceArray<float, Host, TypeParam> visits(n);
    const CountVisits<TypeParam> kernel{visits.view()};
    parallel_for(Host{}, n, in_packs(kernel));
    parallel_for(Host{}, n, lanes<1>(kernel));
    for (index_t i = 0; i < n; ++i) ASSERT_EQ(visits.view()[i].f()(1), 2.0F) << "object " << i << " of " << n;
  }
}

TEST(ParallelFor, passes_on_what_a_kernel_throws) {
  const auto kernel = [](index_t i) {
    if (i == 12345) throw Error("object 12345 is bad");
  };
  EXPECT_THROW(parallel_for(Host{}, 20000, lanes<1>(kernel)), Error);
}

}  // namespace
}  // namespace physgen::test
