// Quasistatic equilibrium of an elastic body on linear tets: the solver as programs use it, whatever it runs on.
#pragma once

#include <fem/mesh/boundary.h>
#include <fem/solver/assembled_stiffness.h>
#include <fem/solver/linear_measurement.h>
#include <fem/solver/mesh_level.h>
#include <fem/solver/settings.h>
#include <physgen/config.h>

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace physgen::fem {

/// A plane, frictionless and rigid, that the body's surface cannot pass without force: a node behind it by d has the
/// energy k A d^2 / 2, k being SolverSettings::plane_stiffness and A its share of the surface at rest. Nodes that
/// cannot move along the normal are not pushed.
struct RigidPlane {
  Point normal;       ///< of length 1, towards the body
  double offset = 0;  ///< normal . x of its points at a load of 0 [m]
  double travel = 0;  ///< along the normal at a load of 1, in proportion to the load [m]
};

/// The contact of a plane and the body.
struct PlaneContact {
  double force = 0;  ///< on the body along the normal [N]
  double depth = 0;  ///< how far the surface is behind the plane at most [m]; 0 where it does not touch
};

/// A pressure that follows the surface: against the outward normal of each face as it is, over its area as it is.
struct FollowingPressure {
  std::vector<Face> faces;  ///< of the surface of the finest mesh; corners counter-clockwise, seen from outside
  double pressure = 0;      ///< at a load of 1 [Pa]
};

/// The prescribed motion and the forces at the nodes of the finest mesh, at a load of 1; both grow in proportion to the
/// load. MeshLevel::fixed says which components are prescribed.
struct Loading {
  std::vector<Point> motion;  ///< of prescribed components from their rest positions [m]; one per node
  std::vector<Point> forces;  ///< external [N]; one per node, or none
  std::vector<RigidPlane> planes = {};
  std::vector<FollowingPressure> pressures = {};
};

/// Positions of all levels on which equilibrium is solved, finest first: all that a solve goes on from.
struct SolverState {
  double load = 0;
  bool is_equilibrium = true;  ///< else a solve to this load begins there
  std::vector<std::vector<Point>> positions;
};

/// Where nodes are in equilibrium, and the forces on them.
struct NodeState {
  std::vector<Point> positions;  ///< [m]
  std::vector<Point> forces;     ///< as of QuasistaticSolver::forces() [N]
  std::vector<PlaneContact> planes;
};

/// Finds equilibria of one body, along growing loads.
class EquilibriumSolver {
 public:
  virtual ~EquilibriumSolver() = default;

  /// Goes from the last equilibrium to that of a load. Where Newton's method does not get there, the increment is
  /// halved, up to settings.most_bisections times.
  /// @param report called after each Newton step, with the level (0: the finest)
  /// @return of the finest level, with the sums of all increments; when the status is not `converged`, the positions
  /// are those of the last load that was reached, load()
  virtual NewtonResult solve_to(double load, const std::function<void(std::size_t, const NewtonStep&)>& report) = 0;

  /// Replaces the loading, so that a load of 1 is another; the body stays where it is, and the next solve goes on from
  /// there. Prescribed components remain those that the levels have.
  /// @throw Error when the loading is not one of the finest mesh; when it has rigid planes, or the one before had; or
  /// when pressures that follow the surface push other faces than before
  virtual void set_loading(const Loading& loading) = 0;

  [[nodiscard]] virtual double load() const = 0;
  [[nodiscard]] virtual std::vector<Point> positions() const = 0;  ///< of the finest mesh [m]
  /// Forces on the finest mesh's nodes at their positions [N], elastic, external and of planes: in equilibrium 0 to
  /// tolerance in free components, and minus the reaction in prescribed ones.
  [[nodiscard]] virtual std::vector<Point> forces() = 0;
  /// The same load's equilibrium on the next coarser mesh, where nested iteration has found one: how far it is from the
  /// finest mesh's is an estimate of the error of the finest (linear tets converge with first order at edges of
  /// plates).
  [[nodiscard]] virtual std::optional<NodeState> coarser_equilibrium() { return std::nullopt; }
  /// The contact of each plane with the finest mesh at its positions.
  [[nodiscard]] virtual std::vector<PlaneContact> plane_contacts() { return {}; }
  /// Per tet of the finest mesh, by columns [Pa]: first Piola-Kirchhoff stress, with the pressure of its patch or of
  /// its nodes where volumes are averaged; of make_linear_solver() the stress of small strain.
  [[nodiscard]] virtual std::vector<std::array<double, 9>> stresses() = 0;
  [[nodiscard]] virtual index_t bytes() const = 0;  ///< of arrays in the memory of the device that is used

  [[nodiscard]] virtual SolverState state() const = 0;
  /// @throw Error when the state is not of these meshes, or a number in it is not finite; this solver is then as before
  virtual void restore(const SolverState& state) = 0;
};

/// Solves by Newton's method.
class QuasistaticSolver : public EquilibriumSolver {
 public:
  /// Moves the free nodes of the finest mesh, such as to random positions. The next solve begins there; where tets are
  /// inverted or flat there, on the straight way from rest, before the first of them is flat.
  /// @throw Error when there is not one finite position per node
  virtual void set_positions(std::span<const Point> positions) = 0;

  /// The tangent of the finest mesh at its positions, assembled.
  /// @throw Error with the matrix-free product, which forms no blocks
  [[nodiscard]] virtual AssembledStiffness stiffness() = 0;
  /// Solves K dx = -force on the finest mesh with the tangent at its positions, as often as the task says, for
  /// measurements and tests. Prescribed components of the force [N] count for nothing, and are 0 in the step.
  virtual LinearMeasurement measure_linear(std::span<const Point> force, const LinearTask& task,
                                           std::vector<Point>* step) = 0;
  /// One such solve. @return sqrt(r . z) over its first value
  LinearResult solve_linear(std::span<const Point> force, double tolerance, std::vector<Point>* step) {
    return measure_linear(force, {.tolerance = tolerance}, step).result;
  }
};

/// @param levels finest first; at least one
/// @throw Error naming what is wrong with settings, levels or loading; or when the memory cannot be had
[[nodiscard]] std::unique_ptr<QuasistaticSolver> make_solver(const std::vector<MeshLevel>& levels,
                                                             const Loading& loading, const SolverSettings& settings);

/// A linear elastic body, whose strain is the symmetric part of grad u: right where displacements are small. One linear
/// solve finds an equilibrium, which conjugate gradients in float may need a second one for, down to the tolerance;
/// these are what NewtonResult counts as steps. Of the settings, those of equilibrium on coarser meshes, of Newton's
/// method and of materials count for nothing.
/// @param levels finest first; at least one
/// @throw Error naming what is wrong with settings, levels or loading, averaged volumes and planes among it; or when
/// the memory cannot be had
[[nodiscard]] std::unique_ptr<EquilibriumSolver> make_linear_solver(const std::vector<MeshLevel>& levels,
                                                                    const Loading& loading,
                                                                    const SolverSettings& settings);

/// "cpu", or the name of the GPU that would be used. @throw Error when there is none
[[nodiscard]] std::string device_name(Device device);

}  // namespace physgen::fem
