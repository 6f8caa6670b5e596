// Kernels that follow each other over the tets, each group as one kernel: what one of them computes for the next is not
// stored.
#pragma once

#include <elasticity.physgen.h>
#include <fem/kernels/compute_svd.h>
#include <fem/kernels/deformation_gradient.h>
#include <fem/kernels/displaced_gradient.h>
#include <fem/kernels/elastic_force.h>
#include <fem/kernels/force_differential.h>
#include <fem/kernels/keep_directions.h>
#include <fem/kernels/load_first.h>
#include <fem/kernels/node_sums.h>
#include <fem/kernels/stress.h>
#include <fem/kernels/stress_derivative.h>
#include <physgen/fuse.h>

namespace physgen::fem {

// Groups that begin at nodes take views of elasticity::NodePosition, or of elasticity::NodeDisplacement from rest: near
// rest F - 1 then keeps its digits in float.
template <class TetView, class Real, class Layout, class Formats, class Space, class RestView, class GradientView>
[[nodiscard]] auto gradient_step(const TetView& tets,
                                 const View<elasticity::NodePositionObject, Real, Layout, Formats, Space>& nodes,
                                 const RestView& rest, const GradientView& gradients) {
  return ComputeDeformationGradient{tets, nodes, rest, gradients};
}
template <class TetView, class Real, class Layout, class Formats, class Space, class RestView, class GradientView>
[[nodiscard]] auto gradient_step(const TetView& tets,
                                 const View<elasticity::NodeDisplacementObject, Real, Layout, Formats, Space>& nodes,
                                 const RestView& rest, const GradientView& gradients) {
  return ComputeDisplacedGradient{tets, nodes, rest, gradients};
}

/// From positions to the forces on nodes, which are set to zero before (ClearNodes); the order of sums is open.
/// @param tets elasticity::Tet @param positions elasticity::NodePosition @param rest elasticity::RestShape
/// @param nodes elasticity::NodeForce, added to
template <class Model, class TetView, class PositionView, class RestView, class NodeView>
[[nodiscard]] auto fuse_added_forces(const Model& material, const TetView& tets, const PositionView& positions,
                                     const RestView& rest, const NodeView& nodes) {
  using Real = typename RestView::Precision;
  constexpr auto F = local<elasticity::DeformationGradientObject, Real>();
  constexpr auto svd = local<elasticity::DeformationSvdObject, Real>();
  constexpr auto P = local<elasticity::StressObject, Real>();
  constexpr auto G = local<elasticity::CornerForcesObject, Real>();
  return fuse(locals(F, svd, P, G), gradient_step(tets, positions, rest, F), ComputeSvd{F, svd},
              ComputeStress{material, svd, P}, ComputeCornerForces{rest, P, G}, AddCornerForces{tets, G, nodes});
}

/// From positions to the forces of tets on their corners, in the rows of nodes; SumRowForces sums them.
/// @param places elasticity::TetPlaces @param placed elasticity::PlacedForce, written
template <class Model, class TetView, class PositionView, class RestView, class PlaceView, class PlacedView>
[[nodiscard]] auto fuse_placed_forces(const Model& material, const TetView& tets, const PositionView& positions,
                                      const RestView& rest, const PlaceView& places, const PlacedView& placed) {
  using Real = typename RestView::Precision;
  constexpr auto F = local<elasticity::DeformationGradientObject, Real>();
  constexpr auto svd = local<elasticity::DeformationSvdObject, Real>();
  constexpr auto P = local<elasticity::StressObject, Real>();
  constexpr auto G = local<elasticity::CornerForcesObject, Real>();
  constexpr auto loaded = local<elasticity::TetPlacesObject, Real>();
  return fuse(locals(F, svd, P, G, loaded), LoadPlaces{places, loaded}, gradient_step(tets, positions, rest, F),
              ComputeSvd{F, svd}, ComputeStress{material, svd, P}, ComputeCornerForces{rest, P, G},
              ScatterCornerForces{loaded, G, placed});
}

/// From positions to the forces of tets on their corners, which GatherForces sums: on a CPU, where atomic sums take
/// longer than the SVD, faster than the other two.
/// @param corners elasticity::CornerForces, written
template <class Model, class TetView, class PositionView, class RestView, class CornerView>
[[nodiscard]] auto fuse_corner_forces(const Model& material, const TetView& tets, const PositionView& positions,
                                      const RestView& rest, const CornerView& corners) {
  using Real = typename RestView::Precision;
  constexpr auto F = local<elasticity::DeformationGradientObject, Real>();
  constexpr auto svd = local<elasticity::DeformationSvdObject, Real>();
  constexpr auto P = local<elasticity::StressObject, Real>();
  return fuse(locals(F, svd, P), gradient_step(tets, positions, rest, F), ComputeSvd{F, svd},
              ComputeStress{material, svd, P}, ComputeCornerForces{rest, P, corners});
}

/// Computes what a step of Newton's method needs of positions: corner forces, and for the force differential the
/// principal directions and the derivative without negative eigenvalues.
/// @param directions elasticity::PrincipalDirections, written @param derivatives elasticity::StressDerivative, written
/// @param corners elasticity::CornerForces, written
template <class Model, class TetView, class PositionView, class RestView, class DirectionView, class DerivativeView,
          class CornerView>
[[nodiscard]] auto fuse_newton_update(const Model& material, const TetView& tets, const PositionView& positions,
                                      const RestView& rest, const DirectionView& directions,
                                      const DerivativeView& derivatives, const CornerView& corners) {
  using Real = typename RestView::Precision;
  constexpr auto F = local<elasticity::DeformationGradientObject, Real>();
  constexpr auto svd = local<elasticity::DeformationSvdObject, Real>();
  constexpr auto P = local<elasticity::StressObject, Real>();
  constexpr auto shapes = local<elasticity::RestShapeObject, Real>();
  return fuse(locals(F, svd, P, shapes), LoadShapes{rest, shapes}, gradient_step(tets, positions, shapes, F),
              ComputeSvd{F, svd}, ComputeStress{material, svd, P}, ComputeCornerForces{shapes, P, corners},
              KeepDirections{svd, directions}, ComputeStressDerivative{material, svd, derivatives, ClampEigenvalues{}});
}

/// The force differential of nodes, matrix-free; they are set to zero before (ClearNodes), the order of sums is open.
/// @param displacements elasticity::NodeDisplacement @param directions elasticity::PrincipalDirections or
/// elasticity::DeformationSvd @param nodes elasticity::NodeForceDifferential, added to
template <class TetView, class DisplacementView, class RestView, class DirectionView, class DerivativeView,
          class NodeView>
[[nodiscard]] auto fuse_added_differentials(const TetView& tets, const DisplacementView& displacements,
                                            const RestView& rest, const DirectionView& directions,
                                            const DerivativeView& derivatives, const NodeView& nodes) {
  using Real = typename RestView::Precision;
  constexpr auto G = local<elasticity::CornerForcesObject, Real>();
  return fuse(locals(G), ComputeCornerForceDifferentials{tets, displacements, rest, directions, derivatives, G},
              AddCornerForceDifferentials{tets, G, nodes});
}

}  // namespace physgen::fem
