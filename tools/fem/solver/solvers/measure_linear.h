// Takes the times of a linear solve, as a program over an executor.
#pragma once

#include <fem/solver/linear/count_bytes.h>
#include <fem/solver/linear_measurement.h>
#include <fem/solver/newton/newton.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>
#include <vector>

namespace physgen::fem {

namespace detail {

/// Seconds of `step`, with all that it gives to the executor.
template <class On, class Step>
[[nodiscard]] double seconds_of(On& on, const Step& step) {
  on.wait();
  const auto start = std::chrono::steady_clock::now();
  step();
  on.wait();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Puts the right-hand side where the forces are. @return |force| over free components [N]
template <class On, class Arrays, class Level>
[[nodiscard]] double store_force(On& on, Arrays& a, const Level& level, std::span<const Point> force) {
  on.wait();
  const auto constraints = moved_to<quasistatic::NodeConstraintArray<typename Level::Real>>(level.constraints);
  elasticity::NodeForceArray<double> host(a.nodes());
  double square = 0;
  for (index_t n = 0; n < a.nodes(); ++n) {
    const int fixed = constraints.const_view()[n].fixed();
    for (int k = 0; k < 3; ++k) {
      const double f = force[std::size_t(n)][std::size_t(k)];
      host.view()[n].f()[k] = f;
      if ((fixed >> k & 1) == 0) square += f * f;
    }
  }
  copy(a.forces, host);
  synchronize();
  return std::sqrt(square);
}

template <class On, class Array>
void read_step(On& on, const Array& array, std::vector<Point>& step) {
  on.wait();
  const auto found = moved_to<elasticity::NodeDisplacementArray<typename Array::Precision>>(array);
  step.resize(static_cast<std::size_t>(found.size()));
  for (index_t n = 0; n < found.size(); ++n) {
    for (int k = 0; k < 3; ++k) step[std::size_t(n)][std::size_t(k)] = found.const_view()[n].dx().get()[k];
  }
}

}  // namespace detail

/// Solves for the step of the tangents in `a` and a force, on the finest level; times and bytes where repeats > 0.
template <class On, class Arrays, class Levels, class Vectors, class Evaluator>
[[nodiscard]] LinearMeasurement measure_linear(On& on, Arrays& a, Levels& levels, Vectors& v, Evaluator& evaluator,
                                               NewtonSettings settings, const AtLoad& at, const LinearTask& task,
                                               std::span<const Point> force, std::vector<Point>* step) {
  auto& level = *levels[0];
  const PreconditionerSettings& preconditioner = settings.preconditioner;
  settings.most_iterations = std::max(settings.most_iterations, 100000);
  const double force_length = detail::store_force(on, a, level, force);
  const double length = task.norm == LinearNorm::euclidean ? task.tolerance * force_length : 0.0;
  const auto solve_on = [&](auto& executor, auto& loop) {
    executor.run(a.nodes(),
                 BeginResidual{a.forces.const_view(), level.constraints.const_view(), false, v.residual.view()});
    solve(executor, loop, a, levels, 0, v, preconditioner, task.tolerance, settings.most_iterations, length);
  };
  LinearMeasurement measured;
  std::vector<double> assembly, preparation, solution;
  typename On::Loop loop;
  for (int k = 0; k <= task.repeats; ++k) {
    assembly.push_back(detail::seconds_of(on, [&] { form_tangent(on, a, level, evaluator, TangentFilter::none, at); }));
    preparation.push_back(detail::seconds_of(on, [&] { prepare_tangent(on, a, levels, 0, preconditioner, true); }));
    solution.push_back(detail::seconds_of(on, [&] { solve_on(on, loop); }));
    if (k > 0) continue;
    for (auto* times : {&assembly, &preparation, &solution}) times->clear();
  }
  measured.result = linear_result(on, v);
  if (step != nullptr) detail::read_step(on, v.step, *step);
  if (task.repeats == 0) return measured;
  measured.assembly_seconds = median(assembly);
  measured.preconditioner_seconds = median(preparation);
  measured.solve_seconds = median(solution);

  const auto multiply_on = [&](auto& executor) {
    multiply_tangent(executor, a, level, v.direction.const_view(), v.product.view());
  };
  constexpr int products = 20;
  std::vector<double> of_products;
  for (int k = 0; k <= task.repeats; ++k) {
    const double seconds = detail::seconds_of(on, [&] {
      for (int p = 0; p < products; ++p) multiply_on(on);
    });
    if (k > 0) of_products.push_back(seconds / products);
  }
  measured.product_seconds = median(of_products);

  ByteCounter<typename On::Space> counter;
  typename decltype(counter)::Loop counted;
  multiply_on(counter);
  measured.product_bytes = counter.bytes();
  solve_on(counter, counted);
  measured.iteration_bytes = counted.bytes;
  return measured;
}

}  // namespace physgen::fem
