// Scenes of this tree over their generated arrays, which hold what the programs need, against the solvers.
#include <explicit_dynamics.scene.h>
#include <fem/dynamics/explicit.h>
#include <fem/dynamics/explicit_body.h>
#include <fem/solver/arrays/host_points.h>
#include <fem/solver/arrays/node_vectors.h>
#include <fem/solver/loads/inertia_arrays.h>
#include <fem/solver/solvers/linear_body.h>
#include <fem/solver/solvers/scene_solvers.h>
#include <gtest/gtest.h>
#include <implicit_dynamics.scene.h>
#include <linear_elastic.scene.h>
#include <physgen/error.h>
#include <physgen/executor.h>
#include <scenes/explicit_dynamics.h>
#include <scenes/implicit_dynamics.h>
#include <scenes/linear_elastic.h>

#include <algorithm>
#include <cstring>

#include "../solver/scene_groups.h"
#include "moving.h"

namespace physgen::fem {
namespace {

constexpr double young = 1e4;

TEST(Scenes, explicit_dynamics_over_its_generated_arrays_gives_the_bits_of_the_solver) {
  const Body body = make_truth_cube_body(4, false);
  const MeshLevel& level = body.levels[0];
  DynamicSettings settings = moving_settings("neo-hookean", young, 0.4);
  settings.solver.precision = TangentPrecision::float32;
  settings.damping = 3;
  const double dt = 0.5 * stable_time_step(level, settings);
  const auto begin = sum(level.rest, random_vectors(level.rest.size(), 0.02 * side / 4, 3));

  const auto solver = make_explicit_solver(level, body.loading, settings);
  solver->set_positions(begin);
  HostExecutor on;
  scenes::explicit_dynamics_scene::Body<> scene;
  fill_explicit_body(scene, level, body.loading, lumped_masses(level.mesh, level.rest, density), false);
  store_displacements(on, sum(begin, level.rest, -1), scene.displacements);
  store_displacements(on, sum(begin, level.rest, -1), scene.rounded);
  EXPECT_EQ(scene.bytes(), solver->bytes());

  const auto material = NeoHookean<float>::from(young, 0.4);
  for (int k = 1; k <= 20; ++k) {
    const TimeStep step{dt, 0.01 * k / 20, settings.damping};
    scenes::explicit_dynamics::program(on, scene, material, step);
    (void)solver->step(step.length, step.load);
  }
  const MotionMeasure measured = solver->measure();
  EXPECT_GT(measured.kinetic, 0);
  EXPECT_GT(measured.elastic, 0);
  EXPECT_EQ(on.value(scene.measured).kinetic, measured.kinetic);
  EXPECT_EQ(on.value(scene.measured).elastic, measured.elastic);
  EXPECT_EQ(plain_velocities(on, scene.velocities), solver->velocities());
  EXPECT_EQ(sum(plain_displacements(on, scene.displacements), level.rest), solver->positions());
}

TEST(Scenes, implicit_dynamics_over_its_generated_arrays_gives_the_bits_of_the_solver) {
  namespace scene = scenes::implicit_dynamics_scene;
  const Body body = make_truth_cube_body(8, true);
  DynamicSettings settings = moving_settings("stable-neo-hookean", young, 0.45);
  settings.solver.precision = TangentPrecision::float32;
  settings.solver.newton.tolerance = 1e-6;
  settings.solver.nested = false;
  settings.damping = 3;
  const auto start = random_vectors(body.levels[0].rest.size(), 0.05, 4);
  const auto solver = make_implicit_solver(body.levels, body.loading, settings);
  solver->set_velocities(start);

  SceneGroups<scene::Body<>, scene::Patches<>, scene::Chunk<>, scene::Level<>, scene::Krylov<>> groups(body,
                                                                                                       settings.solver);
  ASSERT_GE(groups.levels.size(), 2U) << "else no coarser level has inertia";
  std::vector<double> masses = lumped_masses(body.levels[0].mesh, body.levels[0].rest, density);
  const double largest_mass = std::ranges::max(masses), dt = 2e-3;
  std::vector<scene::Inertia<>> inertia;
  for (std::size_t l = 0; l < groups.levels.size(); ++l) {
    inertia.push_back(InertiaOver<scene::Inertia<>>(masses, l == 0));
    if (l + 1 < groups.levels.size()) {
      masses = coarsened_masses(masses, body.levels[l].parents, body.levels[l + 1].mesh.nodes);
    }
  }
  HostExecutor on;
  store_velocities(on, start, inertia[0].velocities);
  inertia[0].measured.view()[0].elastic() = 0;
  groups.facts.node_stiffness =
      node_stiffness(settings.solver, false, groups.spacing) + largest_mass * (1 / dt + settings.damping) / dt;

  const auto material = StableNeoHookean<double>::from(young, 0.45);
  for (int k = 1; k <= 3; ++k) {
    const TimeStep step{dt, 0.02 * k, settings.damping};
    const NewtonResult expected = solver->step(step.length, step.load);
    ASSERT_EQ(expected.status, NewtonStatus::converged);
    const NewtonResult found =
        scenes::implicit_dynamics::program(on, groups.body, groups.patches, groups.chunk, groups.levels, inertia,
                                           groups.krylov, material, settings.solver, groups.facts, step);
    EXPECT_EQ(found.steps, expected.steps);
    EXPECT_EQ(found.iterations, expected.iterations);
    EXPECT_GT(found.iterations, 0);
    settings.solver.newton.start_load = step.load;
    settings.solver.newton.last_reaction = found.reaction;
  }
  EXPECT_EQ(plain_velocities(on, inertia[0].velocities), solver->velocities());
  const auto positions = solver->positions();
  for (std::size_t n = 0; n < positions.size(); ++n) {
    const Eigen::Vector3d x = groups.body.positions.view()[index_t(n)].x();
    ASSERT_EQ(std::memcmp(x.data(), positions[n].data(), sizeof positions[n]), 0) << n;
  }
  EXPECT_EQ(double{inertia[0].measured.view()[0].kinetic()}, solver->measure().kinetic);
  EXPECT_GT(solver->measure().kinetic, 0);
}

/// A cube whose upper plate comes down while its nodes fly apart.
TEST(Scenes, implicit_dynamics_by_its_own_solver_has_the_bits_of_the_solver_with_all_arrays) {
  for (const bool patches : {true, false}) {
    for (const auto kind : {Preconditioner::multigrid, Preconditioner::none}) {
      const Body body = make_truth_cube_body(8, patches);
      DynamicSettings settings = moving_settings("stable-neo-hookean", young, 0.45);
      settings.solver.precision = TangentPrecision::float32;
      settings.solver.newton.preconditioner.kind = kind;
      settings.solver.newton.tolerance = 1e-6;
      settings.damping = 3;
      const auto all = make_implicit_solver(body.levels, body.loading, settings);
      const auto own = make_scene_implicit_solver(body.levels, body.loading, settings);
      EXPECT_LE(own->bytes(), all->bytes());
      const auto start = random_vectors(body.levels[0].rest.size(), 0.05, 4);
      for (auto* solver : {all.get(), own.get()}) solver->set_velocities(start);
      for (int k = 1; k <= 2; ++k) {
        const NewtonResult expected = all->step(2e-3, 0.02 * k), found = own->step(2e-3, 0.02 * k);
        ASSERT_EQ(expected.status, NewtonStatus::converged);
        ASSERT_EQ(found.status, NewtonStatus::converged);
        EXPECT_EQ(found.iterations, expected.iterations);
        EXPECT_GT(found.iterations, 0);
      }
      EXPECT_EQ(own->time(), all->time());
      EXPECT_EQ(own->positions(), all->positions());
      EXPECT_EQ(own->velocities(), all->velocities());
      EXPECT_EQ(own->forces(), all->forces());
      EXPECT_EQ(own->stresses(), all->stresses());
      EXPECT_EQ(own->measure().kinetic, all->measure().kinetic);
      EXPECT_GT(all->measure().kinetic, 0);
      EXPECT_GT(all->measure().elastic, 0);
    }
  }
}

TEST(Scenes, implicit_dynamics_refuses_what_it_has_not) {
  const Body body = make_truth_cube_body(4, true);
  DynamicSettings settings = moving_settings("stable-neo-hookean", young, 0.45);
  settings.solver.precision = TangentPrecision::float32;
  const auto expect_refused = [&](const std::string& what, const auto& change) {
    DynamicSettings other = settings;
    change(other.solver);
    try {
      (void)make_scene_implicit_solver(body.levels, body.loading, other);
      ADD_FAILURE() << "not refused: " << what;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("the scene implicit_dynamics " + what), std::string::npos)
          << error.what();
    }
  };
  expect_refused("is in float", [](SolverSettings& s) { s.precision = TangentPrecision::float64; });
  expect_refused("is of the material 'stable-neo-hookean', but 'neo-hookean'",
                 [](SolverSettings& s) { s.material = "neo-hookean"; });
  expect_refused("has no Schwarz", [](SolverSettings& s) { s.newton.preconditioner.kind = Preconditioner::schwarz; });
  expect_refused("assembles its stiffness", [](SolverSettings& s) { s.newton.product = Product::matrix_free; });
}

TEST(Scenes, linear_elastic_over_its_generated_arrays_gives_the_bits_of_the_solver) {
  const Body body = make_truth_cube_body(4, false);
  const MeshLevel& level = body.levels[0];
  SolverSettings settings = exact_settings("neo-hookean", 0.4);
  settings.youngs_modulus = young;
  settings.precision = TangentPrecision::float32;
  settings.newton.tolerance = 1e-4;
  settings.newton.product = Product::matrix_free;
  settings.newton.preconditioner.kind = Preconditioner::block_jacobi;
  const auto solver = make_linear_solver(body.levels, body.loading, settings);
  const NewtonResult result = solver->solve_to(0.1, {});
  ASSERT_EQ(result.steps, 1);

  LevelGraph graph;
  graph.nodes = level.mesh.nodes;
  namespace scene = scenes::linear_elastic_scene;
  scene::Linear<> linear;
  scene::Level<> preconditioner;
  scene::Krylov<> vectors;
  scene::Stresses<> stresses;
  fill_linear_body(linear, level, graph, body.loading, false);
  const index_t nodes = level.mesh.nodes;
  preconditioner.allocate({.node = nodes, .block_node = nodes});
  vectors.allocate({.node = nodes});
  stresses.allocate({.tet = linear.tets.size()});
  quasistatic::NodeConstraintArray<float> constraints(nodes);
  for (index_t n = 0; n < nodes; ++n) constraints.view()[n].fixed() = level.fixed[std::size_t(n)];
  copy(preconditioner.constraints, constraints);

  HostExecutor on;
  scenes::linear_elastic::program(on, linear, preconditioner, vectors, stresses, lame_parameters(young, 0.4, "a test"),
                                  0.1, 0.03 * settings.newton.tolerance, settings.newton.most_iterations);
  EXPECT_EQ(int{on.value(vectors.state).iterations}, result.iterations);
  EXPECT_EQ(sum(plain_displacements(on, linear.displacements), level.rest), solver->positions());
  EXPECT_EQ(plain_forces(on, linear.forces), solver->forces());
  EXPECT_EQ(plain_stresses(on, stresses.of_tets), solver->stresses());
  EXPECT_EQ(on.value(linear.state).smallest_ratio, result.smallest_J);
  EXPECT_LE(linear.bytes() + preconditioner.bytes() + vectors.bytes(), solver->bytes());
}

}  // namespace
}  // namespace physgen::fem
