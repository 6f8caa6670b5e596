// The highest frequency of a body at rest, by power iterations with the stiffness of linear elasticity and lumped mass.
#pragma once

#include <fem/solver/newton/linear_steps.h>
#include <fem/solver/solvers/linear_body.h>
#include <linear_elastic.scene.h>
#include <physgen/executor.h>

#include "moving.h"

namespace physgen::fem {

/// From below, as power iterations find it [rad/s]. Prescribed components are held.
inline double highest_frequency(const MeshLevel& level, const DynamicSettings& settings, int iterations) {
  const LameParameters lame = lame_parameters(settings.solver.youngs_modulus, settings.solver.poissons_ratio, "a test");
  LevelGraph graph;
  graph.nodes = level.mesh.nodes;
  scenes::linear_elastic_scene::Linear<Host, double> body;
  fill_linear_body(body, level, graph, {std::vector<Point>(level.rest.size()), {}, {}}, false);
  const auto masses = lumped_masses(level.mesh, level.rest, settings.density);
  elasticity::NodeForceDifferentialArray<double> product(level.mesh.nodes);
  const auto u = body.displacements.view();
  const auto begin = random_vectors(masses.size(), 1, 3);
  const auto force = forces_of<double>(body, lame, body.displacements.const_view());
  double square = 0;
  for (int k = 0; k <= iterations; ++k) {
    if (k > 0) parallel_for(Host{}, product.size(), MultiplyLinear{force, product.view()});
    double length = 0, work = 0;
    for (index_t n = 0; n < product.size(); ++n) {
      for (int c = 0; c < 3; ++c) {
        const auto node = std::size_t(n), component = std::size_t(c);
        double& own = u[n].dx()[c];
        if ((level.fixed[node] >> c & 1) != 0) {
          own = 0;
        } else if (k == 0) {
          own = begin[node][component];
        } else {
          work -= own * product.view()[n].df()[c];
          own = -product.view()[n].df()[c] / masses[node];
        }
        length += masses[node] * own * own;
      }
    }
    if (k > 0) square = work;  // u.K u / u.M u, u.M u being 1
    for (index_t n = 0; n < product.size(); ++n) {
      for (int c = 0; c < 3; ++c) u[n].dx()[c] /= std::sqrt(length);
    }
  }
  return std::sqrt(square);
}

}  // namespace physgen::fem
