// Kernels of finite elements of the project.
#pragma once

#include <elasticity.physgen.h>
#include <fem/kernels/compute_svd.h>
#include <fem/kernels/deformation_gradient.h>
#include <fem/kernels/elastic_force.h>
#include <fem/kernels/force_differential.h>
#include <fem/kernels/stress_differential.h>

#include "bench.h"

namespace physgen::lane_kernels {

/// A struct, read as a reference to an object is. PHYSGEN_VALUE is undefined below.
template <class Real>
struct Derivatives {
  const elasticity::StressDerivative<Real>& values;
#define PHYSGEN_VALUE(name) \
  Real name() const { return values.name; }
  PHYSGEN_VALUE(x1111)
  PHYSGEN_VALUE(x2211)
  PHYSGEN_VALUE(x3311)
  PHYSGEN_VALUE(x2222)
  PHYSGEN_VALUE(x3322)
  PHYSGEN_VALUE(x3333)
  PHYSGEN_VALUE(x2121)
  PHYSGEN_VALUE(x2112)
  PHYSGEN_VALUE(x3131)
  PHYSGEN_VALUE(x3113)
  PHYSGEN_VALUE(x3232)
  PHYSGEN_VALUE(x3223)
#undef PHYSGEN_VALUE
};

template <class Real>
void measure_tets(const Bench& bench) {
  using namespace elasticity;
  constexpr int side = 40, points = side + 1;
  const index_t nodes = points * points * points, n = 5 * side * side * side;
  std::mt19937 random(5);
  TetArray<Real> tets(n);
  NodePositionArray<Real> positions(nodes);
  NodeForceArray<Real> forces(nodes);
  RestShapeArray<Real> rest(n);
  DeformationGradientArray<Real> F(n);
  DeformationGradientDifferentialArray<Real> dF(n);
  DeformationSvdArray<Real> svd(n);
  StressDerivativeArray<Real> derivative(n);
  StressDifferentialArray<Real> dP(n);
  StressArray<Real> P(n);
  CornerForcesArray<Real> G(n);
  NodeDisplacementArray<Real> dx(nodes);
  randomise(positions, random);
  randomise(rest, random);
  randomise(dF, random);
  randomise(F, random);
  randomise(svd, random);
  randomise(derivative, random);
  randomise(P, random);
  randomise(G, random);
  randomise(dx, random);
  constexpr int corner[5][4] = {{0, 1, 2, 4}, {3, 1, 2, 7}, {5, 1, 4, 7}, {6, 2, 4, 7}, {1, 2, 4, 7}};
  for (index_t e = 0; e < n; ++e) {
    const index_t cell = e / 5, x = cell % side, y = cell / side % side, z = cell / side / side;
    for (int c = 0; c < 4; ++c) {
      const int k = corner[e % 5][c];
      tets.view()[e].nodes()[c] =
          static_cast<std::int32_t>(x + k % 2 + points * (y + k / 2 % 2 + points * (z + k / 4)));
    }
  }
  const auto t = structs(tets);
  const auto x = structs(positions);
  const auto r = structs(rest);
  auto gradients = structs(F);
  auto decomposed = structs(svd);
  const auto changes = structs(dF);
  const auto derivatives = structs(derivative);
  auto stress_changes = structs(dP);
  const auto stresses = structs(P);
  auto corner_forces = structs(G);
  const auto displacements = structs(dx);
  auto sums = structs(forces);
  const auto edges = [&](std::size_t i, const auto& of) {
    Eigen::Matrix<Real, 3, 3> ds;
    const Vector3<Real> origin = of(u(t[i].nodes[0]));
    for (int c = 1; c < 4; ++c) ds.col(c - 1) = of(u(t[i].nodes[c])) - origin;
    return ds;
  };
  using M = Eigen::Matrix<Real, 3, 3>;
  bench.row<Real>(
      "dP from dF", n,
      fem::ComputeStressDifferential{svd.const_view(), derivative.const_view(), dF.const_view(), dP.view()},
      [&] {
        for (std::size_t i = 0; i < t.size(); ++i) {
          const M U = decomposed[i].U, V = decomposed[i].V;
          stress_changes[i].dP =
              fem::detail::stress_differential<Real>(U, V, Derivatives<Real>{derivatives[i]}, M(changes[i].dF));
        }
      },
      [&] { return bits(dP); });
  bench.row<Real>(
      "SVD", n / 4, fem::ComputeSvd{F.const_view(), svd.view()},
      [&] {
        for (std::size_t i = 0; i < t.size() / 4; ++i) {
          const auto result = fem::svd(M(gradients[i].F));
          decomposed[i] = {result.U, result.V, result.s};
        }
      },
      [&] { return bits(svd); });
  bench.row<Real>(
      "corner forces", n, fem::ComputeCornerForces{rest.const_view(), P.const_view(), G.view()},
      [&] {
        for (std::size_t i = 0; i < t.size(); ++i)
          corner_forces[i].G = fem::detail::corner_forces<Real>(M(stresses[i].P), M(r[i].dm_inverse), r[i].volume);
      },
      [&] { return bits(G); });
  bench.row<Real>(
      "deformation gradient", n,
      fem::ComputeDeformationGradient{tets.const_view(), positions.const_view(), rest.const_view(), F.view()},
      [&] {
        for (std::size_t i = 0; i < t.size(); ++i)
          gradients[i].F = edges(i, [&](std::size_t k) -> const auto& { return x[k].x; }) * r[i].dm_inverse;
      },
      [&] { return bits(F); });
  bench.row<Real>(
      "corner force differentials", n,
      fem::ComputeCornerForceDifferentials{tets.const_view(), dx.const_view(), rest.const_view(), svd.const_view(),
                                           derivative.const_view(), G.view()},
      [&] {
        for (std::size_t i = 0; i < t.size(); ++i) {
          const M d = M(edges(i, [&](std::size_t k) -> const auto& { return displacements[k].dx; })) * r[i].dm_inverse;
          const M change = fem::detail::stress_differential<Real>(M(decomposed[i].U), M(decomposed[i].V),
                                                                  Derivatives<Real>{derivatives[i]}, d);
          corner_forces[i].G = fem::detail::corner_forces<Real>(change, M(r[i].dm_inverse), r[i].volume);
        }
      },
      [&] { return bits(G); });
}

}  // namespace physgen::lane_kernels
