#include <fem/solver/require.h>
#include <physgen/error.h>

#include <cmath>

namespace physgen::fem {

void require_positive(const std::string& what, double value) {
  if (!(value > 0) || !std::isfinite(value)) {
    throw Error(what + " is " + std::to_string(value) + " and must be a positive number");
  }
}

namespace {

void require_vectors(const std::string& what, const std::vector<Point>& vectors, std::size_t nodes) {
  if (vectors.size() != nodes) {
    throw Error(what + " has " + std::to_string(vectors.size()) + " vectors for " + std::to_string(nodes) + " nodes");
  }
  for (std::size_t n = 0; n < nodes; ++n) {
    for (const double x : vectors[n]) {
      if (!std::isfinite(x)) throw Error(what + " of node " + std::to_string(n) + " is not finite");
    }
  }
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
      throw Error(which + ": its offset or travel is not finite");
    }
  }
}

}  // namespace

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
  if (!std::isfinite(load)) throw Error("the load at the end of a time step is " + std::to_string(load));
}

void require_vectors_of(const char* what, std::size_t given, std::size_t nodes) {
  if (given == nodes) return;
  throw Error(std::to_string(given) + " " + what + " were given for " + std::to_string(nodes) + " nodes");
}

void require_plain(const char* who, const MeshLevel& level, const Loading& loading) {
  require_loading(level, loading);
  if (!loading.planes.empty()) throw Error(std::string(who) + " has no rigid planes: prescribe the motion of nodes");
  if (!level.patches.nodes.empty() || level.averages_at_nodes) {
    throw Error(std::string(who) + " takes the change of volume of each tet by itself: average no volumes");
  }
}

void require_motion(const DynamicSettings& settings) {
  require_positive("the density", settings.density);
  if (!(settings.damping >= 0) || !std::isfinite(settings.damping)) {
    throw Error("the damping is " + std::to_string(settings.damping) + " and must be 0 or a positive number");
  }
}

}  // namespace physgen::fem
