// Rows of linear_solves: one linear solve of the Truth Cube, K dx = -f, by several methods and to equal residuals.
#include <fem/solver/levels/scattered.h>
#include <fem/solver/quasistatic.h>
#include <physgen/error.h>
#include <truthcube/names.h>
#include <truthcube/run_bytes.h>
#include <truthcube/scene.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>

#include "linear_solves/flags.h"
#include "measure/errors.h"
#include "measure/host.h"
#include "measure/registry.h"
#include "report/format.h"
#ifdef PHYSGEN_BENCH_HAS_CUDA
#include "linear_solves/vendor_solver.h"
#include "measure/cuda.h"
#include "vendor/cusparse_product.h"
#endif

namespace physgen::bench {

namespace {

using fem::Point;
using fem::TangentPrecision;

SolveFlags flags;

/// What one row measures.
struct Solve {
  int cells;
  double poissons_ratio;
  Method method;
  TangentPrecision precision;
  fem::LinearNorm norm;
};

struct Measured {
  fem::LinearMeasurement linear;
  double residual = 0;        ///< |f + K dx| / |f| of free components, in double from the step and the blocks of K
  std::string product, note;  ///< of vendor
};

std::vector<Point> scattered_force(std::size_t nodes) {
  std::vector<Point> force(nodes);
  for (std::size_t n = 0; n < nodes; ++n) {
    for (std::size_t k = 0; k < 3; ++k) force[n][k] = fem::detail::scattered(static_cast<index_t>(3 * n + k), 1);
  }
  return force;
}

/// The precision in which a method is then run: only preconditioners from blocks of edges have matrices of their own to
/// store in half.
TangentPrecision precision_of(Method method, TangentPrecision asked) {
  if (method == vendor) return TangentPrecision::float32;
  return !fem::asks_for(*method, fem::asks::edges) && asked == TangentPrecision::half ? TangentPrecision::float32
                                                                                      : asked;
}

fem::SolverSettings settings_of(const Solve& solve) {
  fem::SolverSettings settings;
  settings.youngs_modulus = 15e3;
  settings.poissons_ratio = solve.poissons_ratio;
  settings.device = flags.device;
  settings.precision = solve.precision;
  settings.nested = false;
  settings.newton.preconditioner.kind = solve.method.value_or(fem::Preconditioner::block_jacobi);
  return settings;
}

/// One cube and Poisson's ratio: what rows behind one another share.
class Body {
 public:
  /// The body of these rows; the one before is gone by then.
  static Body& of(int cells, double poissons_ratio) {
    static std::unique_ptr<Body> last;
    if (last == nullptr || last->cells_ != cells) {
      last.reset();
      last = std::make_unique<Body>(cells);
    }
    if (last->poissons_ratio_ != poissons_ratio) {
      last->solver_.reset();
      last->compressed_.clear();
      last->in_float_ = last->in_double_ = {};
      last->poissons_ratio_ = poissons_ratio;
    }
    return *last;
  }

  explicit Body(int cells) : cells_(cells) {
    truthcube::Options cube;
    cube.cells = cells;
    cube.volume = flags.volume;
    scene_ = truthcube::make_scene(cube, truthcube::make_cube(cube));
    force_ = scattered_force(scene_.levels.front().rest.size());
  }

  [[nodiscard]] Measured measure(const Solve& solve) {
    const bool by_vendor = solve.method == vendor;
    // The solvers in float, or in double, have one stiffness to the bit, whatever the preconditioner.
    fem::AssembledStiffness& stiffness = solve.precision == TangentPrecision::float64 ? in_double_ : in_float_;
    if (!by_vendor || stiffness.nodes.empty()) make(solve);
    if (stiffness.nodes.empty()) stiffness = solver_->stiffness();
    if (by_vendor) solver_.reset();
    const fem::LinearTask task{flags.tolerance, solve.norm, flags.repeats};
    Measured measured;
    std::vector<Point> step;
    if (by_vendor) {
      measured = measure_vendor(stiffness, task, step);
    } else {
      measured.linear = solver_->measure_linear(force_, task, &step);
    }
    require_converged(measured.linear.result);
    measured.residual = fem::relative_residual(stiffness, fixed(), force_, step);
    return measured;
  }

 private:
  [[nodiscard]] const std::vector<std::uint8_t>& fixed() const { return scene_.levels.front().fixed; }

  static void require_converged(const fem::LinearResult& result) {
    if (result.status == fem::LinearStatus::converged) return;
    const char* why = result.status == fem::LinearStatus::running              ? "iterations used up"
                      : result.status == fem::LinearStatus::negative_curvature ? "negative curvature"
                                                                               : "not finite";
    throw Error(std::string("the solve has not converged: ") + why + " after " + std::to_string(result.iterations) +
                " iterations");
  }

  void make(const Solve& solve) {
    if (solver_ != nullptr && made_.method == solve.method && made_.precision == solve.precision) return;
    solver_.reset();
    solver_ = fem::make_solver(scene_.levels, scene_.loading, settings_of(solve));
    made_ = solve;
    if (flags.compression > 0 && compressed_.empty()) {
      if (solver_->solve_to(flags.compression, {}).status != fem::NewtonStatus::converged) {
        solver_.reset();
        throw Error("no equilibrium was found at a compression of " + std::to_string(flags.compression) +
                    "; take a smaller --compress");
      }
      compressed_ = solver_->positions();
    }
    if (!compressed_.empty()) solver_->set_positions(compressed_);
  }

  [[nodiscard]] Measured measure_vendor([[maybe_unused]] const fem::AssembledStiffness& stiffness,
                                        [[maybe_unused]] const fem::LinearTask& task,
                                        [[maybe_unused]] std::vector<Point>& step) const {
#ifdef PHYSGEN_BENCH_HAS_CUDA
    const VendorMeasurement solved = solve_by_vendor(stiffness, fixed(), force_, task, &step);
    return {solved.measured, 0, solved.product, solved.note};
#else
    throw Error("this build has no CUDA; configure it with -DPHYSGEN_CUDA=ON");
#endif
  }

  int cells_;
  double poissons_ratio_ = std::numeric_limits<double>::quiet_NaN();
  truthcube::Scene scene_;
  std::vector<Point> force_, compressed_;
  fem::AssembledStiffness in_float_, in_double_;
  std::unique_ptr<fem::QuasistaticSolver> solver_;
  Solve made_{};
};

/// The time of a copy of as many bytes [s]: of a gigabyte at most, and in proportion.
std::function<double()> copy_of(double bytes) {
  const double part = std::min(bytes, 1e9);
#ifdef PHYSGEN_BENCH_HAS_CUDA
  auto copy = flags.device == fem::Device::cuda ? CudaDevice::copy(part) : HostDevice::copy(part);
#else
  auto copy = HostDevice::copy(part);
#endif
  return [copy = std::move(copy), ratio = bytes / part] { return ratio * copy(); };
}

double median_of(const std::function<double()>& time) {
  time();
  std::vector<double> times(5);
  std::ranges::generate(times, time);
  return median(times);
}

/// What report/truthcube/linear_solves.py reads beside the row's name, time and error.
Accuracy accuracy_of(const Solve& solve, const Measured& measured) {
  const fem::LinearMeasurement& m = measured.linear;
  Accuracy accuracy;
  const double residual = measured.residual, iterations = m.result.iterations;
  accuracy.errors = {residual, residual, residual, residual, 1, 0};
  accuracy.more = {{"cells", solve.cells},
                   {"poisson", solve.poissons_ratio},
                   {"compression", flags.compression},
                   {"tolerance", flags.tolerance},
                   {"iteration_count", iterations},
                   {"setup_ms", m.preconditioner_seconds * 1e3},
                   {"product_ms", m.product_seconds * 1e3},
                   {"product_copy_ms", median_of(copy_of(static_cast<double>(m.product_bytes))) * 1e3},
                   {"product_bytes", static_cast<double>(m.product_bytes)},
                   {"iteration_bytes", static_cast<double>(m.iteration_bytes)}};
  std::string assembly;
  if (solve.method != vendor) {  // which takes K from the solver
    accuracy.more.emplace_back("assembly_ms", m.assembly_seconds * 1e3);
    assembly = format("assembly %.4g ms, ", m.assembly_seconds * 1e3);
  }
  accuracy.note = format("%d iterations, ", m.result.iterations) + assembly +
                  format("set-up %.4g ms", m.preconditioner_seconds * 1e3);
  if (!measured.product.empty()) accuracy.note += "; " + measured.product;
  if (!measured.note.empty()) accuracy.note += "; " + measured.note;
  return accuracy;
}

Case make_case(const Solve& solve) {
  const auto measure = [solve] { return Body::of(solve.cells, solve.poissons_ratio).measure(solve); };
  const auto first = std::make_shared<Measured>(measure());
  const double iteration = static_cast<double>(first->linear.iteration_bytes);
  const double iterations = std::max(first->linear.result.iterations, 1);
  Case made;
  made.fewest = 1;  // a sample is a median
  made.bytes = iterations * iteration;
  made.copy = [copy = copy_of(iteration), iterations] { return iterations * copy(); };
  made.check = [solve, first] { return accuracy_of(solve, *first); };
  made.run = [measure, first, is_first = true]() mutable {
    return std::exchange(is_first, false) ? first->linear.solve_seconds : measure().linear.solve_seconds;
  };
  return made;
}

void add_row(std::vector<Row>& rows, const Solve& solve, const std::vector<truthcube::LevelCounts>& counts) {
  const truthcube::RunBytes bytes = truthcube::bytes_of_run(counts, settings_of(solve));
  const bool on_host = flags.device == fem::Device::cpu;
  Row row;
  row.kernel = "linear_solve";
  row.layout = name_of(solve.method);
  row.storage = name_of(solve.precision);
  row.space = on_host ? "host" : "cuda";
  row.set = name_of(flags.volume) + "_" + truthcube::number(solve.poissons_ratio) + "_" + name_of(solve.norm);
  row.objects = counts.front().tets;
  row.host_bytes = static_cast<double>(bytes.lists + (on_host ? bytes.solver : 0));
  row.device_bytes = static_cast<double>(on_host ? 0 : bytes.solver);
  row.make = [solve] { return make_case(solve); };
  rows.push_back(std::move(row));
}

/// The cells of the smallest cube with as many tets, an even number.
int cells_of(const Sizes& sizes) {
  int cells = sizes.given ? 2 : 16;
  while (sizes.given && 6.0 * cells * cells * cells < static_cast<double>(sizes.host)) cells += 2;
  return cells;
}

void add_rows(std::vector<Row>& rows, const Sizes& sizes, fem::Device device) {
  if (flags.device != device) return;
  SolveFlags chosen = flags;
  if (chosen.cells.empty()) chosen.cells = {cells_of(sizes)};
  check(chosen);
#ifdef PHYSGEN_BENCH_HAS_CUDA
  if (!missing_cusparse().empty()) std::erase(chosen.methods, vendor);
#endif
  for (const int cells : chosen.cells) {
    const auto counts = truthcube::count_cube(cells, chosen.volume);
    for (const double poissons_ratio : chosen.poissons_ratios) {
      for (const Method method : chosen.methods) {
        std::vector<TangentPrecision> done;
        for (const TangentPrecision asked : chosen.precisions) {
          const TangentPrecision precision = precision_of(method, asked);
          if (std::ranges::find(done, precision) != done.end()) continue;
          done.push_back(precision);
          for (const fem::LinearNorm norm : chosen.norms) {
            add_row(rows, {cells, poissons_ratio, method, precision, norm}, counts);
          }
        }
      }
    }
  }
}

[[maybe_unused]] const bool group =
    add(Group{"linear_solves", "one linear solve of the Truth Cube by several methods, see linear_solves/README.md", 9,
              ".", "", "", [](CLI::App& app) { add_solve_flags(app, flags); }});
[[maybe_unused]] const bool host =
    add(Part{"linear_solves", 0, "linear_solve", "host",
             [](auto& rows, const Sizes& sizes) { add_rows(rows, sizes, fem::Device::cpu); }});
[[maybe_unused]] const bool cuda =
    add(Part{"linear_solves", 0, "linear_solve", "cuda",
             [](auto& rows, const Sizes& sizes) { add_rows(rows, sizes, fem::Device::cuda); }});

}  // namespace

}  // namespace physgen::bench
