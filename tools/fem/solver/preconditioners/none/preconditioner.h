// No preconditioner.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/solver/levels/preconditioner.h>
#include <fem/solver/levels/scaled_blocks.h>

namespace physgen::fem {

/// z = r.
template <class ResidualView, class CorrectionView>
struct CopyResidual {
  using Scalar = typename CorrectionView::Precision;
  ResidualView residual;       ///< elasticity::NodeForceDifferential
  CorrectionView corrections;  ///< elasticity::NodeDisplacement, written

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    corrections[i].dx() = residual[i].df().get();
  }
};

struct NoPreconditioner : WithoutArrays {
  template <class On, class Levels>
  static void prepare(On& on, Levels& levels, std::size_t top, const PreconditionerSettings& /*settings*/,
                      bool /*fresh*/) {
    scale_nodes(on, *levels[top], true);
  }
  template <class On, class Levels>
  static void apply(On& on, Levels& levels, std::size_t top, const PreconditionerSettings& /*settings*/) {
    apply(on, *levels[top]);
  }
  template <class On, class Level>
  static void apply(On& on, Level& level) {
    on.run(level.scales.size(), CopyResidual{level.residual.const_view(), level.correction.view()});
  }
};

}  // namespace physgen::fem

#pragma pop_macro("I")
