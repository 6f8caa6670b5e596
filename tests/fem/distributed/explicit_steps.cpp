// explicit_steps: time steps of the scene explicit_dynamics, for a cube of irregular tets whose nodes fly apart while
// its upper plate comes down, on as many ranks as it is started with.
//
//   --cells N      along each side (default 12)
//   --ordinary 1   one process by the solver's ordinary way
#include <explicit_dynamics.halos.h>
#include <fem/dynamics/explicit_body.h>
#include <fem/solver/masses.h>
#include <scenes/explicit_dynamics.h>

#include <random>

#include "newton_runs.h"

namespace {

using namespace physgen;
using namespace physgen::fem;
using Moving = scenes::explicit_dynamics_scene::Body<>;

constexpr double density = 1200, damping = 3, length = 1e-4;  // [kg/m^3], [1/s], [s]

/// The whole body, with random velocities.
Moving whole_body(const Body& given) {
  Moving body;
  const MeshLevel& level = given.levels.front();
  fill_explicit_body(body, level, given.loading, lumped_masses(level.mesh, level.rest, density), true);
  std::mt19937_64 random(4);
  std::normal_distribution<double> speed(0, 0.5);
  for (index_t n = 0; n < body.velocities.size(); ++n) {
    for (int k = 0; k < 3; ++k) body.velocities.view()[n].v()[k] = speed(random);
  }
  return body;
}

/// What a rank has of it.
struct Part {
  DistributedArrays arrays;
  Moving body;

  Part(const Ranks& ranks, const Moving& whole) : arrays(ranks, scenes::explicit_dynamics_scene::halos) {
    for (const char* set : {"node", "row"}) arrays.add_set(set, whole.velocities.size());
    for (const char* set : {"tet", "gathered_tet"}) arrays.add_set(set, whole.tets.size());
    arrays.same_set("row", "node");
    arrays.same_set("gathered_tet", "tet");
    arrays.follow("tet", "node");
    arrays.add("body.tets", "tet", body.tets.contents());
    arrays.add("body.rest", "tet", body.rest.contents());
    arrays.add("body.corners", "gathered_tet", body.corners);
    arrays.add("body.node_tet_ranges", "row", body.node_tet_ranges.contents());
    arrays.add("body.constraints", "node", body.constraints.contents());
    arrays.add("body.masses", "node", body.masses.contents());
    arrays.add("body.loads", "node", body.loads.contents());
    arrays.add("body.motion", "node", body.motion.contents());
    arrays.add("body.displacements", "node", body.displacements);
    arrays.add("body.rounded", "node", body.rounded);
    arrays.add("body.velocities", "node", body.velocities);
    arrays.add("body.forces", "node", body.forces);
    arrays.connect(body.tets.contents(), "nodes", "node", nodes_of<4>(whole.tets));
    arrays.connect_rows(body.node_tet_ranges.contents(), "body.node_tets", body.node_tets.contents(), "element",
                        "gathered_tet", rows_of(whole.node_tet_ranges, whole.node_tets));
    arrays.cut();
    arrays.fill(body.rest.contents(), whole.rest);
    arrays.fill(body.constraints.contents(), whole.constraints);
    arrays.fill(body.masses.contents(), whole.masses);
    arrays.fill(body.loads.contents(), whole.loads);
    arrays.fill(body.motion.contents(), whole.motion);
    arrays.fill(body.displacements, whole.displacements);
    arrays.fill(body.rounded, whole.rounded);
    arrays.fill(body.velocities, whole.velocities);
    body.measured = whole.measured;
  }
};

/// Prints what each of the steps leaves. @param then then() is called behind each
template <class On, class Then>
void move(On& on, Moving& body, bool is_first, const Then& then) {
  const auto material = NeoHookean<float>::from(1e4, 0.45);
  for (int k = 1; k <= 20; ++k) {
    scenes::explicit_dynamics::program(on, body, material, {length, 0.01 * k, damping});
    const auto measured = on.value(body.measured);
    if (is_first) {
      std::printf("step kinetic %a elastic %a momentum %a %a %a\n", double{measured.kinetic}, double{measured.elastic},
                  double{measured.momentum[0]}, double{measured.momentum[1]}, double{measured.momentum[2]});
    }
    then();
  }
}
template <class Each>
void print(const Digests<Each>& digests, const Moving& body) {
  const auto vector = [](const auto& node, int k) -> double { return node.dx()[k]; };
  digests.print("displacements", body.displacements, vector);
  digests.print("rounded", body.rounded, vector);
  digests.print("velocities", body.velocities, [](const auto& node, int k) -> double { return node.v()[k]; });
  digests.print("forces", body.forces, [](const auto& node, int k) -> double { return node.f()[k]; });
}

void run(const Ranks& ranks, Index cells, bool is_ordinary) {
  Moving whole = whole_body(pressed_cube(cells, true));
  if (is_ordinary) {
    HostExecutor on;
    move(on, whole, true, [] {});
    return print(Digests{true, [](const auto& array, const auto& visit) { visit(array.const_view()); }}, whole);
  }
  Part part(ranks, whole);
  DistributedExecutor<HostExecutor> on(ranks, part.arrays, {.poisons_stale_ghosts = true});
  Traffic before = on.traffic();
  move(on, part.body, ranks.is_first(), [&] {
    const Traffic now = on.traffic();
    if (ranks.is_first()) {
      std::printf("traffic exchanges %lld gathers %lld\n", static_cast<long long>(now.exchanges - before.exchanges),
                  static_cast<long long>(now.gathers - before.gathers));
    }
    before = now;
  });
  const auto each = [&](const auto& array, const auto& visit) {
    part.arrays.each_block(array, [&](index_t /*first*/, const auto& view) { visit(view); });
  };
  print(Digests{ranks.is_first(), each}, part.body);
  if (!ranks.is_first()) return;
  for (const std::string& kernel : on.unknown_kernels()) std::printf("unknown %s\n", kernel.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  return run_as_asked(argc, argv, [](const Ranks& ranks, Index cells, bool /*patches*/, bool ordinary) {
    run(ranks, cells, ordinary);
  });
}
