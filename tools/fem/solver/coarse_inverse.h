// The coarsest level, solved exactly: the product with a dense inverse, which product_host.h and product_cuda.h form
// once per tangent.
#pragma once

#include <fem/numerics/scalar.h>
#include <physgen/kernel.h>

namespace physgen::fem {

/// z of node i = sum over nodes j of G_ij r_j.
template <class InverseView, class ResidualView, class CorrectionView>
struct ApplyCoarseInverse {
  using Scalar = typename CorrectionView::Precision;
  index_t nodes;
  InverseView inverse;         ///< quasistatic::CoarseInverse
  ResidualView residual;       ///< elasticity::NodeForceDifferential
  CorrectionView corrections;  ///< elasticity::NodeDisplacement, written

  PHYSGEN_FUNCTION void operator()(index_t i) const {
    Vector3<Scalar> sum = Vector3<Scalar>::Zero();
    for (index_t j = 0; j < nodes; ++j) {
      const Matrix3<Scalar> G = inverse[i * nodes + j].G();
      const Vector3<Scalar> r = residual[j].df();
      sum = multiply_add<Scalar>(G, r, sum);
    }
    corrections[i].dx() = sum;
  }
};
template <class... Views>
ApplyCoarseInverse(index_t, Views...) -> ApplyCoarseInverse<Views...>;

/// z of the coarsest level from its r.
template <class On, class Level>
void apply_coarsest(On& on, Level& level) {
  on.run(level.nodes(), ApplyCoarseInverse{level.nodes(), level.coarse_inverse.const_view(),
                                           level.residual.const_view(), level.correction.view()});
}

}  // namespace physgen::fem
