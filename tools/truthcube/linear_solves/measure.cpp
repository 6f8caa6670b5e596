#include "measure.h"

#include <fem/solver/levels/scattered.h>
#include <fem/solver/quasistatic.h>
#include <physgen/error.h>
#include <truthcube/memory.h>
#include <truthcube/run_bytes.h>
#include <truthcube/scene.h>

#include <algorithm>
#include <memory>
#include <span>

#include "copies.h"
#ifdef PHYSGEN_TRUTHCUBE_HAS_CUDA
#include "cusparse_product.h"
#include "vendor_solver.h"
#endif

namespace physgen::truthcube {

namespace {

using fem::Point;
using fem::TangentPrecision;

std::vector<Point> scattered_force(std::size_t nodes) {
  std::vector<Point> force(nodes);
  for (std::size_t n = 0; n < nodes; ++n) {
    for (std::size_t k = 0; k < 3; ++k) force[n][k] = fem::detail::scattered(static_cast<index_t>(3 * n + k), 1);
  }
  return force;
}

fem::Preconditioner preconditioner_of(Method method) {
  if (method == Method::multigrid) return fem::Preconditioner::multigrid;
  if (method == Method::schwarz) return fem::Preconditioner::schwarz;
  return method == Method::none ? fem::Preconditioner::none : fem::Preconditioner::block_jacobi;
}

/// The precision in which a method is then run: only multigrid and Schwarz have matrices of their own to store in half.
TangentPrecision precision_of(Method method, TangentPrecision asked) {
  if (method == Method::vendor) return TangentPrecision::float32;
  const bool stores = method == Method::multigrid || method == Method::schwarz;
  return !stores && asked == TangentPrecision::half ? TangentPrecision::float32 : asked;
}

/// One cube and Poisson's ratio: its solvers, one after the other, and what they share.
class Body {
 public:
  Body(const LinearOptions& options, const Scene& scene, double poissons_ratio)
      : options_(options),
        scene_(scene),
        poissons_ratio_(poissons_ratio),
        force_(scattered_force(scene.levels.front().rest.size())) {}

  /// Measures one method in one precision. @param rows for each norm one; what is measured is filled in
  void measure(Method method, TangentPrecision precision, std::span<LinearRow> rows) {
    const bool by_vendor = method == Method::vendor;
    fem::AssembledStiffness& stiffness = stiffness_of(precision);
    std::unique_ptr<fem::QuasistaticSolver> solver;
    if (!by_vendor || stiffness.nodes.empty()) solver = make(preconditioner_of(method), precision);
    if (stiffness.nodes.empty()) stiffness = solver->stiffness();
    if (by_vendor) solver.reset();
    for (LinearRow& row : rows) {
      const fem::LinearTask task{options_.tolerance, row.norm, options_.repeats};
      std::vector<Point> step;
      if (by_vendor) {
        measure_vendor(row, stiffness, task, step);
      } else {
        row.measured = solver->measure_linear(force_, task, &step);
      }
      row.residual = fem::relative_residual(stiffness, fixed(), force_, step);
      if (!options_.copies) continue;
      row.product_copy_seconds = seconds_of_copy(options_.device, row.measured.product_bytes);
      row.iteration_copy_seconds = seconds_of_copy(options_.device, row.measured.iteration_bytes);
    }
  }

 private:
  [[nodiscard]] const std::vector<std::uint8_t>& fixed() const { return scene_.levels.front().fixed; }
  /// The stiffness of the solvers in float or in double, empty until there was one: with one precision, whatever the
  /// preconditioner, it has the same bits.
  [[nodiscard]] fem::AssembledStiffness& stiffness_of(TangentPrecision precision) {
    return precision == TangentPrecision::float64 ? in_double_ : in_float_;
  }

  [[nodiscard]] std::unique_ptr<fem::QuasistaticSolver> make(fem::Preconditioner kind, TangentPrecision precision) {
    fem::SolverSettings settings;
    settings.youngs_modulus = 15e3;
    settings.poissons_ratio = poissons_ratio_;
    settings.device = options_.device;
    settings.precision = precision;
    settings.nested = false;
    settings.newton.preconditioner.kind = kind;
    auto solver = fem::make_solver(scene_.levels, scene_.loading, settings);
    if (options_.compression > 0 && compressed_.empty()) {
      if (solver->solve_to(options_.compression, {}).status != fem::NewtonStatus::converged) {
        throw Error("no equilibrium was found at a compression of " + std::to_string(options_.compression));
      }
      compressed_ = solver->positions();
    }
    if (!compressed_.empty()) solver->set_positions(compressed_);
    return solver;
  }

  void measure_vendor([[maybe_unused]] LinearRow& row, [[maybe_unused]] const fem::AssembledStiffness& stiffness,
                      [[maybe_unused]] const fem::LinearTask& task, [[maybe_unused]] std::vector<Point>& step) const {
#ifdef PHYSGEN_TRUTHCUBE_HAS_CUDA
    const VendorMeasurement vendor = solve_by_vendor(stiffness, fixed(), force_, task, &step);
    row.measured = vendor.measured;
    row.measured.assembly_seconds = LinearRow::none;
    row.vendor_product = vendor.product;
    row.note = vendor.note;
#else
    throw Error("this build has no CUDA");
#endif
  }

  const LinearOptions& options_;
  const Scene& scene_;
  double poissons_ratio_;
  std::vector<Point> force_, compressed_;
  fem::AssembledStiffness in_float_, in_double_;
};

/// With what all rows of a cube share.
LinearRow blank_row(const LinearOptions& options, const Scene& scene, const std::string& command) {
  LinearRow row;
  row.nodes = index_t{scene.levels.front().mesh.nodes};
  row.tets = static_cast<index_t>(scene.levels.front().mesh.tets.size());
  row.volume = options.volume;
  row.compression = options.compression;
  row.tolerance = options.tolerance;
  row.device = fem::device_name(options.device);
  row.command = command;
  return row;
}

std::string missing_vendor() {
#ifdef PHYSGEN_TRUTHCUBE_HAS_CUDA
  return missing_cusparse();
#else
  return "this build has no CUDA";
#endif
}

/// Refuses a solver with the method that takes most memory, before it is made, if it does not fit.
void require_memory_for(const LinearOptions& options, int cells) {
  const auto counts = count_cube(cells, options.volume);
  const std::string who = "a cube of " + std::to_string(cells) + "^3 cells";
  for (const Method method : options.methods) {
    fem::SolverSettings settings;
    settings.device = options.device;
    settings.nested = false;
    settings.newton.preconditioner.kind = preconditioner_of(method);
    settings.precision = precision_of(method, std::ranges::max(options.precisions));
    const RunBytes bytes = bytes_of_run(counts, settings);
    if (options.device == fem::Device::cuda)
      require_memory(who, bytes.solver, "the GPU", cuda_memory(), "fewer --cells");
    const std::int64_t on_host = bytes.lists + (options.device == fem::Device::cuda ? 0 : bytes.solver);
    require_memory(who, on_host, "this machine", host_memory(), "fewer --cells");
  }
}

Scene make_cube_scene(const LinearOptions& options, int cells) {
  Options cube;
  cube.cells = cells;
  cube.volume = options.volume;
  return make_scene(cube, make_cube(cube));
}

}  // namespace

std::vector<LinearRow> measure(const LinearOptions& options, const std::string& command,
                               const std::function<void(const LinearRow&)>& report,
                               const std::function<void(const std::string&)>& say) {
  std::vector<Method> methods = options.methods;
  if (std::ranges::find(methods, Method::vendor) != methods.end()) {
    if (const std::string missing = missing_vendor(); !missing.empty()) {
      say("vendor: " + missing);
      std::erase(methods, Method::vendor);
    }
  }
  std::vector<LinearRow> rows;
  for (const int cells : options.cells) {
    require_memory_for(options, cells);
    const Scene scene = make_cube_scene(options, cells);
    for (const double poissons_ratio : options.poissons_ratios) {
      Body body(options, scene, poissons_ratio);
      for (const Method method : methods) {
        std::vector<TangentPrecision> done;
        for (const TangentPrecision asked : options.precisions) {
          const TangentPrecision precision = precision_of(method, asked);
          if (std::ranges::find(done, precision) != done.end()) continue;
          done.push_back(precision);
          std::vector<LinearRow> of_norms;
          for (const fem::LinearNorm norm : options.norms) {
            of_norms.push_back(blank_row(options, scene, command));
            LinearRow& row = of_norms.back();
            row.cells = cells;
            row.poissons_ratio = poissons_ratio;
            row.method = method;
            row.precision = precision;
            row.norm = norm;
          }
          body.measure(method, precision, of_norms);
          for (LinearRow& row : of_norms) {
            report(row);
            if (!row.note.empty()) say("vendor: " + row.note);
            rows.push_back(std::move(row));
          }
        }
      }
    }
  }
  return rows;
}

}  // namespace physgen::truthcube
