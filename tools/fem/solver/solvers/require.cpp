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

void require_least(const char* what, int value, int least) {
  if (value < least) {
    throw Error(std::string(what) + " is " + std::to_string(value) + " and must be " + std::to_string(least) +
                " or more");
  }
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
  if (level.axes) {
    throw Error(where +
                "components are prescribed along other axes than x, y, z (MeshLevel::axes): set them on the finest "
                "level, and solve for equilibria; motions take x, y, z alone");
  }
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

void require_materials(const std::vector<MeshLevel>& levels, const SolverSettings& settings) {
  for (const ElasticConstants& constants : constants_of(settings)) {
    SolverSettings one = settings;
    one.youngs_modulus = constants.youngs_modulus;
    require_single_range(levels.front(), one);
  }
  const std::size_t count = settings.materials.size();
  if (count > 0 && settings.newton.product == Product::matrix_free) {
    throw Error("several materials require the assembled product; take it, or give the body one material");
  }
  for (std::size_t l = 0; l < levels.size() && !levels[l].is_grid(); ++l) {
    const std::vector<Index>& ends = levels[l].material_ends;
    const std::string where = "level " + std::to_string(l) + ": ";
    if (ends.size() != count) {
      throw Error(where + "its tets have " + std::to_string(ends.size()) + " materials, and the settings have " +
                  std::to_string(count) + "; give the same number");
    }
    if (count == 0) continue;
    if (!std::ranges::is_sorted(ends) || ends.front() < 0 ||
        ends.back() != static_cast<Index>(levels[l].mesh.tets.size())) {
      throw Error(where + "the ends of materials among its " + std::to_string(levels[l].mesh.tets.size()) +
                  " tets must ascend to that number");
    }
    if (levels[l].averages_at_nodes) {
      throw Error(where + "volumes averaged at nodes would mix the materials around a node; average them over patches");
    }
  }
}

SolverSettings with_largest(SolverSettings settings) {
  for (std::size_t m = 0; m < settings.materials.size(); ++m) {
    const auto& [young, poisson] = settings.materials[m];
    settings.youngs_modulus = m == 0 ? young : std::max(settings.youngs_modulus, young);
    settings.poissons_ratio = m == 0 ? poisson : std::max(settings.poissons_ratio, poisson);
  }
  return settings;
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

namespace {

void require_loading(std::size_t nodes, const Loading& loading) {
  require_vectors("the motion of prescribed components", loading.motion, nodes);
  if (!loading.forces.empty()) require_vectors("the external force", loading.forces, nodes);
  require_planes(loading.planes);
  for (std::size_t p = 0; p < loading.pressures.size(); ++p) {
    const FollowingPressure& pressure = loading.pressures[p];
    const std::string which = "pressure " + std::to_string(p) + " that follows the surface ";
    if (!std::isfinite(pressure.pressure)) {
      throw Error(which + "is " + number_text(pressure.pressure) + " and must be a finite number [Pa]");
    }
    for (const Face& face : pressure.faces) {
      for (const Index node : face) {
        if (node >= 0 && static_cast<std::size_t>(node) < nodes) continue;
        throw Error(which + "pushes a face with node " + std::to_string(node) + " of " + std::to_string(nodes) +
                    "; give faces of the mesh's surface");
      }
    }
  }
}

}  // namespace

void require_loading(const MeshLevel& level, const Loading& loading) {
  require_loading(static_cast<std::size_t>(level.mesh.nodes), loading);
}

std::vector<Face> pressed_nodes(const std::vector<FollowingPressure>& pressures) {
  std::vector<Face> faces;
  for (const FollowingPressure& pressure : pressures) {
    faces.insert(faces.end(), pressure.faces.begin(), pressure.faces.end());
  }
  return faces;
}

void require_next_loading(const Loading& loading, std::size_t nodes, bool had_planes, const std::vector<Face>& faces) {
  require_loading(nodes, loading);
  if (had_planes || !loading.planes.empty()) {
    throw Error("a loading with rigid planes cannot be replaced, nor can it replace one; make another solver");
  }
  if (pressed_nodes(loading.pressures) != faces) {
    throw Error(
        "pressures that follow the surface push other faces than those of the loading that is replaced; give "
        "the same faces, those without pressure with 0 Pa, or make another solver");
  }
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
  if (!level.material_ends.empty()) throw Error(std::string(who) + " has one material; give the body one");
  if (!loading.pressures.empty()) {
    throw Error(std::string(who) + " cannot have pressures that follow the surface; give them as forces at rest");
  }
}

void require_motion(const DynamicSettings& settings) {
  require_positive("the density", settings.density);
  if (!(settings.damping >= 0) || !std::isfinite(settings.damping)) {
    throw Error("the damping is " + number_text(settings.damping) + " and must be 0 or a positive number");
  }
}

void require_meshes(const std::vector<MeshLevel>& levels) {
  if (levels.empty() || levels.front().mesh.tets.empty()) throw Error("a solver needs a mesh with at least one tet");
  for (std::size_t l = 0; l < levels.size(); ++l) require_rest(l, levels[l]);
}

void require_settings(const SolverSettings& settings) {
  const NewtonSettings& newton = settings.newton;
  const PreconditionerSettings& preconditioner = newton.preconditioner;
  require_positive("the tolerance", newton.tolerance);
  require_positive("the tolerance on coarser meshes", settings.coarser_tolerance);
  require_positive("the least tolerance of linear solves", newton.least_forcing);
  require_positive("the largest tolerance of linear solves", newton.most_forcing);
  require_positive("the stiffness of rigid planes", settings.plane_stiffness);
  require_positive("the lower end of the smoother's interval", preconditioner.low);
  if (!(preconditioner.low < 1)) {
    throw Error("the lower end of the smoother's interval is " + std::to_string(preconditioner.low) +
                " of its upper end and must be below 1");
  }
  require_least("the number of Newton steps", newton.most_steps, 1);
  require_least("the number of iterations of conjugate gradients", newton.most_iterations, 1);
  require_least("the number of halvings of a step", newton.most_halvings, 0);
  require_least("the number of bisections of an increment", settings.most_bisections, 0);
  if (newton.product == Product::matrix_free && asks_for(preconditioner.kind, asks::edges)) {
    throw Error("the matrix-free product requires one of the preconditioners " + preconditioners_without(asks::edges) +
                ": " + row_of(preconditioner.kind).name + " is formed from blocks of edges, which it does without");
  }
  require_least("the degree of the smoother", preconditioner.degree, 1);
  require_least("the number of power iterations", preconditioner.first_power_steps, 1);
  require_least("the number of power iterations", preconditioner.next_power_steps, 1);
}

void require_linear_solver(const std::vector<MeshLevel>& levels, const Loading& loading,
                           const SolverSettings& settings) {
  require_meshes(levels);
  require_settings(settings);
  require_single_range(levels.front(), settings);
  require_plain("linear elasticity", levels.front(), loading);
}

}  // namespace physgen::fem
