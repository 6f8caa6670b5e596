// The stiffness that is assembled from the tets' tangents against the change of forces tet by tet, and against
// differences of the forces themselves.
#include <fem/kernels/compute_svd.h>
#include <fem/kernels/deformation_gradient.h>
#include <fem/kernels/force_differential.h>
#include <fem/kernels/stress_derivative.h>
#include <fem/materials/materials.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "tangent_scene.h"

namespace physgen::fem {

namespace {

using Scene = TangentScene<double>;
using Arrays = Scene::Arrays;

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

template <class Material>
void expect_equal_products(const char* name) {
  Scene scene(Volume::tets);
  const auto evaluator = make_evaluator<HostExecutor, Arrays>(name, {{1, 0.45}}, false);
  (void)scene.evaluate(*evaluator, scene.at);
  const Vectors assembled = product(scene, *evaluator, scene.direction);
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
      const auto evaluator = make_evaluator<HostExecutor, Arrays>(name, {{1, 0.45}}, averages);
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
    const Eigen::VectorXd differences = change(forces_at, 2e-5 * tangent_scene_side);
    Vectors expected;
    for (index_t n = 0; n < index_t(scene.at.size()); ++n) expected.emplace_back(differences.segment<3>(3 * n));
    (void)scene.evaluate(evaluator, scene.at);
    const double error = largest_difference(product(scene, evaluator, scene.direction), expected) / largest(expected);
    std::printf("%s: %.1e\n", name.c_str(), error);
    EXPECT_LE(error, 1e-9) << name;
  });
}

TEST(MatrixFree, forces_are_the_fall_of_the_energy_of_tets_patches_and_nodes) {
  for_each_scene([](Scene& scene, auto& evaluator, const std::string& name) {
    const double slope = change([&](double length) { return scene.evaluate(evaluator, moved(scene, length)); },
                                5e-5 * tangent_scene_side);
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
