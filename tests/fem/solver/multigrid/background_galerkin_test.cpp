// The stiffness of a background grid against dense matrices: P^T M K M P, where M takes out what is prescribed.
#include <fem/solver/elastic/evaluate.h>
#include <fem/solver/hierarchy/background_grid.h>
#include <fem/solver/linear/product_host.h>
#include <fem/solver/newton/newton.h>
#include <fem/solver/solvers/all_arrays.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cstdio>

#include "../irregular.h"

namespace physgen::fem {

namespace {

using Arrays = EquilibriumArrays<double, Host>;
using Level = LinearLevel<double, Host, StoredAsComputed>;
using Dense = Eigen::MatrixXd;

/// A long bar without a corner, held along a line inside of it and, in one direction, at one end: a grid in two levels.
std::vector<MeshLevel> bar(bool patches) {
  const Tets box = irregular_box({36, 4, 4}, {36, 4, 4}, 0.2, 67);
  const Tets tets = shuffled(cut(box, [](const Point& x) { return x[0] < 28 || x[1] < 2; }), 71);
  auto levels = make_levels(tets, 0, patches, [](const Point& x) -> std::uint8_t {
    if (x[0] == 0) return 2;
    return std::hypot(x[1] - 2.1, x[2] - 1.8) < 0.9 ? 7 : 0;
  });
  (void)add_background_grid(levels);
  return levels;
}

Dense dense_stiffness(const Level& level) {
  Dense K = Dense::Zero(3 * level.nodes(), 3 * level.nodes());
  for (index_t n = 0; n < level.nodes(); ++n)
    K.block<3, 3>(3 * n, 3 * n) = level.node_stiffness.const_view()[n].K().get();
  for (index_t e = 0; e < level.edge_count(); ++e) {
    const auto ends = level.edges.const_view()[e].nodes();
    const index_t m = ends[0], n = ends[1];
    const Eigen::Matrix3d E = level.edge_stiffness.const_view()[e].E();
    K.block<3, 3>(3 * m, 3 * n) = E;
    K.block<3, 3>(3 * n, 3 * m) = E.transpose();
  }
  return K;
}

Dense dense_interpolation(const MeshLevel& fine, const MeshLevel& coarse) {
  Dense P = Dense::Zero(3 * fine.mesh.nodes, 3 * coarse.mesh.nodes);
  const auto add = [&](std::size_t node, Index parent, double weight) {
    for (Index k = 0; k < 3; ++k) P(3 * static_cast<Index>(node) + k, 3 * parent + k) += weight;
  };
  for (std::size_t n = 0; n < fine.rest.size(); ++n) {
    if (fine.grid_parents.empty()) {
      for (const Index p : fine.parents[n]) add(n, p, 0.5);
    } else {
      for (std::size_t k = 0; k < 4; ++k) add(n, fine.grid_parents[n].nodes[k], fine.grid_parents[n].weights[k]);
    }
  }
  return P;
}

Dense without_prescribed(Dense K, const std::vector<std::uint8_t>& fixed) {
  for (std::size_t n = 0; n < fixed.size(); ++n) {
    for (int k = 0; k < 3; ++k) {
      if ((fixed[n] >> k & 1) == 0) continue;
      K.row(3 * static_cast<Eigen::Index>(n) + k).setZero();
      K.col(3 * static_cast<Eigen::Index>(n) + k).setZero();
    }
  }
  return K;
}

TEST(BackgroundGrid, stiffness_of_each_level_is_what_dense_products_give) {
  for (const bool patches : {false, true}) {
    const auto levels = bar(patches);
    ASSERT_EQ(levels.size(), 3U);
    const auto graphs = make_level_graphs(levels);
    HostExecutor on;
    Arrays arrays(levels[0], graphs[0], false, TangentLists::of_edges, nullptr);
    std::vector<std::unique_ptr<Level>> linear;
    for (std::size_t l = 0; l < 3; ++l) {
      linear.push_back(std::make_unique<Level>(graphs[l], l < 2 ? &graphs[l + 1] : nullptr));
    }
    // Deformed at random, so that no two blocks are alike.
    std::mt19937_64 random(73);
    std::normal_distribution<double> noise(0, 0.02);
    for (index_t n = 0; n < arrays.nodes(); ++n) {
      for (int k = 0; k < 3; ++k) arrays.positions.view()[n].x()[k] += noise(random);
    }
    const auto evaluator = make_evaluator<HostExecutor, Arrays>("neo-hookean", {{1, .45}}, patches);
    (void)evaluate_state(on, arrays, *linear[0], *evaluator, arrays.positions.const_view(), arrays.forces.view(), 0.0,
                         true);
    assemble(on, arrays, *linear[0], *evaluator, TangentFilter::none);
    Dense expected = without_prescribed(dense_stiffness(*linear[0]), levels[0].fixed);
    for (std::size_t l = 1; l < 3; ++l) {
      const Dense P = dense_interpolation(levels[l - 1], levels[l]);
      expected = Dense(P.transpose() * expected * P);
      coarsen_stiffness(on, *linear[l - 1], *linear[l]);
      const double error =
          (dense_stiffness(*linear[l]) - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
      std::printf("%s, level %zu, %d nodes, %zu edges: %.1e\n", patches ? "patches" : "tets", l, int(graphs[l].nodes),
                  graphs[l].edges.size(), error);
      EXPECT_LE(error, 1e-14);
    }
  }
}

}  // namespace
}  // namespace physgen::fem
