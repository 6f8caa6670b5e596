// Motion of an elastic body on linear tets: the solvers as programs use them, whatever they run on.
#pragma once

#include <fem/solver/quasistatic.h>

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace physgen::fem {

struct DynamicSettings {
  /// Material, device and precision; the implicit solver takes the rest of them, too. The explicit one computes tets in
  /// double where the precision is double, else in float.
  SolverSettings solver;
  double density = 1000;  ///< [kg/m^3]
  /// Force -damping m v on each node [1/s]. In proportion to mass: then damping has a potential in each time step, adds
  /// to the diagonal of the tangent alone, and leaves the stable step of explicit steps as it is, none of which holds
  /// in proportion to stiffness, where a tangent would have to be kept as well. It damps slow motion most, rigid motion
  /// too: a mode of the frequency omega by the ratio damping / (2 omega).
  double damping = 0;
  /// Explicit steps on CUDA: whether forces on nodes are sums in a fixed order, so that motions have the same bits on
  /// every run. It takes longer, and 20 numbers more per tet. On the CPU the order is always fixed.
  bool fixed_order = false;
};

/// Measures of a state of motion.
struct MotionMeasure {
  double kinetic = 0;  ///< energy [J]
  double elastic = 0;  ///< energy [J]
  Point momentum{};    ///< [kg m/s]

  [[nodiscard]] bool is_finite() const;
};

/// Moves one body in time, from rest. Positions, velocities and sums over nodes are in double.
class DynamicSolver {
 public:
  virtual ~DynamicSolver() = default;

  /// Takes one time step.
  /// @param length [s]
  /// @param load at its end: what Loading's motion and forces are multiplied by
  /// @return of the implicit solver what Newton's method came to; where that is not `converged` the state is as before.
  /// The explicit one always says `converged`; measure() tells whether its numbers are finite
  /// @throw Error when the length is not a positive number, or the load is not finite
  virtual NewtonResult step(double length, double load) = 0;

  [[nodiscard]] virtual double time() const = 0;                    ///< the sum of all steps [s]
  [[nodiscard]] virtual std::vector<Point> positions() const = 0;   ///< of nodes [m]
  [[nodiscard]] virtual std::vector<Point> velocities() const = 0;  ///< of nodes [m/s]
  /// Moves nodes, such as to where a motion begins. Prescribed components go on to where the load takes them.
  /// @throw Error when there is not one finite vector per node
  virtual void set_positions(std::span<const Point> positions) = 0;
  virtual void set_velocities(std::span<const Point> velocities) = 0;

  /// Forces on nodes [N], elastic, external and of planes, without inertia and damping: at prescribed components minus
  /// what holds them, but for their inertia.
  [[nodiscard]] virtual std::vector<Point> forces() = 0;
  /// Per tet: first Piola-Kirchhoff stress by columns [Pa].
  [[nodiscard]] virtual std::vector<std::array<double, 9>> stresses() = 0;
  [[nodiscard]] virtual MotionMeasure measure() = 0;
  /// The contact of each plane with the nodes at their positions.
  [[nodiscard]] virtual std::vector<PlaneContact> plane_contacts() { return {}; }
  [[nodiscard]] virtual index_t bytes() const = 0;  ///< of arrays in the memory of the device that is used
};

/// Backward Euler: each step is an equilibrium with inertia, found by the same Newton's method, on the finest level. It
/// is stable with steps of any length, and damps what they do not resolve: a motion of the frequency omega by the
/// factor 1 / sqrt(1 + (omega dt)^2) in a step. Products are assembled.
/// @param levels finest first; at least one
/// @throw Error naming what is wrong with settings, levels or loading; or when the memory cannot be had
[[nodiscard]] std::unique_ptr<DynamicSolver> make_implicit_solver(const std::vector<MeshLevel>& levels,
                                                                  const Loading& loading,
                                                                  const DynamicSettings& settings);

}  // namespace physgen::fem
