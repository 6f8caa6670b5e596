#include <fem/mesh/geometry.h>
#include <fem/mesh/stages.h>
#include <fem/solver/hierarchy/hierarchy.h>
#include <fem/solver/number_text.h>
#include <fem/solver/solvers/require.h>
#include <physgen/detail/first_index.h>
#include <physgen/error.h>

#include <algorithm>
#include <cmath>

namespace physgen::fem {

namespace {

/// "(0, nan, 0.01)"
std::string vector_text(const Point& x) {
  return "(" + number_text(x[0]) + ", " + number_text(x[1]) + ", " + number_text(x[2]) + ")";
}

bool is_finite(const Point& x) {
  return std::ranges::all_of(x, [](double value) { return std::isfinite(value); });
}

}  // namespace

void require_positive(const std::string& what, double value) {
  if (!(value > 0) || !std::isfinite(value)) {
    throw Error(what + " is " + number_text(value) + " and must be a positive number");
  }
}

void require_rest(std::size_t l, const MeshLevel& level) {
  if (level.rest.size() != static_cast<std::size_t>(level.mesh.nodes)) return;  // which the level's arrays refuse
  InStage stage("checks of tets");
  stage.moves(level.rest, level.mesh.tets);
  const std::string where = "level " + std::to_string(l) + ": ";
  const auto at = [](index_t i) { return static_cast<std::size_t>(i); };
  const auto nodes = static_cast<index_t>(level.rest.size()), tets = static_cast<index_t>(level.mesh.tets.size());
  const index_t stray = physgen::detail::first_index(nodes, [&](index_t n) { return !is_finite(level.rest[at(n)]); });
  if (stray < nodes) {
    throw Error(where + "the rest position of node " + std::to_string(stray) + " is " +
                vector_text(level.rest[at(stray)]) + ": give finite coordinates [m]");
  }
  const auto volumes = [&](index_t t) { return six_volumes(level.mesh.tets[at(t)], level.rest); };
  const index_t flat = physgen::detail::first_index(tets, [&](index_t t) { return !(volumes(t) > 0); });
  if (flat == tets) return;
  throw Error(where + "tet " + std::to_string(flat) + " has the volume " + number_text(volumes(flat) / 6) +
              " m^3 at rest and needs a positive one: exchange two of its corners, or mesh again");
}

// Limits were found with cubes of 4^3 cells and moduli from 1e-30 to 1e36 over sides from 1e-10 to 1e8: within them
// float finds the equilibria of double, in as many steps.
void require_single_range(const MeshLevel& level, const SolverSettings& settings) {
  if (settings.precision == TangentPrecision::float64) return;
  if (level.rest.size() != static_cast<std::size_t>(level.mesh.nodes)) return;
  const double h = mean_spacing(level.mesh, level.rest);
  const double modulus = settings.youngs_modulus, per_area = modulus / h / h, work = modulus * h * h * h;
  if (!(modulus > 0) || (per_area >= 1e-35 && per_area <= 1e30 && work >= 1e-28 && work <= 1e33)) return;
  throw Error("a Young's modulus of " + number_text(modulus) + " Pa over tets of " + number_text(h) +
              " m is out of range for float: take double precision, or units in which both are nearer to 1");
}

namespace {

/// @param what "the external force": of node 7 it is (nan, 0, 0)
void require_finite(const std::string& what, std::span<const Point> vectors) {
  const auto stray = std::ranges::find_if_not(vectors, is_finite);
  if (stray == vectors.end()) return;
  throw Error(what + " of node " + std::to_string(stray - vectors.begin()) + " is " + vector_text(*stray) +
              ": give finite components");
}

void require_planes(const std::vector<RigidPlane>& planes) {
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const RigidPlane& plane = planes[p];
    const std::string which = "rigid plane " + std::to_string(p);
    const double length = std::hypot(plane.normal[0], plane.normal[1], plane.normal[2]);
    if (!(std::abs(length - 1) <= 1e-9)) {
      throw Error(which + ": its normal has a length of " + std::to_string(length) + " and must have 1");
    }
    if (!std::isfinite(plane.offset) || !std::isfinite(plane.travel)) {
      throw Error(which + ": its offset is " + number_text(plane.offset) + " and its travel " +
                  number_text(plane.travel) + ": give finite lengths [m]");
    }
  }
}

}  // namespace

void require_vectors(const std::string& what, std::span<const Point> vectors, std::size_t nodes) {
  if (vectors.size() != nodes) {
    throw Error(what + " is given for " + std::to_string(vectors.size()) + " nodes of " + std::to_string(nodes) +
                ": give one vector for each node");
  }
  require_finite(what, vectors);
}

void require_loading(const MeshLevel& level, const Loading& loading) {
  const auto nodes = static_cast<std::size_t>(level.mesh.nodes);
  require_vectors("the motion of prescribed components", loading.motion, nodes);
  if (!loading.forces.empty()) require_vectors("the external force", loading.forces, nodes);
  require_planes(loading.planes);
}

void refuse_cuda() { throw Error("this build has no CUDA: configure it with -DPHYSGEN_CUDA=ON, or solve on the CPU"); }

bool MotionMeasure::is_finite() const {
  return std::isfinite(kinetic) && std::isfinite(elastic) && std::isfinite(momentum[0]) && std::isfinite(momentum[1]) &&
         std::isfinite(momentum[2]);
}

void require_step(double length, double load) {
  require_positive("the length of a time step", length);
  if (!std::isfinite(load)) {
    throw Error("the load at the end of a time step is " + number_text(load) + " and must be a finite number");
  }
}

void require_state(const SolverState& state, std::span<const std::size_t> nodes) {
  if (!std::isfinite(state.load)) {
    throw Error("the load of a state is " + number_text(state.load) + " and must be a finite number");
  }
  if (state.positions.size() != nodes.size()) {
    throw Error("the state has " + std::to_string(state.positions.size()) + " levels, but this solver solves on " +
                std::to_string(nodes.size()) + "; restore a state of the same levels and settings");
  }
  for (std::size_t l = 0; l < nodes.size(); ++l) {
    const std::vector<Point>& given = state.positions[l];
    if (given.size() != nodes[l]) {
      throw Error("level " + std::to_string(l) + " has " + std::to_string(nodes[l]) +
                  " nodes, but that of the state has " + std::to_string(given.size()) +
                  "; restore a state of the same meshes");
    }
    require_finite("level " + std::to_string(l) + " of a state: the position", given);
  }
}

void require_plain(const char* who, const MeshLevel& level, const Loading& loading) {
  require_loading(level, loading);
  if (!loading.planes.empty())
    throw Error(std::string(who) + " cannot have rigid planes; prescribe the motion of nodes");
  if (!level.patches.nodes.empty() || level.averages_at_nodes) {
    throw Error(std::string(who) + " takes the change of volume tet by tet; do not average volumes");
  }
}

void require_motion(const DynamicSettings& settings) {
  require_positive("the density", settings.density);
  if (!(settings.damping >= 0) || !std::isfinite(settings.damping)) {
    throw Error("the damping is " + number_text(settings.damping) + " and must be 0 or a positive number");
  }
}

}  // namespace physgen::fem
