// The bytes of physbench's rows, which probes and formats give, held against numbers that are counted by hand here from
// what the kernels say that they read and write.
#include "measure/row_bytes.h"

#include <fem/kernels/symmetric_product_host.h>
#include <gtest/gtest.h>

#include "groups/forces.h"
#include "groups/schemes.h"
#include "kernels/force_chain.h"
#include "kernels/force_differential.h"
#include "kernels/matrix_free.h"
#include "kernels/newton_update.h"
#include "kernels/stress_derivative.h"
#include "kernels/svd_variants.h"

namespace physgen::bench {
namespace {

/// No two of them are sums or multiples of others.
constexpr index_t tets = 1'000'003, nodes = 10'007, edges = 100'019;

index_t count(Domain domain) {
  switch (domain) {
    case Domain::tets:
      return tets;
    case Domain::nodes:
      return nodes;
    case Domain::edges:
      return edges;
    case Domain::node_tets:
      return 4 * tets;
    case Domain::node_edges:
      return 2 * edges;
    case Domain::edge_tets:
      return 6 * tets;
  }
  return 0;
}

/// Bytes of index numbers, and numbers in Real, of a tet, a node and an edge. Two indices of 4 bytes for each entry of
/// a row, and for its beginning and end.
struct Moved {
  double tet_indices = 0, tet_reals = 0, node_indices = 0, node_reals = 0, edge_indices = 0, edge_reals = 0;
};

template <class Kernel>
void expect_moves(const Moved& moved) {
  const auto expected = [&](double real) {
    return static_cast<double>(tets) * (moved.tet_indices + moved.tet_reals * real) +
           static_cast<double>(nodes) * (moved.node_indices + moved.node_reals * real) +
           static_cast<double>(edges) * (moved.edge_indices + moved.edge_reals * real);
  };
  EXPECT_EQ((row_bytes<Kernel, float>(count)), expected(4)) << Kernel::name;
  EXPECT_EQ((row_bytes<Kernel, double>(count)), expected(8)) << Kernel::name;
}

TEST(RowBytes, are_each_input_and_each_output_of_a_kernel_over_tets) {
  expect_moves<DpFromDf>({.tet_reals = 9 + 9 + 12 + 9 + 9});
  expect_moves<StressDerivative>({.tet_reals = 3 + 12});
  expect_moves<StressDerivativeClamped>({.tet_reals = 3 + 12});
  expect_moves<StressDerivativeAbsolute>({.tet_reals = 3 + 12});
  expect_moves<Stress>({.tet_reals = 21 + 9});
  expect_moves<ElasticForce>({.tet_reals = 10 + 9 + 9});
  expect_moves<TetStiffness>({.tet_reals = 10 + 18 + 12 + 4 * 6 + 6 * 9});
}

TEST(RowBytes, of_an_svd_are_those_of_the_parts_that_it_stores) {
  expect_moves<Svd>({.tet_reals = 9 + 21});
  expect_moves<Svd3Sweeps>({.tet_reals = 9 + 21});
  expect_moves<Svd5Sweeps>({.tet_reals = 9 + 21});
  expect_moves<SvdArrays>({.tet_reals = 9 + 21});
  expect_moves<SvdQuaternions>({.tet_reals = 9 + 4 + 3 + 4});
  expect_moves<SvdWithoutU>({.tet_reals = 9 + 12});
  expect_moves<SvdWithoutV>({.tet_reals = 9 + 12});
  expect_moves<SingularValues>({.tet_reals = 9 + 3});
  expect_moves<PolarRotation>({.tet_reals = 9 + 9});
}

TEST(RowBytes, count_what_is_gathered_once) {
  expect_moves<DeformationGradient>({.tet_indices = 16, .tet_reals = 9 + 9, .node_reals = 3});
  expect_moves<ElementForceDifferential>({.tet_indices = 16, .tet_reals = 10 + 18 + 12 + 9, .node_reals = 3});
  expect_moves<GatherForces>({.tet_indices = 4 * 8, .tet_reals = 9, .node_indices = 8, .node_reals = 3});
  expect_moves<NodeStiffness>({.tet_indices = 4 * 8, .tet_reals = 4 * 6, .node_indices = 8, .node_reals = 6});
  expect_moves<EdgeStiffness>({.tet_indices = 6 * 8, .tet_reals = 6 * 9, .edge_indices = 8, .edge_reals = 9});
  expect_moves<AddForceDifferential>(
      {.node_indices = 8, .node_reals = 6 + 3 + 3, .edge_indices = 8 + 2 * 8, .edge_reals = 9});
}

TEST(RowBytes, of_a_symmetric_product_are_those_of_its_half_and_of_its_vectors) {
  expect_moves<SymmetricForceDifferential>({.node_reals = 6 + 3 + 3, .edge_indices = 8, .edge_reals = 9});
}

TEST(RowBytes, of_separate_kernels_are_the_sum_of_theirs) {
  expect_moves<ForceChainSeparate>(
      {.tet_indices = 16 + 4 * 8, .tet_reals = 18 + 30 + 30 + 28 + 9, .node_indices = 8, .node_reals = 3 + 3});
  expect_moves<NewtonUpdateSeparate>({.tet_indices = 16, .tet_reals = 18 + 30 + 15 + 30 + 28, .node_reals = 3});
  expect_moves<MatrixFreeSeparate>(
      {.tet_indices = 16 + 4 * 8, .tet_reals = 49 + 9, .node_indices = 8, .node_reals = 3 + 3});
}

TEST(RowBytes, of_a_fused_kernel_leave_its_locals_out) {
  expect_moves<NewtonUpdateFused>({.tet_indices = 16, .tet_reals = 10 + 18 + 12 + 9, .node_reals = 3});
}

TEST(RowBytes, count_sums_at_nodes_once) {
  expect_moves<ForceChainFused>({.tet_indices = 16, .tet_reals = 10, .node_reals = 3 + 3});
  expect_moves<MatrixFreeFused>({.tet_indices = 16, .tet_reals = 10 + 18 + 12, .node_reals = 3 + 3});
}

TEST(RowBytes, count_twice_what_one_launch_writes_and_another_reads) {
  expect_moves<ForceChainFusedFixedOrder>(
      {.tet_indices = 16 + 16, .tet_reals = 10 + 2 * 4 * 3, .node_indices = 8, .node_reals = 3 + 3});
  expect_moves<ForceChainFusedGathered>(
      {.tet_indices = 16 + 4 * 8, .tet_reals = 10 + 9 + 9, .node_indices = 8, .node_reals = 3 + 3});
}

TEST(RowBytes, are_those_of_the_formats_of_a_scheme) {
  const auto per_tet = []<class Scheme>() {
    return row_bytes<DpFromDf, float, Scheme>(count) / static_cast<double>(tets);
  };
  EXPECT_EQ(per_tet.operator()<scheme::QuaternionFloat>(), 2 * 16 + 48 + 36 + 36);
  EXPECT_EQ(per_tet.operator()<scheme::Quaternion16Float>(), 2 * 8 + 48 + 36 + 36);
  EXPECT_EQ(per_tet.operator()<scheme::QuaternionHalf>(), 2 * 16 + 24 + 36 + 36);
  EXPECT_EQ(per_tet.operator()<scheme::AllHalf>(), 76);
  EXPECT_EQ(per_tet.operator()<scheme::MatricesHalf>(), 96);
  EXPECT_EQ(per_tet.operator()<scheme::AllBfloat16>(), 76);
}

/// F of a tet, by a kernel that also reads the volume, where a number says so at run time.
template <class Compute, class Rest, class F>
struct AlsoReadVolume {
  using Scalar = typename F::Precision;
  Compute compute;
  Rest rest;
  F gradients;
  bool wanted;
  template <class I>
  void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    compute(i);
    if (!wanted) return;
    const S volume = rest[i].volume();
    gradients[i].F() = Matrix3<S>(Matrix3<S>::Identity() * volume);
  }
};
template <class Compute, class Rest, class F>
AlsoReadVolume(Compute, Rest, F, bool) -> AlsoReadVolume<Compute, Rest, F>;

struct DeformationGradientAndVolume : DeformationGradient {
  static constexpr const char* name = "deformation_gradient_and_volume";
  template <class Real>
  static auto run(const auto& tets, const auto& positions, const auto& rest, const auto& gradients) {
    return AlsoReadVolume{fem::ComputeDeformationGradient{tets, positions, rest, gradients}, rest, gradients, false};
  }
};

TEST(RowBytes, grow_by_a_field_that_a_kernel_reads_beside_what_it_read) {
  expect_moves<DeformationGradientAndVolume>({.tet_indices = 16, .tet_reals = 9 + 9 + 1, .node_reals = 3});
}

struct ForceChainFusedAndRead : ForceChainFused {
  static constexpr const char* name = "force_chain_fused_and_read";
  using Writes = Operands<Gathered<source::Of<Output, domain>>,
                          Gathered<source::Of<elasticity::NodeForceDifferentialObject, domain>>>;
  template <class Real>
  static auto run(const auto& tets, const auto& positions, const auto& rest, const auto& ranges, const auto& entries,
                  const auto& forces, const auto& again) {
    const auto sum = ForceChainFused::run<Real>(tets, positions, rest, ranges, entries, forces);
    const auto read_again = over<Real>([forces, again]<class I>(I i) {
      const Vector3<lanes_t<Real, I>> f = forces[i].f();
      again[i].df() = f;
    });
    return chain(std::get<0>(sum.links), std::get<1>(sum.links), link(forces.size(), read_again));
  }
};

TEST(RowBytes, grow_by_a_launch_that_reads_a_sum_when_it_is_complete) {
  expect_moves<ForceChainFusedAndRead>({.tet_indices = 16, .tet_reals = 10, .node_reals = 3 + 3 + 3 + 3});
}

}  // namespace
}  // namespace physgen::bench
