// Motion and linear elasticity on CUDA against the CPU.
#include <fem/dynamics/explicit.h>
#include <gtest/gtest.h>
#include <physgen/device.h>

#include "moving.h"

namespace physgen::fem {
namespace {

class DynamicsOnCuda : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!cuda_available()) GTEST_SKIP() << "no CUDA device";
  }
};

struct Moved {
  std::vector<Point> positions, velocities, forces;
  std::vector<std::array<double, 9>> stresses;
  MotionMeasure measure;
};

/// A cube whose upper plate moves down, and whose nodes have velocities of their own.
template <class Make>
Moved move(const Body& body, DynamicSettings settings, Device device, double dt, int steps, const Make& make) {
  settings.solver.device = device;
  const auto solver = make(settings);
  solver->set_velocities(random_vectors(body.levels[0].rest.size(), 0.05, 4));
  for (int k = 1; k <= steps; ++k) EXPECT_EQ(solver->step(dt, 0.05 * k / steps).status, NewtonStatus::converged);
  return {solver->positions(), solver->velocities(), solver->forces(), solver->stresses(), solver->measure()};
}

void expect_equal(const Moved& cpu, const Moved& gpu, double tolerance) {
  const double young = 1e4, speed = 0.5;
  EXPECT_GT(cpu.measure.kinetic, 0);
  EXPECT_LE(largest_distance(cpu.positions, gpu.positions), tolerance * side);
  EXPECT_LE(largest_distance(cpu.velocities, gpu.velocities), tolerance * speed);
  EXPECT_LE(largest_distance(cpu.forces, gpu.forces), tolerance * young * side * side);
  EXPECT_NEAR(gpu.measure.kinetic / cpu.measure.kinetic, 1, 10 * tolerance);
  EXPECT_NEAR(gpu.measure.elastic / cpu.measure.elastic, 1, 10 * tolerance);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(gpu.measure.momentum[k], cpu.measure.momentum[k], tolerance * std::abs(cpu.measure.momentum[2]));
  }
  ASSERT_EQ(cpu.stresses.size(), gpu.stresses.size());
  for (std::size_t t = 0; t < cpu.stresses.size(); ++t) {
    for (std::size_t k = 0; k < 9; ++k) EXPECT_NEAR(cpu.stresses[t][k], gpu.stresses[t][k], 10 * tolerance * young);
  }
}

TEST_F(DynamicsOnCuda, explicit_steps_move_a_body_as_the_cpu_does_in_every_material) {
  const Body body = make_truth_cube_body(8, false);
  for (const std::string& material : material_names()) {
    for (const auto& [precision, tolerance] :
         {std::pair{TangentPrecision::float64, 1e-10}, std::pair{TangentPrecision::float32, 1e-4}}) {
      DynamicSettings settings = moving_settings(material, 1e4, 0.4);
      settings.solver.precision = precision;
      settings.damping = 2;
      const double dt = 0.5 * stable_time_step(body.levels[0], settings);
      const auto make = [&](const DynamicSettings& own) {
        return make_explicit_solver(body.levels[0], body.loading, own);
      };
      const Moved cpu = move(body, settings, Device::cpu, dt, 50, make);
      for (const bool fixed_order : {false, true}) {
        settings.fixed_order = fixed_order;
        SCOPED_TRACE(material + (fixed_order ? ", in a fixed order" : ""));
        expect_equal(cpu, move(body, settings, Device::cuda, dt, 50, make), tolerance);
      }
    }
  }
}

TEST_F(DynamicsOnCuda, explicit_steps_in_a_fixed_order_have_the_same_bits_on_every_run) {
  const Body body = make_truth_cube_body(16, false);
  for (const TangentPrecision precision : {TangentPrecision::float64, TangentPrecision::float32}) {
    DynamicSettings settings = moving_settings("neo-hookean", 1e4, 0.4);
    settings.solver.precision = precision;
    settings.fixed_order = true;
    const double dt = 0.5 * stable_time_step(body.levels[0], settings);
    const auto run = [&] {
      return move(body, settings, Device::cuda, dt, 50,
                  [&](const DynamicSettings& own) { return make_explicit_solver(body.levels[0], body.loading, own); });
    };
    const Moved first = run();
    EXPECT_GT(first.measure.elastic, 0);
    for (int again = 0; again < 5; ++again) {
      const Moved next = run();
      EXPECT_EQ(next.positions, first.positions);
      EXPECT_EQ(next.velocities, first.velocities);
      EXPECT_EQ(next.forces, first.forces);
    }
  }
}

TEST_F(DynamicsOnCuda, explicit_steps_hold_places_for_forces_in_a_fixed_order_alone) {
  const Body body = make_truth_cube_body(8, false);
  DynamicSettings settings = moving_settings("neo-hookean", 1e4, 0.4);
  settings.solver.device = Device::cuda;
  settings.solver.precision = TangentPrecision::float32;
  const auto added = make_explicit_solver(body.levels[0], body.loading, settings)->bytes();
  settings.fixed_order = true;
  const auto placed = make_explicit_solver(body.levels[0], body.loading, settings)->bytes();
  settings.solver.device = Device::cpu;
  const auto gathered = make_explicit_solver(body.levels[0], body.loading, settings)->bytes();
  EXPECT_LT(added, gathered);
  EXPECT_LT(added, placed);
}

TEST_F(DynamicsOnCuda, implicit_steps_move_a_body_as_the_cpu_does) {
  for (const Preconditioner kind : {Preconditioner::multigrid, Preconditioner::schwarz}) {
    for (const TangentPrecision precision :
         {TangentPrecision::half, TangentPrecision::float32, TangentPrecision::float64}) {
      const Body body = with_contact(make_truth_cube_body(8, true));
      DynamicSettings settings = moving_settings("neo-hookean", 1e4, 0.45);
      settings.solver.precision = precision;
      settings.solver.newton.preconditioner.kind = kind;
      settings.solver.newton.tolerance = 1e-9;
      settings.damping = 2;
      const auto make = [&](const DynamicSettings& own) {
        return make_implicit_solver(body.levels, body.loading, own);
      };
      const Moved cpu = move(body, settings, Device::cpu, 2e-3, 5, make),
                  gpu = move(body, settings, Device::cuda, 2e-3, 5, make);
      expect_equal(cpu, gpu, 1e-7);
    }
  }
}

TEST_F(DynamicsOnCuda, a_linear_elastic_body_is_solved_for_as_on_the_cpu) {
  const Body body = make_truth_cube_body(8, false);
  for (const Product product : {Product::assembled, Product::matrix_free}) {
    for (const TangentPrecision precision :
         {TangentPrecision::half, TangentPrecision::float32, TangentPrecision::float64}) {
      SolverSettings settings = exact_settings("neo-hookean", 0.45);
      settings.newton.tolerance = 1e-9;
      settings.precision = precision;
      settings.newton.product = product;
      settings.newton.preconditioner.kind =
          product == Product::assembled ? Preconditioner::multigrid : Preconditioner::block_jacobi;
      std::array<std::vector<Point>, 2> found;
      for (const Device device : {Device::cpu, Device::cuda}) {
        settings.device = device;
        const auto solver = make_linear_solver(body.levels, body.loading, settings);
        ASSERT_EQ(solver->solve_to(0.1, {}).status, NewtonStatus::converged);
        found[device == Device::cuda ? 1 : 0] = solver->positions();
      }
      EXPECT_LE(largest_distance(found[0], found[1]), 1e-8 * side);
    }
  }
}

}  // namespace
}  // namespace physgen::fem
