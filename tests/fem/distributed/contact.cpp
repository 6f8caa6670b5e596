// contact: as newton, for a cube of irregular tets that two rigid planes push, of the scene everything.
//
//   --cells N      along each side (default 12)
//   --ordinary 1   one process by the solver's ordinary way
#include <everything.halos.h>
#include <everything.scene.h>
#include <fem/solver/loads/loading_arrays.h>
#include <fem/solver/loads/plane_arrays.h>
#include <scenes/everything.h>

#include <cmath>
#include <utility>

#include "newton_runs.h"

namespace {

using namespace physgen;
using namespace physgen::fem;
namespace of_scene = scenes::everything_scene;

/// A cube that stands on a plate.
Body standing_cube(Index cells) {
  Body body = pressed_cube(cells, false);
  for (std::size_t n = 0; n < body.loading.motion.size(); ++n) {
    body.loading.motion[n] = {};
    if (body.levels.front().rest[n][2] > 0) body.levels.front().fixed[n] = 0;
  }
  return body;
}
/// One that comes down on it, aslant, and one that pushes a side of it. Neither touches more than an edge at first.
std::vector<RigidPlane> planes_around_the_cube() {
  const double c = std::cos(0.1), s = std::sin(0.1);
  return {{{-s, 0, -c}, -(s + c) * side, 0.1 * side}, {{c, 0, s}, 0, 0.03 * side}};
}

struct Contact : NothingBesides {
  bool is_first;  ///< whether this rank prints
  of_scene::Planes<> planes;
  SolverSettings settings = settings_of_the_cube();
  of_scene::Planes<> whole{};  ///< where `planes` are a rank's part of it

  template <class On, class Groups>
  NewtonResult solve(On& on, Groups& groups, const Report& report) {
    NoArrays none;
    auto solver = solver_program<float, StoredAsComputed, AssembledOnMeshes>(
        on, settings, material_of_the_cube(settings), groups.facts,
        SolverGroups{groups.body, groups.patches, none, groups.chunk, groups.levels, none, planes, none, none,
                     groups.krylov});
    const NewtonResult result =
        solver.solve_to(1, [&](std::size_t /*level*/, const NewtonStep& step) { report(step); });
    for (const PlaneContact& contact : solver.plane_contacts_of(0)) {
      if (is_first) std::printf("plane force %a depth %a\n", contact.force, contact.depth);
    }
    return result;
  }

  void add_to(DistributedArrays& arrays) {
    whole = std::exchange(planes, {});
    arrays.add_replicated_set("plane", whole.planes.size());
    arrays.add_set("surface_node", whole.areas.size());
    arrays.same_set("surface_node", "node");
    arrays.add("planes.planes", "plane", planes.planes.contents());
    arrays.add("planes.areas", "surface_node", planes.areas.contents());
    arrays.add("planes.stiffness", "node", planes.stiffness);
  }
  void fill(DistributedArrays& arrays) {
    arrays.fill(planes.planes.contents(), whole.planes);
    arrays.fill(planes.areas.contents(), whole.areas);
    planes.contact.resize(1);
  }
  template <class Each>
  void print(const Digests<Each>& digests) const {
    digests.print("planes", planes.stiffness, [](const auto& node, int k) -> double { return node.K()(k, 2); });
  }
};

void run(const Ranks& ranks, Index cells, bool is_ordinary) {
  const Body body = standing_cube(cells);
  const MeshLevel& level = body.levels.front();
  Contact contact{{}, ranks.is_first(), {}};
  const SolverSettings& settings = contact.settings;
  SceneGroups<of_scene::Body<>, NoArrays, of_scene::Chunk<>, of_scene::Level<>, of_scene::Krylov<>> whole(body,
                                                                                                          settings);
  whole.facts.plane_stiffness = settings.plane_stiffness * settings.youngs_modulus / whole.spacing;
  whole.facts.rounding_force = rounding_force(settings, level, body.loading.motion, true, whole.spacing);
  contact.planes = PlanesOver<of_scene::Planes<>>(level, planes_around_the_cube(), whole.facts.plane_stiffness);
  if (is_ordinary) return run_ordinary(whole, contact);
  run_on_ranks(ranks, of_scene::halos, whole, contact);
}

}  // namespace

int main(int argc, char** argv) {
  return run_as_asked(argc, argv, [](const Ranks& ranks, Index cells, bool /*patches*/, bool ordinary) {
    run(ranks, cells, ordinary);
  });
}
