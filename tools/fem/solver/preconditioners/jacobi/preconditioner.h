// The preconditioner block Jacobi: the inverses of the nodes' blocks.
#pragma once

#include <fem/solver/levels/preconditioner.h>
#include <fem/solver/levels/scaled_blocks.h>
#include <fem/solver/preconditioners/jacobi/block_jacobi.h>

namespace physgen::fem {

struct BlockJacobi : WithoutArrays {
  template <class On, class Levels>
  static void prepare(On& on, Levels& levels, std::size_t top, const PreconditionerSettings& /*settings*/,
                      bool /*fresh*/) {
    scale_nodes(on, *levels[top], false);
  }
  template <class On, class Levels>
  static void apply(On& on, Levels& levels, std::size_t top, const PreconditionerSettings& /*settings*/) {
    apply(on, *levels[top]);
  }
  template <class On, class Level>
  static void apply(On& on, Level& level) {
    on.run(level.scales.size(),
           ApplyBlockJacobi{level.inverse.const_view(), level.residual.const_view(), level.correction.view()});
  }
};

}  // namespace physgen::fem
