// The preconditioner multigrid: one V-cycle over Galerkin levels, smoothed by Chebyshev polynomials of block Jacobi.
#pragma once

#include <fem/solver/levels/preconditioner.h>
#include <fem/solver/preconditioners/multigrid/multigrid.h>
#ifdef __CUDACC__
#include <fem/solver/preconditioners/multigrid/coarse_inverse_cuda.h>
#include <fem/solver/preconditioners/multigrid/scaled_product_cuda.h>
#include <fem/solver/preconditioners/multigrid/small_levels_cuda.h>
#else
#include <fem/solver/preconditioners/multigrid/coarse_inverse_host.h>
#endif

namespace physgen::fem {

struct Multigrid : WithoutArrays {
  template <class On, class Levels>
  static void prepare(On& on, Levels& levels, std::size_t top, const PreconditionerSettings& settings, bool fresh) {
    prepare_level(on, *levels[top], settings, fresh);
    for (std::size_t l = top; l + 1 < levels.size(); ++l) {
      auto& fine = *levels[l];
      auto& coarse = *levels[l + 1];
      coarsen_stiffness(on, fine, coarse);
      prepare_level(on, coarse, settings, fresh);
    }
    invert_coarsest(on, *levels.back());
  }
  template <class On, class Levels>
  static void apply(On& on, Levels& levels, std::size_t top, const PreconditionerSettings& settings) {
    using Level = std::remove_cvref_t<decltype(*levels[top])>;
    if constexpr (Level::Choices::assembled) v_cycle(on, levels, top, settings);
  }
};

}  // namespace physgen::fem
