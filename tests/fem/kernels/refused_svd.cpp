// Calls of svd() that a compiler must refuse, with words that say what is wrong. refused.py compares them with what it
// reports.
#include <elasticity.physgen.h>
#include <fem/kernels/svd_arrays.h>
#include <physgen/parallel_for.h>

using namespace physgen;

using Gradients = elasticity::DeformationGradientArray<float>;
using Rotations = elasticity::ElementRotationArray<float>;
using Stretches = elasticity::PrincipalStretchesArray<float>;

/// refused rotations_of_another_precision: all arrays have the space and the precision of F
void rotations_of_another_precision(const Gradients& F, elasticity::ElementRotationArray<double>& U, Stretches& s) {
  fem::svd(F, U, s, fem::skip);
}
/// refused stretches_of_another_precision: all arrays have the space and the precision of F
void stretches_of_another_precision(const Gradients& F, elasticity::PrincipalStretchesArray<double>& s) {
  fem::svd(F, fem::skip, s, fem::skip);
}
/// refused rotations_in_another_space: all arrays have the space and the precision of F
void rotations_in_another_space(const Gradients& F, elasticity::ElementRotationArray<float, PinnedHost>& V) {
  fem::svd(F, fem::skip, fem::skip, V);
}
/// refused no_sweeps: svd<kSweeps>() needs at least one sweep
void no_sweeps(const Eigen::Matrix3f& A) { (void)fem::svd<0>(A); }

// ---- What is not refused ----
void accepted(const Gradients& F, Rotations& U, Stretches& s) { fem::svd(F, U, s, fem::skip); }
