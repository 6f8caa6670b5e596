// Everything that one may choose of the solver, and what its steps report; plain values.
#pragma once

#include <fem/solver/preconditioner_rows.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace physgen::fem {

struct LevelGraph;

/// The reason for which conjugate gradients ended.
enum class LinearStatus {
  running,
  converged,
  negative_curvature,  ///< p . K p >= 0: K is not negative definite; dx is what was found before
  not_finite,          ///< a number was NaN or infinite
};

/// The result of a linear solve.
struct LinearResult {
  int iterations = 0;
  LinearStatus status = LinearStatus::running;
  double reduction = 1;  ///< of sqrt(r . z)
};

/// A way to multiply the tangent with a vector.
enum class Product {
  assembled,    ///< from blocks of nodes and edges, of which the symmetric half is stored
  matrix_free,  ///< from the tangents of tets and patches themselves: no blocks of edges, nor lists of them
};

/// The kind of preconditioner.
struct PreconditionerSettings {
  Preconditioner kind = Preconditioner::multigrid;
  int degree = 2;    ///< of the Chebyshev polynomial before and after each coarser level
  double low = 0.1;  ///< what it smooths: eigenvalues from low to 1 times the largest
  int first_power_steps = 10, next_power_steps = 2;
};

struct NewtonSettings {
  /// The bound of |force on free components| / |forces that hold the body|, those on prescribed components and of rigid
  /// planes, now or at the last equilibrium.
  double tolerance = 1e-4;
  double absolute_tolerance = 0;  ///< [N]; where above 0, in place of the relative one
  int most_steps = 60;            ///< of Newton's method, in one load increment
  int most_iterations = 20000;    ///< of conjugate gradients, in one step
  double least_forcing = 1e-3;    ///< tolerance of linear solves, from here while convergence is quadratic
  double most_forcing = 1e-2;  ///< to here, and from a coarser mesh; looser in the last step, as the tolerance allows
  bool line_search = true;
  int most_halvings = 12;  ///< of a step, until the energy falls
  /// A full step may raise the energy, if no tet is inverted and the next makes up for it.
  bool full_steps_first = true;
  int most_returns = 8;  ///< towards rest, where nothing pulls and yet tets are inverted or flat
  Product product = Product::assembled;
  PreconditionerSettings preconditioner;

  // A solver fills these in.
  double start_load = 0;         ///< of the equilibrium that a first linear solve with an increment goes on from
  double last_reaction = 0;      ///< [N]: |forces that hold the body| at the last equilibrium
  double rounding_force = 0;     ///< [N]: what positions' rounding makes of the forces on all nodes
  bool all_prescribed = false;   ///< no component is free
  bool is_interpolated = false;  ///< positions are those of a coarser mesh's equilibrium
  bool start_is_given = false;   ///< positions were set from outside; where tets are inverted, it begins nearer to rest
};

/// The record of one Newton step.
struct NewtonStep {
  int number = 0;         ///< from 1
  double residual = 0;    ///< |force on free components| / |forces that hold the body| after it
  double energy = 0;      ///< [J] after it
  double smallest_J = 0;  ///< after it
  int iterations = 0;     ///< of conjugate gradients
  int halvings = 0;
  bool filtered = false;  ///< the tangent was made positive semidefinite
  double seconds = 0;
};

enum class NewtonStatus { converged, too_many_steps, no_descent, not_finite, linear_solver };

struct NewtonResult {
  NewtonStatus status = NewtonStatus::converged;
  int steps = 0, iterations = 0, halvings = 0, filtered = 0;  ///< of the finest level
  int coarse_steps = 0, coarse_iterations = 0;                ///< of all coarser levels
  int returns = 0;                                            ///< towards rest, from inverted or flat tets
  int bisections = 0;                                         ///< of the load's increment
  double residual = 0, energy = 0, smallest_J = 0;
  double reaction = 0;  ///< |forces that hold the body| [N]
};

enum class Device { cpu, cuda };

/// The tangent and the linear solver; states, forces and energies are in double whatever is chosen.
enum class TangentPrecision {
  half,  ///< computed in float; the preconditioner's matrices stored in half
  float32,
  float64,
};

/// The constants of an elastic material for small strain.
struct ElasticConstants {
  double youngs_modulus;  ///< [Pa]
  double poissons_ratio;
};

struct SolverSettings {
  std::string material = "neo-hookean";  ///< one of material_names()
  double youngs_modulus = 1;             ///< [Pa]
  double poissons_ratio = 0.45;
  /// Where the body has several materials, which are of one model: the constants of each, in place of these two; and
  /// MeshLevel::material_ends says which tets have them.
  std::vector<ElasticConstants> materials = {};
  Device device = Device::cpu;
  TangentPrecision precision = TangentPrecision::half;
  bool nested = true;  ///< equilibrium on coarser meshes first, where there are
  /// The bound of the residual on coarser meshes, where newton.tolerance is smaller: the next finer mesh changes more
  /// than that.
  double coarser_tolerance = 1e-2;
  int coarsest_nested = 2;  ///< levels that are never solved on, from the coarsest
  int most_bisections = 6;
  /// The stiffness of rigid planes, per area, in Young's moduli over the mean spacing of a level's nodes. The surface
  /// stays behind a plane by the pressure over Young's modulus times that spacing over this. Up to 1000 Newton's method
  /// takes few more steps than without planes; at 1e4 nodes that touch and leave in turn shorten many, and above it may
  /// fail.
  double plane_stiffness = 100;
  NewtonSettings newton;
  /// Called once while a solver is made, when the host's lists are ready and before the device is used first: a program
  /// that makes the device's context on another thread waits for it here. What it throws ends the making.
  std::function<void()> before_device = {};
  /// Graphs of the levels that the solver is given, as make_counted_graphs() makes them, where a program has counted
  /// their entries: the solver takes them, once, and makes none of its own. Levels must not change in between.
  std::shared_ptr<std::vector<LevelGraph>> graphs = {};
};

/// Those of each material: one or more.
[[nodiscard]] std::vector<ElasticConstants> constants_of(const SolverSettings& settings);

/// `total` becomes the result of the increment behind it, with the numbers of steps of both.
void add_increment(NewtonResult& total, NewtonResult result);

/// Levels that a solver uses, and those of them on which equilibrium is solved.
struct UsedLevels {
  std::size_t used, solved;
};
/// @param meshes how many of the levels are meshes; the rest belong to a background grid
[[nodiscard]] UsedLevels used_levels(const SolverSettings& settings, std::size_t levels, std::size_t meshes);

/// Names of the materials, as SolverSettings has them.
[[nodiscard]] const std::vector<std::string>& material_names();
/// Whether a material's volume can be averaged, over patches or at nodes. @throw Error when there is no such material
[[nodiscard]] bool can_average_volume(const std::string& material);

}  // namespace physgen::fem
