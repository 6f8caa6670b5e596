// The operator of the multilevel Schwarz preconditioner by itself: against dense algebra, and what it makes of blocks
// that are not positive definite.
#include <fem/solver/elastic/tangent_blocks.h>
#include <fem/solver/levels/scaled_blocks.h>
#include <fem/solver/preconditioners/schwarz/preconditioner.h>
#include <fem/solver/solvers/all_arrays.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <map>

#include "../bonded.h"

namespace physgen::fem {
namespace {

using Dense = Eigen::MatrixXd;

/// Blocks of linear elasticity, df(m)/dx(n) of each edge of the graph.
std::vector<Eigen::Matrix3d> edge_blocks(const MeshLevel& level, const LevelGraph& graph, double poissons_ratio) {
  const double mu = 0.5 / (1 + poissons_ratio), lambda = 2 * mu * poissons_ratio / (1 - 2 * poissons_ratio);
  std::map<std::array<Index, 2>, std::size_t> numbers;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) numbers[graph.edges[e]] = e;
  std::vector<Eigen::Matrix3d> blocks(graph.edges.size(), Eigen::Matrix3d::Zero());
  for (const auto& tet : level.mesh.tets) {
    const auto x = [&](std::size_t c) {
      return Eigen::Map<const Eigen::Vector3d>(level.rest[std::size_t(tet[c])].data());
    };
    Eigen::Matrix3d D;
    D << x(1) - x(0), x(2) - x(0), x(3) - x(0);
    Eigen::Matrix<double, 3, 4> g;
    g.rightCols<3>() = D.inverse().transpose();
    g.col(0) = -g.rightCols<3>().rowwise().sum();
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < 4; ++b) {
        const Index m = tet[std::size_t(a)], n = tet[std::size_t(b)];
        if (m >= n) continue;
        blocks[numbers.at({m, n})] -= D.determinant() / 6 *
                                      (lambda * g.col(a) * g.col(b).transpose() + mu * g.col(b) * g.col(a).transpose() +
                                       mu * g.col(a).dot(g.col(b)) * Eigen::Matrix3d::Identity());
      }
    }
  }
  return blocks;
}

/// A level with its stiffness and its preconditioner.
template <class Real, class Stored>
struct Prepared {
  LevelGraph graph;
  SchwarzHierarchy hierarchy;
  LinearLevel<Real, Host, Stored> level;
  HostExecutor on;

  Prepared(const std::vector<MeshLevel>& mesh, const std::vector<Eigen::Matrix3d>& blocks)
      : graph(make_level_graphs(mesh).front()),
        hierarchy(make_schwarz_hierarchy(graph, mesh[0].rest)),
        level(graph, nullptr) {
    Schwarz::make_arrays(level, graph, mesh[0].rest);
    for (index_t e = 0; e < level.edge_count(); ++e) {
      level.edge_stiffness.view()[e].E() = Matrix3<Real>(blocks[std::size_t(e)].cast<Real>());
    }
    const auto nodes = level.node_stiffness.view();
    on.run(level.nodes(), SumNodeStiffness{level.node_edges.const_view(), level.edge_stiffness.const_view(), nodes});
    on.run(level.nodes(), ComputeNodeScale{true, level.node_stiffness.const_view(), level.scales.view()});
    on.run(level.nodes(), ScaleNodes{level.node_stiffness.const_view(), level.constraints.const_view(),
                                     level.scales.const_view(), level.scaled_nodes.view(), level.inverse.view()});
    prepare_schwarz(on, level);
  }
  /// M r; r is 0 in prescribed components.
  Eigen::VectorXd apply(const Eigen::VectorXd& r) {
    const auto n = level.nodes();
    for (index_t i = 0; i < n; ++i) {
      level.residual.view()[i].df() = Vector3<Real>(r.segment<3>(3 * i).template cast<Real>());
    }
    apply_schwarz(on, level);
    Eigen::VectorXd z(3 * n);
    for (index_t i = 0; i < n; ++i) {
      const Vector3<Real> dx = level.correction.const_view()[i].dx();
      z.segment<3>(3 * i) = dx.template cast<double>();
    }
    return z;
  }
  [[nodiscard]] bool is_free(Eigen::Index k) const { return (graph.fixed[std::size_t(k / 3)] >> (k % 3) & 1) == 0; }
  [[nodiscard]] Eigen::VectorXd random(std::mt19937_64& random) const {
    std::uniform_real_distribution<double> number(-1, 1);
    Eigen::VectorXd r(3 * graph.nodes);
    for (Eigen::Index k = 0; k < r.size(); ++k) r[k] = is_free(k) ? number(random) : 0;
    return r;
  }
  /// -K over free components, with 0 in the others.
  [[nodiscard]] Dense matrix(const std::vector<Eigen::Matrix3d>& blocks) const {
    const Eigen::Index size = 3 * graph.nodes;
    Dense A = Dense::Zero(size, size);
    for (std::size_t e = 0; e < blocks.size(); ++e) {
      const Index m = graph.edges[e][0], n = graph.edges[e][1];
      A.block<3, 3>(3 * m, 3 * n) -= blocks[e];
      A.block<3, 3>(3 * n, 3 * m) -= blocks[e].transpose();
      const Eigen::Matrix3d symmetric = (blocks[e] + blocks[e].transpose()) / 2;
      A.block<3, 3>(3 * m, 3 * m) += symmetric;
      A.block<3, 3>(3 * n, 3 * n) += symmetric;
    }
    for (Eigen::Index k = 0; k < size; ++k) {
      if (is_free(k)) continue;
      A.row(k).setZero();
      A.col(k).setZero();
    }
    return A;
  }
  /// The nodes of each slot, through all levels.
  [[nodiscard]] std::vector<std::vector<Index>> nodes_of_slots() const {
    std::vector<std::vector<Index>> nodes(hierarchy.slots.size());
    for (Index n = 0; n < graph.nodes; ++n) {
      for (Index s = hierarchy.node_slots[std::size_t(n)]; s >= 0;) {
        nodes[std::size_t(s)].push_back(n);
        const Index parent = hierarchy.slots[std::size_t(s)][1];
        s = parent < 0 ? -1 : hierarchy.first_supernode_slot() + parent;
      }
    }
    return nodes;
  }
};
using InDouble = Prepared<double, StoredAsComputed>;

/// The sum over all blocks of P (P^T A P)^-1 P^T, or of those of its nodes where P^T A P is not positive definite.
Dense reference(const InDouble& prepared, const Dense& A, int* indefinite) {
  const auto nodes = prepared.nodes_of_slots();
  Dense M = Dense::Zero(A.rows(), A.cols());
  const auto add = [&](std::size_t first, std::size_t end) {
    Dense P = Dense::Zero(A.rows(), 3 * Eigen::Index(end - first));
    Eigen::Index columns = 0;
    for (std::size_t s = first; s < end; ++s) {
      for (Eigen::Index k = 0; k < 3; ++k) {
        bool any = false;
        for (const Index n : nodes[s]) {
          if (!prepared.is_free(3 * n + k)) continue;
          P(3 * n + k, columns) = 1;
          any = true;
        }
        columns += any ? 1 : 0;
      }
    }
    const Dense Q = P.leftCols(columns);
    const Dense block = Q.transpose() * A * Q;
    const bool definite = block.llt().info() == Eigen::Success;
    if (definite) M += Q * block.llt().solve(Q.transpose());
    return definite;
  };
  for (std::size_t s = 0; s < nodes.size(); s += schwarz_slots) {
    if (add(s, s + schwarz_slots)) continue;
    if (indefinite != nullptr) ++*indefinite;
    for (std::size_t k = 0; k < schwarz_slots; ++k) (void)add(s + k, s + k + 1);
  }
  return M;
}

TEST(Schwarz, equals_the_sum_over_levels_of_inverses_of_blocks) {
  const auto& levels = irregular();
  const auto blocks = edge_blocks(levels[0], make_level_graphs(levels).front(), 0.45);
  InDouble prepared(levels, blocks);
  const Dense A = prepared.matrix(blocks);
  int indefinite = 0;
  const Dense M = reference(prepared, A, &indefinite);
  EXPECT_EQ(indefinite, 0);
  std::mt19937_64 random(79);
  for (int k = 0; k < 5; ++k) {
    const Eigen::VectorXd r = prepared.random(random), z = prepared.apply(r), expected = M * r;
    EXPECT_LE((z - expected).norm(), 1e-11 * expected.norm());
  }
}

template <class Real, class Stored>
void expect_symmetric_and_positive(double poissons_ratio, double tolerance) {
  const auto& levels = irregular();
  const auto blocks = edge_blocks(levels[0], make_level_graphs(levels).front(), poissons_ratio);
  Prepared<Real, Stored> prepared(levels, blocks);
  std::mt19937_64 random(83);
  Eigen::Index prescribed = 0;
  for (int k = 0; k < 20; ++k) {
    const Eigen::VectorXd a = prepared.random(random), b = prepared.random(random);
    const Eigen::VectorXd Ma = prepared.apply(a), Mb = prepared.apply(b);
    EXPECT_NEAR(b.dot(Ma), a.dot(Mb), tolerance * std::sqrt(a.dot(Ma) * b.dot(Mb)));
    EXPECT_GT(a.dot(Ma), 0);
    // The same for the forces that a displacement causes, of which the softest parts have the least.
    const Eigen::VectorXd f = prepared.matrix(blocks) * a;
    EXPECT_GT(f.dot(prepared.apply(f)), 0);
    for (Eigen::Index i = 0; i < a.size(); ++i) {
      if (prepared.is_free(i)) continue;
      EXPECT_EQ(Ma[i], 0);
      ++prescribed;
    }
  }
  EXPECT_GT(prescribed, 0);
}

TEST(Schwarz, is_symmetric_and_positive_definite_and_leaves_prescribed_components_alone) {
  for (const double poissons_ratio : {.3, .45, .499}) {
    SCOPED_TRACE(poissons_ratio);
    expect_symmetric_and_positive<double, StoredAsComputed>(poissons_ratio, 1e-12);
    expect_symmetric_and_positive<float, StoredAsComputed>(poissons_ratio, 1e-4);
    expect_symmetric_and_positive<float, StoredInHalf>(poissons_ratio, 1e-4);
  }
}

TEST(Schwarz, makes_block_jacobi_of_a_block_that_is_not_positive_definite) {
  const auto& levels = irregular();
  const LevelGraph graph = make_level_graphs(levels).front();
  auto blocks = edge_blocks(levels[0], graph, 0.45);
  InDouble sound(levels, blocks);
  // One edge inside a block pushes where it pulled, so strongly that its nodes' blocks stay positive and it does not.
  std::size_t changed = blocks.size();
  const auto slot = [&](Index n) { return sound.hierarchy.node_slots[std::size_t(n)]; };
  for (std::size_t e = 0; e < blocks.size() && changed == blocks.size(); ++e) {
    const Index m = slot(graph.edges[e][0]), n = slot(graph.edges[e][1]);
    if (m >= 0 && n >= 0 && m / schwarz_slots == n / schwarz_slots) changed = e;
  }
  ASSERT_LT(changed, blocks.size());
  Dense A = sound.matrix(blocks);
  blocks[changed] -= 0.2 * A.diagonal().maxCoeff() * Eigen::Matrix3d::Identity();
  InDouble prepared(levels, blocks);
  A = prepared.matrix(blocks);
  int indefinite = 0;
  const Dense M = reference(prepared, A, &indefinite);
  EXPECT_GE(indefinite, 1);
  EXPECT_LT(indefinite, prepared.hierarchy.first_block[1]);
  std::mt19937_64 random(89);
  for (int k = 0; k < 5; ++k) {
    const Eigen::VectorXd r = prepared.random(random), z = prepared.apply(r), expected = M * r;
    EXPECT_LE((z - expected).norm(), 1e-10 * expected.norm());
    EXPECT_GT(r.dot(z), 0);
  }
}

TEST(Schwarz, a_body_that_nothing_holds_keeps_its_corrections_finite) {
  auto levels = irregular();
  levels[0].fixed.assign(levels[0].fixed.size(), 0);
  const auto blocks = edge_blocks(levels[0], make_level_graphs(levels).front(), 0.45);
  Prepared<float, StoredInHalf> prepared(levels, blocks);
  InDouble exact(levels, blocks);
  std::mt19937_64 random(97);
  // A force in balance, as that of a displacement is.
  const Eigen::VectorXd r = exact.matrix(blocks) * exact.random(random), z = prepared.apply(r),
                        expected = exact.apply(r);
  EXPECT_LE((z - expected).norm(), 0.01 * expected.norm());
}

}  // namespace
}  // namespace physgen::fem
