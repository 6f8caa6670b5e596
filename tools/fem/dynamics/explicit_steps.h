// Explicit dynamics as a program over an executor and arrays by name: symplectic Euler with lumped mass. The forces at
// the displacements that are known give new velocities, and these give new displacements.
#pragma once

#include <elasticity.physgen.h>
#include <fem/kernels/compute_svd.h>
#include <fem/kernels/displaced_gradient.h>
#include <fem/kernels/elastic_force.h>
#include <fem/kernels/stress.h>
#include <fem/numerics/scalar.h>
#include <fem/solver/time_step.h>
#include <physgen/fuse.h>
#include <physgen/reduce.h>
#include <physgen/rows.h>

namespace physgen::fem {

/// v += dt f / m and u += dt v in free components, f being elastic and external forces; damping is taken at the new
/// velocity, so that any is stable. Prescribed components go where the load takes them, at the velocity that leads
/// there.
template <class ForceView, class LoadView, class MassView, class ConstraintView, class MotionView, class VelocityView,
          class DisplacementView, class RoundedView>
struct MoveNodes {
  using Scalar = double;
  TimeStep step;
  ForceView forces;                ///< elasticity::NodeForce: of the tets
  LoadView loads;                  ///< elasticity::NodeForce: external, at a load of 1
  MassView masses;                 ///< dynamics::NodeMass
  ConstraintView constraints;      ///< quasistatic::NodeConstraint
  MotionView motion;               ///< elasticity::NodeDisplacement: of prescribed components, at a load of 1
  VelocityView velocities;         ///< dynamics::NodeVelocity
  DisplacementView displacements;  ///< elasticity::NodeDisplacement: u, from rest
  RoundedView rounded;             ///< elasticity::NodeDisplacement: u in the precision of tets, written

  PHYSGEN_FUNCTION void operator()(index_t node) const {
    using Vector = Eigen::Matrix<double, 3, 1>;
    using Real = typename RoundedView::Precision;
    const int fixed = constraints[node].fixed();
    const double mass = masses[node].mass();
    const Vector external = loads[node].f(), path = motion[node].dx();
    Vector v = velocities[node].v(), u = displacements[node].dx();
    for (int k = 0; k < 3; ++k) {
      if ((fixed >> k & 1) != 0) {
        const double target = path[k] * step.load;
        v[k] = (target - u[k]) / step.length;
        u[k] = target;
      } else if (mass > 0) {
        const double force = double(forces[node].f()[k]) + external[k] * step.load;
        v[k] = (v[k] + step.length * (force / mass)) / (1 + step.length * step.damping);
        u[k] += step.length * v[k];
      }
    }
    velocities[node].v() = v;
    displacements[node].dx() = u;
    for (int k = 0; k < 3; ++k) rounded[node].dx()[k] = static_cast<Real>(u[k]);
  }
};
template <class... Views>
MoveNodes(TimeStep, Views...) -> MoveNodes<Views...>;

/// Elastic energy of a tet [J].
template <class Material, class RestView, class SvdView>
struct StretchEnergy {
  using Scalar = typename SvdView::Precision;
  Material material;      ///< in Scalar
  RestView rest;          ///< elasticity::RestShape
  SvdView decomposition;  ///< elasticity::DeformationSvd, of which s is read

  template <class I>
  PHYSGEN_FUNCTION auto operator()(I i) const -> lanes_t<Scalar, I> {
    using S = lanes_t<Scalar, I>;
    const Vector3<S> s = decomposition[i].s();
    return S(rest[i].volume()) * material.energy(s);
  }
};
template <class... Arguments>
StretchEnergy(Arguments...) -> StretchEnergy<Arguments...>;

template <class MotionView>
struct StoreElastic {
  MotionView motion;  ///< dynamics::Motion
  PHYSGEN_FUNCTION void operator()(double energy) const { motion[index_t{0}].elastic() = energy; }
};
template <class View>
StoreElastic(View) -> StoreElastic<View>;

/// First Piola-Kirchhoff stress of all tets.
/// @param body arrays by the names of the scene explicit_dynamics
/// @param stresses an array of elasticity::Stress, one per tet
template <class On, class Body, class Material, class Stresses>
void compute_stresses(On& on, Body& body, const Material& material, Stresses& stresses) {
  using Real = typename Material::Scalar;
  const auto F = local<elasticity::DeformationGradientObject, Real>();
  const auto svd = local<elasticity::DeformationSvdObject, Real>();
  on.run(body.tets.size(),
         fuse(locals(F, svd),
              ComputeDisplacedGradient{body.tets.const_view(), body.rounded.const_view(), body.rest.const_view(), F},
              ComputeSvd{F, svd}, ComputeStress{material, svd, stresses.view()}));
}

/// Elastic forces on all nodes: what the tets' kernels hand on to each other is in no array.
template <class On, class Body, class Material>
void compute_forces(On& on, Body& body, const Material& material) {
  using Real = typename Material::Scalar;
  const auto F = local<elasticity::DeformationGradientObject, Real>();
  const auto svd = local<elasticity::DeformationSvdObject, Real>();
  const auto stress = local<elasticity::StressObject, Real>();
  const auto rest = body.rest.const_view();
  on.run(body.tets.size(),
         fuse(locals(F, svd, stress),
              ComputeDisplacedGradient{body.tets.const_view(), body.rounded.const_view(), rest, F}, ComputeSvd{F, svd},
              ComputeStress{material, svd, stress}, ComputeCornerForces{rest, stress, body.corners.view()}));
  on.run(body.velocities.size(),
         GatherForces{Rows(body.node_tet_ranges.const_view(), body.node_tets.const_view(), body.tets.size()),
                      body.corners.const_view(), body.forces.view()});
}

/// Leaves the energies and the momentum of a body in body.measured.
template <class On, class Body, class Material>
void measure_explicit_motion(On& on, Body& body, const Material& material) {
  on.reduce(body.velocities.size(), NodeMotion{body.masses.const_view(), body.velocities.const_view()}, Sum{},
            StoreMotion{body.measured.view()});
  using Real = typename Material::Scalar;
  const auto F = local<elasticity::DeformationGradientObject, Real>();
  const auto svd = local<elasticity::DeformationSvdObject, Real>();
  const auto rest = body.rest.const_view();
  on.reduce(body.tets.size(),
            fuse(locals(F, svd), ComputeDisplacedGradient{body.tets.const_view(), body.rounded.const_view(), rest, F},
                 ComputeSvd{F, svd}, StretchEnergy{material, rest, svd}),
            Sum{}, StoreElastic{body.measured.view()});
}

/// One time step.
/// @param material in the precision of the tets' arrays
template <class On, class Body, class Material>
void explicit_step(On& on, Body& body, const Material& material, const TimeStep& step) {
  compute_forces(on, body, material);
  on.run(body.velocities.size(),
         MoveNodes{step, body.forces.const_view(), body.loads.const_view(), body.masses.const_view(),
                   body.constraints.const_view(), body.motion.const_view(), body.velocities.view(),
                   body.displacements.view(), body.rounded.view()});
}

}  // namespace physgen::fem
