// The stiffness that is assembled from the tets' tangents against the change of forces tet by tet, and against
// differences of the forces themselves.
#include <fem/kernels/compute_svd.h>
#include <fem/kernels/deformation_gradient.h>
#include <fem/kernels/force_differential.h>
#include <fem/kernels/stress_derivative.h>
#include <fem/solver/make_evaluator.h>
#include <fem/solver/newton.h>
#include <fem/solver/product_host.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "bodies.h"
#include "irregular.h"

namespace physgen::fem {

PHYSGEN_EVALUATORS_ARE_COMPILED_ELSEWHERE(HostExecutor, double, Host)

namespace {

constexpr double side = 0.08;

using Arrays = EquilibriumArrays<double, Host>;
using Level = LinearLevel<double, Host, StoredAsComputed>;
using Vectors = std::vector<Eigen::Vector3d>;

/// An irregular cube, compressed, sheared and with every node moved at random.
struct Scene {
  explicit Scene(Volume volume)
      : levels(with(volume,
                    make_levels(tets(), 0, volume == Volume::patches,
                                [](const Point& x) -> std::uint8_t { return x[2] == 0 ? 7 : (x[0] == 0 ? 1 : 0); }))),
        graph(make_level_graphs(levels)[0]),
        arrays(levels[0], graph, false, nullptr),
        level(graph, nullptr) {
    std::mt19937_64 random(73);
    std::normal_distribution<double> number(0, 1);
    for (const Point& x : levels[0].rest) {
      constexpr double noise = 0.01 * side;
      at.emplace_back(x[0] + 0.1 * x[1] + noise * number(random), 1.1 * x[1] + noise * number(random),
                      0.8 * x[2] - 0.2 * x[0] + noise * number(random));
      direction.emplace_back(number(random), number(random), number(random));
    }
  }

  static const Tets& tets() {
    static const Tets once = shuffled(irregular_box({4, 4, 4}, {side, side, side}, 0.2, 67), 71);
    return once;
  }

  /// The evaluation of positions, with its tangent; all arrays follow it. @return the energy [J]
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

/// K dx of the assembled blocks, at the scene's positions.
Vectors assembled_product(Scene& scene, Evaluator<HostExecutor, Arrays>& evaluator) {
  assemble(scene.on, scene.arrays, scene.level, evaluator, TangentFilter::none);
  elasticity::NodeDisplacementArray<double> dx(scene.arrays.nodes());
  elasticity::NodeForceDifferentialArray<double> df(scene.arrays.nodes());
  for (index_t n = 0; n < dx.size(); ++n) dx.view()[n].dx() = scene.direction[std::size_t(n)];
  multiply(scene.on,
           SymmetricProduct{scene.level.node_stiffness.const_view(), scene.level.edge_stiffness.const_view(),
                            scene.level.edges.const_view(), dx.const_view(), df.view()},
           scene.level.sums);
  Vectors result;
  for (index_t n = 0; n < df.size(); ++n) result.emplace_back(df.const_view()[n].df());
  return result;
}

/// The same without any stiffness: per tet, then gathered.
template <class Material>
Vectors element_product(Scene& scene, const Material& material) {
  const auto& mesh = scene.levels[0].mesh;
  const auto tets = index_t(mesh.tets.size()), nodes = index_t(mesh.nodes);
  elasticity::NodeDisplacementArray<double> dx(nodes);
  elasticity::RestShapeArray<double> shapes(tets);
  elasticity::DeformationGradientArray<double> gradients(tets);
  elasticity::DeformationSvdArray<double> svds(tets);
  elasticity::StressDerivativeArray<double> derivatives(tets);
  elasticity::CornerForcesArray<double> corners(tets);
  elasticity::NodeForceDifferentialArray<double> df(nodes);
  for (index_t n = 0; n < nodes; ++n) dx.view()[n].dx() = scene.direction[std::size_t(n)];
  const auto names = scene.arrays.tets.const_view();
  auto& on = scene.on;
  on.run(tets, ComputeRestShape{names, scene.arrays.rest.const_view(), shapes.view()});
  on.run(tets,
         ComputeDeformationGradient{names, scene.arrays.positions.const_view(), shapes.const_view(), gradients.view()});
  on.run(tets, ComputeSvd{gradients.const_view(), svds.view()});
  on.run(tets, ComputeStressDerivative{material, svds.const_view(), derivatives.view()});
  on.run(tets, ComputeCornerForceDifferentials{names, dx.const_view(), shapes.const_view(), svds.const_view(),
                                               derivatives.const_view(), corners.view()});
  using Rows = RowArrays<elasticity::IncidenceRangeArray<float>, elasticity::IncidenceArray<float>>;
  const auto node_tets = incidence_rows<Rows>(mesh.node_tets, tets);
  on.run(nodes, GatherForceDifferentials{node_tets.const_view(), corners.const_view(), df.view()});
  Vectors result;
  for (index_t n = 0; n < nodes; ++n) result.emplace_back(df.const_view()[n].df());
  return result;
}

double largest(const Vectors& v) {
  double most = 0;
  for (const auto& x : v) most = std::max(most, x.norm());
  return most;
}

/// NaN where any is.
double largest_difference(const Vectors& a, const Vectors& b) {
  double most = 0;
  for (std::size_t n = 0; n < a.size(); ++n) {
    const double difference = (a[n] - b[n]).norm();
    if (!(difference <= most)) most = difference;
  }
  return most;
}

template <class Material>
void expect_equal_products(const char* name) {
  Scene scene(Volume::tets);
  const auto evaluator = make_evaluator<HostExecutor, Arrays>(name, 1, 0.45, false);
  (void)scene.evaluate(*evaluator, scene.at);
  const Vectors assembled = assembled_product(scene, *evaluator);
  const Vectors by_tets = element_product(scene, Material::from(1, 0.45));
  const double size = largest(by_tets), error = largest_difference(assembled, by_tets);
  std::printf("%s: assembled and element form differ by %.1e of the largest\n", name, error / size);
  EXPECT_GT(size, 0);
  EXPECT_LE(error, 1e-13 * size) << name;
}

TEST(MatrixFree, product_by_tets_is_that_of_the_assembled_blocks) {
  expect_equal_products<NeoHookean<double>>("neo-hookean");
  expect_equal_products<FixedCorotated<double>>("fixed-corotated");
  expect_equal_products<MooneyRivlin<double>>("mooney-rivlin");
}

/// A function's change at 0 over its argument, by a difference of fourth order. @pre its values can be added and scaled
template <class Function>
auto change(const Function& function, double h) {
  const auto a = function(h), b = function(-h), c = function(2 * h), d = function(-2 * h);
  return decltype(a)((8 * (a - b) - (c - d)) / (12 * h));
}

/// body(scene, evaluator, name of material and volume) for each material that each treatment of volume admits.
void for_each_scene(const std::function<void(Scene&, Evaluator<HostExecutor, Arrays>&, const std::string&)>& body) {
  for (const std::string& name : material_names()) {
    for (const Volume volume : volumes) {
      const bool averages = volume != Volume::tets;
      if (averages && !can_average_volume(name)) continue;
      Scene scene(volume);
      const auto evaluator = make_evaluator<HostExecutor, Arrays>(name, 1, 0.45, averages);
      body(scene, *evaluator, name + ", " + name_of(volume));
    }
  }
}

/// The scene's positions, moved along its direction.
Vectors moved(const Scene& scene, double length) {
  Vectors x = scene.at;
  for (std::size_t n = 0; n < x.size(); ++n) x[n] += length * scene.direction[n];
  return x;
}

TEST(MatrixFree, product_is_the_change_of_the_forces_of_tets_patches_and_nodes) {
  for_each_scene([](Scene& scene, auto& evaluator, const std::string& name) {
    const auto forces_at = [&](double length) {
      (void)scene.evaluate(evaluator, moved(scene, length));
      Eigen::VectorXd all(3 * index_t(scene.at.size()));
      const Vectors forces = scene.forces();
      for (std::size_t n = 0; n < forces.size(); ++n) all.segment<3>(3 * index_t(n)) = forces[n];
      return all;
    };
    const Eigen::VectorXd differences = change(forces_at, 2e-5 * side);
    Vectors expected;
    for (index_t n = 0; n < index_t(scene.at.size()); ++n) expected.emplace_back(differences.segment<3>(3 * n));
    (void)scene.evaluate(evaluator, scene.at);
    const double error = largest_difference(assembled_product(scene, evaluator), expected) / largest(expected);
    std::printf("%s: %.1e\n", name.c_str(), error);
    EXPECT_LE(error, 1e-9) << name;
  });
}

TEST(MatrixFree, forces_are_the_fall_of_the_energy_of_tets_patches_and_nodes) {
  for_each_scene([](Scene& scene, auto& evaluator, const std::string& name) {
    const double slope =
        change([&](double length) { return scene.evaluate(evaluator, moved(scene, length)); }, 5e-5 * side);
    (void)scene.evaluate(evaluator, scene.at);
    const Vectors forces = scene.forces();
    double work = 0;
    for (std::size_t n = 0; n < forces.size(); ++n) work += forces[n].dot(scene.direction[n]);
    const double error = std::abs(slope + work) / std::abs(work);
    std::printf("%s: %.1e\n", name.c_str(), error);
    EXPECT_LE(error, 1e-9) << name;
  });
}

}  // namespace
}  // namespace physgen::fem
