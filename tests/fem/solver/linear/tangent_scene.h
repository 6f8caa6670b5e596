// A body that is deformed at random, and products with its tangent, for tests.
#pragma once

#include <fem/solver/elastic/evaluate.h>
#include <fem/solver/linear/product_host.h>
#include <fem/solver/newton/newton.h>
#include <fem/solver/solvers/all_arrays.h>
#include <gtest/gtest.h>

#include "../bodies.h"
#include "../irregular.h"

namespace physgen::fem {

inline constexpr double tangent_scene_side = 0.08;

using Vectors = std::vector<Eigen::Vector3d>;

/// An irregular cube, compressed, sheared and with every node moved at random.
template <class Real_ = double>
struct TangentScene {
  using Real = Real_;
  using Arrays = EquilibriumArrays<Real, Host>;
  using Level = LinearLevel<Real, Host, StoredAsComputed>;

  explicit TangentScene(Volume volume, TangentLists lists = TangentLists::of_edges)
      : levels(with(volume,
                    make_levels(tets(), 0, volume == Volume::patches,
                                [](const Point& x) -> std::uint8_t { return x[2] == 0 ? 7 : (x[0] == 0 ? 1 : 0); }))),
        graph(make_level_graphs(levels)[0]),
        arrays(levels[0], graph, false, lists, nullptr),
        level(lists == TangentLists::of_edges ? Level(graph, nullptr) : Level(graph, MatrixFree{true, false})) {
    std::mt19937_64 random(73);
    std::normal_distribution<double> number(0, 1);
    for (const Point& x : levels[0].rest) {
      constexpr double noise = 0.01 * tangent_scene_side;
      at.emplace_back(x[0] + 0.1 * x[1] + noise * number(random), 1.1 * x[1] + noise * number(random),
                      0.8 * x[2] - 0.2 * x[0] + noise * number(random));
      direction.emplace_back(number(random), number(random), number(random));
    }
  }

  static const Tets& tets() {
    static const Tets once =
        shuffled(irregular_box({4, 4, 4}, {tangent_scene_side, tangent_scene_side, tangent_scene_side}, 0.2, 67), 71);
    return once;
  }

  /// The evaluation of positions; all arrays follow it. @return the energy [J]
  double evaluate(Evaluator<HostExecutor, Arrays>& evaluator, const Vectors& x) {
    for (std::size_t n = 0; n < x.size(); ++n) arrays.positions.view()[index_t(n)].x() = x[n];
    const auto state =
        evaluate_state(on, arrays, level, evaluator, arrays.positions.const_view(), arrays.forces.view(), 0.0, true);
    return state.elastic + state.volumetric;
  }
  [[nodiscard]] Vectors forces() const {
    Vectors result;
    for (index_t n = 0; n < arrays.nodes(); ++n) result.emplace_back(arrays.forces.const_view()[n].f());
    return result;
  }

  HostExecutor on;
  std::vector<MeshLevel> levels;
  LevelGraph graph;
  Arrays arrays;
  Level level;
  Vectors at, direction;
};

/// K dx as the scene's level has it: of assembled blocks, or from the tangents.
template <class Real>
Vectors product(TangentScene<Real>& scene, Evaluator<HostExecutor, typename TangentScene<Real>::Arrays>& evaluator,
                const Vectors& direction) {
  if (scene.level.assembled) {
    assemble(scene.on, scene.arrays, scene.level, evaluator, TangentFilter::none);
  } else {
    evaluator.evaluate_tangents(scene.on, scene.arrays, scene.arrays.all_tets(), TangentFilter::none);
  }
  elasticity::NodeDisplacementArray<Real> dx(scene.arrays.nodes());
  elasticity::NodeForceDifferentialArray<Real> df(scene.arrays.nodes());
  for (index_t n = 0; n < dx.size(); ++n) {
    dx.view()[n].dx() = Eigen::Matrix<Real, 3, 1>(direction[std::size_t(n)].cast<Real>());
    df.view()[n].df()[0] = Real(3);  // which is overwritten
  }
  multiply_tangent(scene.on, scene.arrays, scene.level, dx.const_view(), df.view());
  Vectors result;
  for (index_t n = 0; n < df.size(); ++n) result.push_back(df.const_view()[n].df().get().template cast<double>());
  return result;
}

inline double largest(const Vectors& v) {
  double most = 0;
  for (const auto& x : v) most = std::max(most, x.norm());
  return most;
}

/// NaN where any is.
inline double largest_difference(const Vectors& a, const Vectors& b) {
  double most = 0;
  for (std::size_t n = 0; n < a.size(); ++n) {
    const double difference = (a[n] - b[n]).norm();
    if (!(difference <= most)) most = difference;
  }
  return most;
}

}  // namespace physgen::fem
