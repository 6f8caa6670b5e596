// The stiffness that is assembled from the tets' tangents against the change of forces tet by tet, and against
// differences of the forces themselves; and products without blocks of edges against the assembled one.
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

PHYSGEN_EVALUATORS_ARE_COMPILED_ELSEWHERE(HostExecutor, float, Host)
PHYSGEN_EVALUATORS_ARE_COMPILED_ELSEWHERE(HostExecutor, double, Host)

namespace {

constexpr double side = 0.08;

using Vectors = std::vector<Eigen::Vector3d>;

/// An irregular cube, compressed, sheared and with every node moved at random.
template <class Real_ = double>
struct Scene {
  using Real = Real_;
  using Arrays = EquilibriumArrays<Real, Host>;
  using Level = LinearLevel<Real, Host, StoredAsComputed>;

  explicit Scene(bool patches, TangentLists lists = TangentLists::of_edges)
      : levels(make_levels(tets(), 0, patches,
                           [](const Point& x) -> std::uint8_t { return x[2] == 0 ? 7 : (x[0] == 0 ? 1 : 0); })),
        graph(make_level_graphs(levels)[0]),
        arrays(levels[0], graph, false, lists, nullptr),
        level(lists == TangentLists::of_edges ? Level(graph, nullptr) : Level(graph, MatrixFree{true, false})) {
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

  /// The evaluation of positions, with its tangent; all arrays follow it.
  void evaluate(Evaluator<HostExecutor, Arrays>& evaluator, const Vectors& x) {
    for (std::size_t n = 0; n < x.size(); ++n) arrays.positions.view()[index_t(n)].x() = x[n];
    (void)evaluate_state(on, arrays, level, evaluator, arrays.positions.const_view(), arrays.forces.view(), 0.0, true);
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
Vectors product(Scene<Real>& scene, Evaluator<HostExecutor, typename Scene<Real>::Arrays>& evaluator,
                const Vectors& direction) {
  if (scene.level.assembled) {
    assemble(scene.on, scene.arrays, scene.level, evaluator, TangentFilter::none);
  } else {
    evaluator.evaluate_tangents(scene.on, scene.arrays, scene.arrays.chunks.front(), TangentFilter::none);
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

/// The same without any stiffness: per tet, then gathered.
template <class Material>
Vectors element_product(Scene<>& scene, const Material& material) {
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
  Scene scene(false);
  const auto evaluator = make_evaluator<HostExecutor, Scene<>::Arrays>(name, 1, 0.45, false);
  scene.evaluate(*evaluator, scene.at);
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

TEST(MatrixFree, product_is_the_change_of_the_forces_of_tets_and_of_patches) {
  for (const std::string& name : material_names()) {
    for (const bool patches : {false, true}) {
      if (patches && !can_average_volume(name)) continue;
      Scene scene(patches);
      const auto evaluator = make_evaluator<HostExecutor, Scene<>::Arrays>(name, 1, 0.45, patches);
      const auto forces_at = [&](double length) {
        Vectors x = scene.at;
        for (std::size_t n = 0; n < x.size(); ++n) x[n] += length * scene.direction[n];
        scene.evaluate(*evaluator, x);
        return scene.forces();
      };
      constexpr double h = 2e-5 * side;  // of a fourth-order difference
      const Vectors a = forces_at(h), b = forces_at(-h), c = forces_at(2 * h), d = forces_at(-2 * h);
      Vectors expected;
      for (std::size_t n = 0; n < a.size(); ++n) {
        expected.emplace_back((8 * (a[n] - b[n]) - (c[n] - d[n])) / (12 * h));
      }
      scene.evaluate(*evaluator, scene.at);
      const Vectors assembled = product(scene, *evaluator, scene.direction);
      const double error = largest_difference(assembled, expected) / largest(expected);
      std::printf("%s, %s: %.1e\n", name.c_str(), patches ? "patches" : "tets", error);
      EXPECT_LE(error, 1e-9) << name << " " << patches;
    }
  }
}

/// @param rounding of the sums, as a part of the largest
template <class Real>
void expect_that_tangents_give_the_assembled_product(const std::string& name, bool patches, double rounding) {
  SCOPED_TRACE(name + (patches ? ", patches" : ", tets"));
  Scene<Real> assembled(patches), free(patches, TangentLists::of_nodes);
  const auto evaluator = make_evaluator<HostExecutor, typename Scene<Real>::Arrays>(name, 1, 0.49, patches);
  for (Scene<Real>* scene : {&assembled, &free}) scene->evaluate(*evaluator, scene->at);
  ASSERT_EQ(free.level.edges.size() + free.level.edge_stiffness.size() + free.arrays.edge_tets.entries().size(), 0);
  const Vectors expected = product(assembled, *evaluator, assembled.direction),
                found = product(free, *evaluator, free.direction);
  const double error = largest_difference(found, expected) / largest(expected);
  std::printf("%s, %s, %zu bytes: %.1e\n", name.c_str(), patches ? "patches" : "tets", sizeof(Real), error);
  EXPECT_GT(largest(expected), 0);
  EXPECT_LE(error, rounding);
  // Where the direction is the same everywhere, forces do not change; a power of two is subtracted without rounding.
  const Vectors translation(free.at.size(), Eigen::Vector3d(0.5, -1, 2));
  EXPECT_EQ(largest(product(free, *evaluator, translation)), 0);

  // Blocks of nodes, scaled, of which the inverses precondition.
  PreconditionerSettings settings;
  settings.kind = Preconditioner::block_jacobi;
  assemble(assembled.on, assembled.arrays, assembled.level, *evaluator, TangentFilter::none);
  prepare_level(assembled.on, assembled.level, settings, true);
  prepare_nodes(free.on, free.arrays, free.level, settings);
  for (index_t n = 0; n < free.arrays.nodes(); ++n) {
    EXPECT_EQ(free.level.scales.const_view()[n].scale(), assembled.level.scales.const_view()[n].scale());
    const Eigen::Matrix<Real, 3, 3> a = assembled.level.scaled_nodes.const_view()[n].K();
    const Eigen::Matrix<Real, 3, 3> b = free.level.node_stiffness.const_view()[n].K();
    EXPECT_LE((a - b).norm(), rounding * (1 + a.norm())) << n;
  }
}

TEST(MatrixFree, product_from_tangents_is_that_of_the_assembled_blocks) {
  for (const char* name : {"neo-hookean", "stable-neo-hookean", "mooney-rivlin", "fixed-corotated"}) {
    for (const bool patches : {false, true}) {
      if (patches && !can_average_volume(name)) continue;
      expect_that_tangents_give_the_assembled_product<double>(name, patches, 1e-14);
      expect_that_tangents_give_the_assembled_product<float>(name, patches, 3e-6);
    }
  }
}

/// An irregular block whose top is pushed down and aside.
Body pushed_block(bool patches) {
  Body body;
  body.levels = make_levels(Scene<>::tets(), 0, patches, [](const Point& x) -> std::uint8_t {
    return x[2] == 0 ? 7 : (x[2] == side ? 5 : 0);  // aside along x; along y it may slide
  });
  body.loading.motion = at_nodes(body.levels[0].rest,
                                 [](const Point& x) { return x[2] == side ? Point{0.3 * side, 0, -side} : Point{}; });
  return body;
}

TEST(MatrixFree, newtons_method_finds_the_equilibrium_of_the_assembled_product) {
  for (const bool patches : {false, true}) {
    const Body body = pushed_block(patches);
    for (const auto precision : {TangentPrecision::half, TangentPrecision::float32, TangentPrecision::float64}) {
      for (const auto kind : {Preconditioner::none, Preconditioner::block_jacobi}) {
        SolverSettings settings;
        settings.poissons_ratio = patches ? 0.495 : 0.4;
        settings.precision = precision;
        settings.newton.preconditioner.kind = kind;
        settings.newton.tolerance = 1e-10;
        const auto assembled = make_solver(body.levels, body.loading, settings);
        settings.newton.product = Product::matrix_free;
        const auto free = make_solver(body.levels, body.loading, settings);
        for (const double load : {0.1, 0.2}) {  // the second from an equilibrium: K d of the increment
          const NewtonResult a = assembled->solve_to(load, {}), b = free->solve_to(load, {});
          ASSERT_EQ(a.status, NewtonStatus::converged);
          ASSERT_EQ(b.status, NewtonStatus::converged);
          EXPECT_NEAR(b.steps, a.steps, 1);
          EXPECT_NEAR(b.iterations, a.iterations, 0.05 * a.iterations + 3);
          EXPECT_NEAR(b.energy / a.energy, 1, 1e-10);
        }
        EXPECT_LE(largest_distance(free->positions(), assembled->positions()), 1e-7 * side);
        EXPECT_LT(free->bytes(), assembled->bytes());
      }
    }
  }
}

TEST(MatrixFree, coarser_meshes_are_solved_on_first_without_blocks_too) {
  const Body body = make_truth_cube_body(16, true);
  SolverSettings settings;
  settings.poissons_ratio = 0.45;
  settings.newton.preconditioner.kind = Preconditioner::block_jacobi;
  settings.newton.tolerance = 1e-8;
  const auto assembled = make_solver(body.levels, body.loading, settings);
  settings.newton.product = Product::matrix_free;
  const auto free = make_solver(body.levels, body.loading, settings);
  const NewtonResult a = assembled->solve_to(0.05, {}), b = free->solve_to(0.05, {});
  ASSERT_EQ(b.status, NewtonStatus::converged);
  EXPECT_GT(b.coarse_steps, 0);
  EXPECT_EQ(b.coarse_steps, a.coarse_steps);
  EXPECT_LE(largest_distance(free->positions(), assembled->positions()), 1e-7 * side);
}

TEST(MatrixFree, product_is_refused_with_multigrid) {
  const Body body = make_truth_cube_body(4, false);
  SolverSettings settings;
  settings.newton.product = Product::matrix_free;
  try {
    (void)make_solver(body.levels, body.loading, settings);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("goes with block Jacobi or no preconditioner"), std::string::npos);
  }
}

}  // namespace
}  // namespace physgen::fem
