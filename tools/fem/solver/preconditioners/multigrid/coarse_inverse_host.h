// The coarsest inverse on the CPU.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/solver/performs_in.h>
#include <fem/solver/preconditioners/multigrid/coarse_inverse.h>
#include <physgen/executor.h>

#include <Eigen/Cholesky>

namespace physgen::fem {

namespace detail {

template <class Stiffness, class InverseView>
void invert_dense(const InvertStiffness<Stiffness, InverseView>& of) {
  using Real = typename InverseView::Precision;
  const auto& [stiffness, inverse] = of;
  const index_t n = stiffness.nodes.size();
  using Dense = Eigen::MatrixXd;
  Dense A = Dense::Zero(3 * n, 3 * n);
  const auto put = [&](index_t i, index_t j, const auto& block) {
    A.block<3, 3>(3 * i, 3 * j) = block.template cast<double>();
  };
  for (index_t i = 0; i < n; ++i) stiffness.put_node(i, put);
  for (index_t e = 0; e < stiffness.edges.size(); ++e) stiffness.put_edge(e, put);
  const Eigen::LDLT<Dense> factors(A);
  Dense G = factors.matrixL().solve(Dense(factors.transpositionsP() * Dense::Identity(3 * n, 3 * n)));
  for (index_t k = 0; k < 3 * n; ++k) {
    const double pivot = factors.vectorD()[k];
    G.row(k) *= pivot > double{least_coarse_pivot<Real>} ? 1 / pivot : 0;
  }
  G = factors.transpositionsP().transpose() * Dense(factors.matrixU().solve(G));
  for (index_t i = 0; i < n; ++i) {
    for (index_t j = 0; j < n; ++j) {
      inverse[i * n + j].G() = Eigen::Matrix<Real, 3, 3>(G.block<3, 3>(3 * i, 3 * j).template cast<Real>());
    }
  }
}

}  // namespace detail

/// Makes the inverse of the scaled stiffness over its free components. @pre the level has its scales
template <PerformsIn<Host> On, class Level>
void invert_coarsest(On& on, Level& level) {
  if (level.coarse_inverse.size() == 0) return;
  perform_in_place_of(on, level.nodes(), detail::inverse_of(level),
                      [&](Stream /*stream*/) { detail::invert_dense(detail::inverse_of(level)); });
}

}  // namespace physgen::fem

#pragma pop_macro("I")
