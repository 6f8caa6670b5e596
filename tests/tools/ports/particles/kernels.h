// Density, forces and motion of smoothed particles (Mueller et al. 2003), as kernels.
#pragma once

#include <fluid.physgen.h>
#include <physgen/kernel.h>
#include <physgen/rows.h>

#include "setting.h"

namespace fluid {

using namespace physgen;
using namespace physgen::math;

/// Density by the kernel poly6, and the pressure that belongs to it.
template <class NeighbourRows, class ParticleView>
struct ComputeDensity {
  using Scalar = typename ParticleView::Precision;
  NeighbourRows neighbours;
  ParticleView particles;
  Water water;

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    using Number = lanes_t<std::int32_t, I>;
    using Vector = Eigen::Matrix<S, 3, 1>;
    const Vector x = particles[i].x();
    const S reach = S(water.reach), square = reach * reach;
    const S sum = neighbours.sum(i, S(0), [&](const auto& neighbour) -> S {
      const Number j = neighbour.j();
      const Vector d = x - particles[j].x().get();
      const S left = max(square - d.squaredNorm(), S(0));
      return left * left * left;
    });
    const S rho = S(water.mass * water.poly6) * sum;
    particles[i].rho() = rho;
    particles[i].p() = S(water.stiffness) * (rho - S(water.rest));
  }
};
template <class NeighbourRows, class ParticleView>
ComputeDensity(NeighbourRows, ParticleView, Water) -> ComputeDensity<NeighbourRows, ParticleView>;

/// Forces of pressure (the kernel spiky) and viscosity.
template <class NeighbourRows, class ParticleView>
struct ComputeForces {
  using Scalar = typename ParticleView::Precision;
  NeighbourRows neighbours;
  ParticleView particles;
  Water water;

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    using Number = lanes_t<std::int32_t, I>;
    using Vector = Eigen::Matrix<S, 3, 1>;
    const Vector x = particles[i].x(), v = particles[i].v();
    const S p = particles[i].p();
    particles[i].f() = neighbours.sum(i, Vector(Vector::Constant(S(0))), [&](const auto& neighbour) -> Vector {
      const Number j = neighbour.j();
      const Vector d = x - particles[j].x().get(), dv = particles[j].v().get() - v;
      const S rho = particles[j].rho(), other = particles[j].p();
      const S r = sqrt(max(d.squaredNorm(), S(1e-12F))), left = max(S(water.reach) - r, S(0));
      const S pressure = S(water.mass * water.spiky) * (p + other) / (S(2) * rho) * (left * left) / r;
      const S viscosity = S(water.viscosity * water.mass * water.laplacian) * left / rho;
      return d * pressure + dv * viscosity;
    });
  }
};
template <class NeighbourRows, class ParticleView>
ComputeForces(NeighbourRows, ParticleView, Water) -> ComputeForces<NeighbourRows, ParticleView>;

/// A step of symplectic Euler in a box, whose walls turn velocities and halve them.
template <class ParticleView>
struct Move {
  using Scalar = typename ParticleView::Precision;
  ParticleView particles;
  Water water;

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    using Vector = Eigen::Matrix<S, 3, 1>;
    Vector x = particles[i].x(), v = particles[i].v();
    const Vector f = particles[i].f();
    const S rho = particles[i].rho(), side = S(water.side), step = S(water.step);
    for (int k = 0; k < 3; ++k) {
      v[k] += step * (f[k] / rho + S(k == 2 ? water.gravity : 0.0F));
      x[k] += step * v[k];
      const auto below = x[k]<S(0), above = x[k]> side;
      v[k] = select(below || above, S(-0.5F) * v[k], v[k]);
      x[k] = select(below, -x[k], select(above, S(2) * side - x[k], x[k]));
    }
    particles[i].v() = v;
    particles[i].x() = x;
  }
};
template <class ParticleView>
Move(ParticleView, Water) -> Move<ParticleView>;

}  // namespace fluid
