// What an executor does in a way of its own on the CPU: the product with the assembled stiffness, and the coarsest
// inverse.
#pragma once

#include <fem/kernels/symmetric_product_host.h>
#include <physgen/executor.h>

#include <Eigen/Cholesky>
#include <vector>

namespace physgen::fem {

/// df = K dx; see symmetric_product_host.h.
template <class... Views>
void multiply(HostExecutor& /*on*/, const SymmetricProduct<Views...>& product, const EdgeSums& sums) {
  multiply(Host{}, product, sums, SumOrder::fixed);
}

/// df += the edges' part of K dx.
template <class... Views>
void add_edges(HostExecutor& /*on*/, const SymmetricProduct<Views...>& product, const EdgeSums& sums) {
  add_edges(Host{}, product, sums, SumOrder::fixed);
}

/// Makes the inverse of the scaled stiffness over its free components. @pre the level's stiffness is scaled
template <class Level>
void invert_coarsest(HostExecutor& /*on*/, Level& level) {
  const index_t n = level.nodes();
  if (level.coarse_inverse.size() == 0) return;
  using Dense = Eigen::MatrixXd;
  Dense A = Dense::Zero(3 * n, 3 * n);
  const auto nodes = level.scaled_nodes.const_view();
  const auto edges = level.scaled_edges.const_view();
  const auto ends = level.edges.const_view();
  for (index_t i = 0; i < n; ++i) A.block<3, 3>(3 * i, 3 * i) = -nodes[i].K().get().template cast<double>();
  for (index_t e = 0; e < level.edge_count(); ++e) {
    const auto names = ends[e].nodes();
    const index_t m = names[0], o = names[1];
    const Eigen::Matrix3d E = -edges[e].E().get().template cast<double>();
    A.block<3, 3>(3 * m, 3 * o) = E;
    A.block<3, 3>(3 * o, 3 * m) = E.transpose();
  }
  // A prescribed component, or one without stiffness, stands alone and is left out of the inverse.
  std::vector<bool> out(static_cast<std::size_t>(3 * n));
  for (index_t k = 0; k < 3 * n; ++k) {
    if (A(k, k) > 0) continue;
    out[static_cast<std::size_t>(k)] = true;
    A.row(k).setZero();
    A.col(k).setZero();
    A(k, k) = 1;
  }
  const Dense G = A.ldlt().solve(Dense::Identity(3 * n, 3 * n));
  const auto inverse = level.coarse_inverse.view();
  for (index_t i = 0; i < n; ++i) {
    for (index_t j = 0; j < n; ++j) {
      Eigen::Matrix3d block = G.block<3, 3>(3 * i, 3 * j);
      if (i == j) {
        for (int k = 0; k < 3; ++k) {
          if (out[static_cast<std::size_t>(3 * i + k)]) block(k, k) = 0;
        }
      }
      inverse[i * n + j].G() = Eigen::Matrix<typename Level::Real, 3, 3>(block.cast<typename Level::Real>());
    }
  }
}

}  // namespace physgen::fem
