// Sums at gathered objects on the device: nothing that threads add at the same time is lost, in every layout.
#include <physgen/cuda/parallel_for.h>

#include "gpu_fixture.h"
#include "test_objects.h"

namespace physgen::test {
namespace {

template <class TetView, class ForceView, class EdgeView>
struct AddToCornersOnDevice {
  TetView tets;
  ForceView forces;
  EdgeView counts;

  PHYSGEN_FUNCTION void operator()(index_t i) const {
    using Scalar = typename ForceView::Precision;
    const auto nodes = tets[i].nodes();
    for (int c = 0; c < 4; ++c) {
      const std::int32_t node = nodes[c];
      add(i, forces[node].f(), Eigen::Matrix<Scalar, 3, 1>(Scalar(1), Scalar(c + 1), Scalar(8)));
      add(i, forces[node].f()[2], Scalar(-7));
      add(i, counts[node].nodes()[1], 3);
    }
  }
};

template <class Layout>
class AddOnDevice : public GpuTest {};
TYPED_TEST_SUITE(AddOnDevice, AllLayouts, LayoutName);

template <class Real, class Layout, class Space = Cuda>
void check_sums_on_device(int nodes) {
  const index_t n = 100'003, begin = 17, end = 100'001;
  std::mt19937 random(seed());
  elasticity::TetArray<Real, Host, Soa> tets(n);
  std::vector<std::array<double, 4>> expected(static_cast<std::size_t>(nodes));
  for (index_t t = 0; t < n; ++t) {
    for (int c = 0; c < 4; ++c) {
      const auto node = static_cast<std::int32_t>(random() % static_cast<unsigned>(nodes));
      tets.view()[t].nodes()[c] = node;
      if (t < begin || t >= end) continue;
      auto& sum = expected[static_cast<std::size_t>(node)];
      sum[0] += 1;
      sum[1] += c + 1;
      sum[2] += 1;
      sum[3] += 3;
    }
  }
  elasticity::TetArray<Real, Cuda> tets_there(n);
  copy(tets_there, tets);
  elasticity::NodeForceArray<Real, Space, Layout> forces(nodes);
  elasticity::EdgeArray<Real, Space, Layout> counts(nodes);
  using Kernel = AddToCornersOnDevice<decltype(tets_there.view()), decltype(forces.view()), decltype(counts.view())>;
  parallel_for(Cuda{}, begin, end, Kernel{tets_there.view(), forces.view(), counts.view()});
  elasticity::NodeForceArray<Real, Host> found(nodes);
  elasticity::EdgeArray<Real, Host> found_counts(nodes);
  copy(found, forces);
  copy(found_counts, counts);
  synchronize();
  for (index_t node = 0; node < nodes; ++node) {
    const auto& sum = expected[static_cast<std::size_t>(node)];
    for (int k = 0; k < 3; ++k) ASSERT_EQ(found.view()[node].f()[k], sum[static_cast<std::size_t>(k)]) << node;
    ASSERT_EQ(found_counts.view()[node].nodes()[1], sum[3]);
    ASSERT_EQ(found_counts.view()[node].nodes()[0], 0);
  }
}

struct Nothing {
  PHYSGEN_FUNCTION void operator()(index_t /*i*/) const {}
};

TEST(ParallelForOnDevice, refuses_ranges_that_begin_before_the_first_object) {
  EXPECT_THROW(parallel_for(Cuda{}, -3, 10, Nothing{}), Error);
}

TYPED_TEST(AddOnDevice, sums_what_threads_add_to_one_object) {
  check_sums_on_device<float, TypeParam>(1);
  check_sums_on_device<float, TypeParam>(1001);
  check_sums_on_device<double, TypeParam>(37);
}

TYPED_TEST(AddOnDevice, sums_what_threads_add_in_pinned_memory) {
  check_sums_on_device<float, TypeParam, PinnedHost>(37);
  check_sums_on_device<double, TypeParam, PinnedHost>(5);
}

}  // namespace
}  // namespace physgen::test
