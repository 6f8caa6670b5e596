// Smoothed particles in a box (Mueller et al. 2003): who is whose neighbour, density, forces, motion.
#pragma once
#include <fluid.physgen.h>
#ifdef __CUDACC__
#include <physgen/cuda/cell_list.h>
#else
#include <physgen/cell_list.h>
#include <physgen/parallel_for.h>
#endif
#include <physgen/kernel.h>
namespace fluid {
using namespace physgen;
using namespace physgen::math;
struct Water {  // in units of SI
  float reach = 0.038F, mass = 0.008F, rest = 1000, stiffness = 400, viscosity = 2, gravity = -9.81F, step = 4e-4F;
  float poly6 = 315.0F / (64.0F * 3.14159265F * std::pow(reach, 9.0F));
  float spiky = 45.0F / (3.14159265F * std::pow(reach, 6.0F));
  std::array<float, 3> box{0.64F, 0.32F, 0.64F};  ///< from (0, 0, 0) on
};
template <class Rows, class View>
struct ComputeDensity {
  using Scalar = float;
  Water w;
  Rows rows;
  View all;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<float, I>;
    const Eigen::Matrix<S, 3, 1> x = all[i].x();
    const S sum = rows.sum(i, S(0), [&](const auto& entry) -> S {
      const S left = max(S(w.reach * w.reach) - (x - all[entry.j()].x().get()).squaredNorm(), S(0));
      return left * left * left;
    });
    const S rho = S(w.mass * w.poly6) * sum;
    all[i].rho() = rho;
    all[i].p() = max(S(w.stiffness) * (rho - S(w.rest)), S(0));
  }
};
template <class Rows, class View>
struct ComputeForces {
  using Scalar = float;
  Water w;
  Rows rows;
  View all;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<float, I>;
    using Vector = Eigen::Matrix<S, 3, 1>;
    const Vector x = all[i].x(), v = all[i].v();
    const S p = all[i].p();
    all[i].f() = rows.sum(i, Vector(Vector::Constant(S(0))), [&](const auto& entry) -> Vector {
      const auto other = all[entry.j()];
      const Vector d = x - other.x().get(), dv = other.v().get() - v;
      const S rho = other.rho(), q = other.p(), r = sqrt(max(d.squaredNorm(), S(1e-12F)));
      const S left = max(S(w.reach) - r, S(0)), factor = S(w.mass * w.spiky) * left / rho;
      return d * S(factor * left * (p + q) / (S(2) * r)) + dv * S(S(w.viscosity) * factor);
    });
  }
};
template <class View>
struct Move {  // walls turn velocities and halve them
  using Scalar = float;
  Water w;
  View all;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<float, I>;
    Eigen::Matrix<S, 3, 1> x = all[i].x(), v = all[i].v();
    const Eigen::Matrix<S, 3, 1> f = all[i].f();
    const S rho = all[i].rho();
    for (int k = 0; k < 3; ++k) {
      const S side = S(w.box[static_cast<std::size_t>(k)]);
      v[k] += S(w.step) * (f[k] / rho + S(k == 2 ? w.gravity : 0.0F));
      x[k] += S(w.step) * v[k];
      const auto below = x[k]<S(0), above = x[k]> side;
      v[k] = select(below || above, S(-0.5F) * v[k], v[k]);
      x[k] = select(below, -x[k], select(above, S(2) * side - x[k], x[k]));
    }
    all[i].v() = v;
    all[i].x() = x;
  }
};
template <class View>
struct PositionOf {
  View all;
  PHYSGEN_FUNCTION auto operator()(index_t i) const { return all[i].x().get(); }
};
template <class Space = Host>  // or Cuda: where particles lie and kernels run
struct Fluid {
  ParticleArray<float, Space> particles;
  Water w{};
  CellList<float, 3, Space> cells{{.lower = {0, 0, 0}, .upper = w.box, .periodic = {}}, w.reach};
  RowArrays<RangeArray<float, Space>, NeighbourArray<float, Space>> neighbours{};
  void find_neighbours(bool sort) {  // by the cells of the last step
    if (sort && cells.size() > 0) permute(particles, cells.order());
    cells.build(Space{}, particles.size(), PositionOf{particles.const_view()});
    cells.find_neighbours(neighbours, OwnEntry::included);
  }
  void move() {
    const auto rows = neighbours.const_view();
    const auto all = particles.view();
    parallel_for(Space{}, particles.size(), ComputeDensity{w, rows, all});
    parallel_for(Space{}, particles.size(), ComputeForces{w, rows, all});
    parallel_for(Space{}, particles.size(), Move{w, all});
  }
};
}  // namespace fluid
