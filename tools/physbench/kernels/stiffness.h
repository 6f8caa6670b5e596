// The stiffness: blocks of each tet, and their sums over the tets of each node and edge.
#pragma once

#include <fem/kernels/stiffness.h>
#include <fem/mesh/mesh.h>

#include "kernels/gather_forces.h"
#include "kernels/stress_derivative.h"

namespace physgen::bench {

/// The stiffness blocks of each tet: 4 of its corners, 6 of its edges.
struct TetStiffness {
  static constexpr const char* name = "tet_stiffness";
  static constexpr int place = 8;
  static constexpr Domain domain = Domain::tets;
  using Output = elasticity::TetStiffnessObject;
  using Reads = Operands<Streamed<source::RestShapes>, Streamed<OutputOf<Svd>>, Streamed<OutputOf<StressDerivative>>>;
  using Writes = Operands<Streamed<source::Of<Output, domain>>>;
  template <class Real, class... View>
  static auto run(const View&... view) {
    return fem::ComputeTetStiffness{view...};
  }

  template <class T, class Real>
  static elasticity::TetStiffness<T> naive(index_t i, const auto& rest, const auto& svds, const auto& derivatives) {
    // Column c of a block is the force differential for a unit displacement c of one corner.
    const auto& shape = rest[i];
    const auto& svd = svds[i];
    const auto& x = derivatives[i];
    const Matrix3<T> U = svd.U.template cast<T>(), V = svd.V.template cast<T>();
    Eigen::Matrix<T, 3, 4> gradients;  // of the corners' shape functions
    gradients.template rightCols<3>() = shape.dm_inverse.template cast<T>().transpose();
    gradients.col(0) = -gradients.template rightCols<3>().rowwise().sum();
    Eigen::Matrix<T, 12, 12> K;
    for (int b = 0; b < 4; ++b) {
      for (int c = 0; c < 3; ++c) {
        const Matrix3<T> dF = Vector3<T>::Unit(c) * gradients.col(b).transpose();
        const Eigen::Matrix<T, 3, 4> force = -T(shape.volume) * formula::dp_from_df<T>(U, V, x, dF) * gradients;
        K.col(3 * b + c) = Eigen::Map<const Eigen::Matrix<T, 12, 1>>(force.data());
      }
    }
    elasticity::TetStiffness<T> stiffness;
    for (int a = 0; a < 4; ++a) stiffness.k[static_cast<std::size_t>(a)] = K.template block<3, 3>(3 * a, 3 * a);
    for (std::size_t e = 0; e < 6; ++e) {
      stiffness.e[e] = K.template block<3, 3>(3 * fem::tet_edges[e][0], 3 * fem::tet_edges[e][1]);
    }
    return stiffness;
  }
  template <class T>
  static Eigen::Matrix<T, 3, 30> observe(const auto& value) {
    Eigen::Matrix<T, 3, 30> all;
    for (std::size_t a = 0; a < 4; ++a) {
      all.template middleCols<3>(static_cast<int>(3 * a)) = value.k[a].template cast<T>();
    }
    for (std::size_t e = 0; e < 6; ++e) {
      all.template middleCols<3>(static_cast<int>(12 + 3 * e)) = value.e[e].template cast<T>();
    }
    return all;
  }
};

/// The diagonal block of each node: the sum of its corners' blocks over its tets.
struct NodeStiffness {
  static constexpr const char* name = "node_stiffness";
  static constexpr int place = 9;
  static constexpr Domain domain = Domain::nodes;
  using Output = elasticity::NodeStiffnessObject;
  using Reads = Operands<Gathered<source::Ranges<Domain::nodes, Domain::node_tets>, Aos>,
                         Gathered<source::Entries<Domain::node_tets>, Aos>, Streamed<OutputOf<TetStiffness>>>;
  using Writes = Operands<Streamed<source::Of<Output, domain>>>;
  template <class Real>
  static auto run(const auto& ranges, const auto& entries, const auto& tets, const auto& out) {
    return fem::GatherNodeStiffness{Rows{ranges, entries, tets.size()}, tets, out};
  }

  template <class T, class Real>
  static elasticity::NodeStiffness<T> naive(index_t i, const auto& ranges, const auto& entries, const auto& stiffness) {
    Matrix3<T> sum = Matrix3<T>::Zero();
    for (index_t k = ranges[i].begin; k < ranges[i].end; ++k) {
      sum += stiffness[entries[k].element].k[static_cast<std::size_t>(entries[k].local)].template cast<T>();
    }
    return {sum};
  }
  template <class T>
  static Matrix3<T> observe(const auto& value) {
    return Matrix3<T>(value.K.template cast<T>().template selfadjointView<Eigen::Lower>());  // what is stored
  }
};

/// The block of each edge: the sum over its tets.
struct EdgeStiffness {
  static constexpr const char* name = "edge_stiffness";
  static constexpr int place = 10;
  static constexpr Domain domain = Domain::edges;
  using Output = elasticity::EdgeStiffnessObject;
  using Reads = Operands<Gathered<source::Ranges<Domain::edges, Domain::edge_tets>, Aos>,
                         Gathered<source::Entries<Domain::edge_tets>, Aos>, Streamed<OutputOf<TetStiffness>>>;
  using Writes = Operands<Streamed<source::Of<Output, domain>>>;
  template <class Real>
  static auto run(const auto& ranges, const auto& entries, const auto& tets, const auto& out) {
    return fem::GatherEdgeStiffness{Rows{ranges, entries, tets.size()}, tets, out};
  }

  template <class T, class Real>
  static elasticity::EdgeStiffness<T> naive(index_t i, const auto& ranges, const auto& entries, const auto& stiffness) {
    Matrix3<T> sum = Matrix3<T>::Zero();
    for (index_t k = ranges[i].begin; k < ranges[i].end; ++k) {
      const auto local = static_cast<std::size_t>(entries[k].local);
      const Matrix3<T> block = stiffness[entries[k].element].e[local % 6].template cast<T>();
      sum += local < 6 ? block : Matrix3<T>(block.transpose());
    }
    return {sum};
  }
  template <class T>
  static Matrix3<T> observe(const auto& value) {
    return value.E.template cast<T>();
  }
};

PHYSGEN_BENCH_ROWS(TetStiffness, OnScene);
PHYSGEN_BENCH_ROWS(NodeStiffness, OnScene);
PHYSGEN_BENCH_ROWS(EdgeStiffness, OnScene);

}  // namespace physgen::bench
