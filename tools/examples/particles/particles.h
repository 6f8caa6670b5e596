// Smoothed particles in a box (Mueller et al. 2003): neighbours, density, forces and motion; in a .cu file, on a GPU.
#pragma once
#include <fluid.physgen.h>
#include <physgen/kernel.h>
#ifdef __CUDACC__
#include <physgen/cuda/cell_list.h>
#define ON_DEVICE __device__
#else
#include <physgen/cell_list.h>
#include <physgen/parallel_for.h>
#define ON_DEVICE
#endif
namespace fluid {
using namespace physgen;
using namespace physgen::math;
#ifdef __CUDACC__
using Space = Cuda;  // where particles lie, and kernels run: one by one here, and in packs on the host
void run(index_t count, const auto& kernel) { parallel_for(Cuda{}, count, kernel); }
#else
using Space = Host;
void run(index_t count, const auto& kernel) { parallel_for(Host{}, count, over<float>(kernel)); }
#endif
struct Water {  // in units of SI
  float reach = 0.038F, mass = 0.008F, rest = 1000, stiffness = 400, viscosity = 2, gravity = -9.81F, step = 4e-4F;
  float poly6 = 315 / (64 * 3.14159265F * std::pow(reach, 9.0F)), spiky = 45 / (3.14159265F * std::pow(reach, 6.0F));
  std::array<float, 3> box{0.64F, 0.32F, 0.64F};  ///< from (0, 0, 0) on
};
struct Fluid {
  ParticleArray<float, Space> particles;
  Water w{};
  CellList<float, 3, Space> cells{{.lower = {0, 0, 0}, .upper = w.box, .periodic = {}}, w.reach};
  RowArrays<RangeArray<float, Space>, NeighbourArray<float, Space>> neighbours{};
  void find_neighbours(bool sort) {  // by the cells of the last step
    if (sort && cells.size() > 0) permute(particles, cells.order());
    cells.build(Space{}, particles.size(), [p = particles.view()] ON_DEVICE(index_t i) { return p[i].x().get(); });
    cells.find_neighbours(neighbours, OwnEntry::included);
  }
  void move() {
    // Density and pressure.
    run(particles.size(), [w = w, rows = neighbours.const_view(), all = particles.view()] ON_DEVICE(auto i) {
      const auto x = all[i].x().get();
      const auto sum = rows.sum(i, lanes_t<float, decltype(i)>(0), [&](const auto& entry) {
        const auto left = max(w.reach * w.reach - (x - all[entry.j()].x().get()).squaredNorm(), 0);
        return left * left * left;
      });
      all[i].rho() = w.mass * w.poly6 * sum;
      all[i].p() = max(w.stiffness * (w.mass * w.poly6 * sum - w.rest), 0);
    });
    // Forces of pressure and viscosity.
    run(particles.size(), [w = w, rows = neighbours.const_view(), all = particles.view()] ON_DEVICE(auto i) {
      using Vector = Eigen::Matrix<lanes_t<float, decltype(i)>, 3, 1>;
      const auto one = all.get(i);
      all[i].f() = rows.sum(i, Vector(Vector::Zero()), [&](const auto& entry) -> Vector {
        const auto other = all.get(entry.j());
        const auto d = one.x - other.x;
        const auto r = sqrt(max(d.squaredNorm(), 1e-12F)), left = max(w.reach - r, 0);
        const auto factor = w.mass * w.spiky * left / other.rho;
        return d * (factor * left * (one.p + other.p) / (2.0F * r)) + (other.v - one.v) * (w.viscosity * factor);
      });
    });
    // Motion; walls turn velocities and halve them.
    run(particles.size(), [w = w, all = particles.view()] ON_DEVICE(auto i) {
      auto one = all.get(i);
      for (int k = 0; k < 3; ++k) {
        one.v[k] += w.step * (one.f[k] / one.rho + (k == 2 ? w.gravity : 0.0F));
        one.x[k] += w.step * one.v[k];
        const auto below = one.x[k]<0.0F, above = one.x[k]> w.box[k];
        one.v[k] = select(below || above, -0.5F * one.v[k], one.v[k]);
        one.x[k] = select(below, -one.x[k], select(above, 2.0F * w.box[k] - one.x[k], one.x[k]));
      }
      all.put(i, one);
    });
  }
};
}  // namespace fluid
