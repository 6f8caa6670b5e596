// relax: the springs of a lattice, on as many ranks as it is started with; prints a digest of what it computed.
//
//   --cells N       edges of the lattice along each side (default 24)
//   --steps N       at most (default 20)
//   --plain         arrays of all objects, without anything of distributed/ (one process)
//   --threads N     of each rank
//   --by-hand       sets, names and the table of kernels as one writes them without a scene
//   --no-table      the same, and no kernel is known
//   --throw R       a kernel throws on rank R
//   --kill R        rank R is killed before its steps, by a signal that it cannot handle
//   --options TEXT  must be equal on all ranks
//   --build TEXT    in place of what tells this build from others
//   --sizes R       rank R has another mesh
//   --fail R        rank R and those above find the same error
//   --near          no edges to far nodes
#include <physgen/threads.h>
#include <relax.distributed.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "relax_mesh.h"

namespace {

using namespace relaxed;
using Body = scenes::relax_scene::Body<>;

void print(const Digest& digest, const Body& body, const std::string& more) {
  const auto state = body.state.const_view()[index_t{0}].f().get();
  std::printf("digest %016llx square %a node %.0f steps %.0f%s\n", static_cast<unsigned long long>(digest.hash),
              state[0], state[1], state[2], more.c_str());
}

void run_plain(const Mesh& mesh, int steps) {
  Body body;
  body.allocate({.node = mesh.nodes(), .edge = mesh.springs(), .end = 2 * mesh.springs()});
  std::int32_t end = 0;
  for (index_t i = 0; i < mesh.nodes(); ++i) {
    body.positions.view().put(i, mesh.position(i));
    body.ranges.contents()[i].begin() = end;
    for (const auto& one : mesh.row(i)) body.ends.contents().view().put(index_t{end++}, one);
    body.ranges.contents()[i].end() = end;
  }
  for (index_t e = 0; e < body.edges.size(); ++e) {
    const auto& nodes = mesh.edge(e);
    body.edges.contents()[e].nodes() = Eigen::Vector2i(static_cast<int>(nodes[0]), static_cast<int>(nodes[1]));
  }
  HostExecutor on;
  scenes::relax::program(on, body, steps, at_rest, -1);
  Digest digest;
  add(digest, body.positions.const_view());
  print(digest, body, "");
}

/// The program over arrays that are cut and filled. @param each_block of positions: each_block(use)
void run_cut(const Ranks& ranks, DistributedArrays& arrays, Body& body, int steps, bool throws,
             const auto& each_block) {
  DistributedExecutor<HostExecutor> on(ranks, arrays, {.poisons_stale_ghosts = true});
  scenes::relax::program(on, body, steps, at_rest, throws ? arrays.set("node").begin() + 17 : -1);
  const Traffic traffic = on.traffic();
  Digest digest;
  each_block([&](index_t /*first*/, auto positions) { add(digest, positions); });
  std::string more = " exchanges " + std::to_string(traffic.exchanges) + " gathers " + std::to_string(traffic.gathers) +
                     " overlapped " + std::to_string(traffic.overlapped);
  for (const std::string& kernel : on.unknown_kernels()) more += " unknown " + kernel;
  if (ranks.is_first()) print(digest, body, more);
}

void run_on(const Ranks& ranks, const Mesh& mesh, int steps, bool throws) {
  scenes::relax_scene::Distributed<> body(ranks,
                                          {.node = mesh.nodes(), .edge = mesh.springs(), .end = 2 * mesh.springs()});
  body.connect(body.edges, [&](index_t e) { return mesh.edge(e); });
  body.connect(body.ranges, body.ends, [&](index_t node) -> const auto& { return mesh.row(node); });
  body.cut();
  body.fill(body.positions, [&](index_t node) { return mesh.position(node); });
  run_cut(ranks, body, body, steps, throws, [&](const auto& use) { body.each_block(body.positions, use, 1 << 16); });
}

void run_by_hand(const Ranks& ranks, const Mesh& mesh, int steps, bool has_table) {
  Body body;
  DistributedArrays arrays(ranks, has_table ? HaloUses(springs::halos) : HaloUses());
  arrays.add_set("node", mesh.nodes());
  arrays.add_set("edge", mesh.springs());
  arrays.add_replicated_set("one", 1);
  arrays.follow("edge", "node");
  arrays.add("body.positions", "node", body.positions);
  arrays.add("body.forces", "node", body.forces);
  arrays.add("body.ranges", "node", body.ranges);
  arrays.add("body.edges", "edge", body.edges);
  arrays.add("body.springs", "edge", body.springs);
  arrays.add("body.state", "one", body.state);
  arrays.connect(body.edges, "nodes", "node", [&](index_t e) { return mesh.edge(e); });
  arrays.connect_rows(body.ranges, "body.ends", body.ends.contents(), "element", "edge",
                      [&](index_t node) -> const auto& { return mesh.row(node); });
  arrays.cut();
  arrays.fill(body.positions, [&](index_t node) { return mesh.position(node); });
  run_cut(ranks, arrays, body, steps, false, [&](const auto& use) { arrays.each_block(body.positions, use, 1 << 16); });
}

std::string build_of(int argc, char** argv) {
  for (int a = 1; a + 1 < argc; ++a) {
    if (argv[a] == std::string("--build")) return argv[a + 1];
  }
  return physgen::detail::build_of_program();
}

int run(int argc, char** argv) {
  index_t cells = 24;
  int steps = 20, throws = -1, kill = -1, other = -1, fails = -1;
  bool plain = false, by_hand = false, has_table = true, is_near = false;
  std::string options;
  const Ranks ranks(argc, argv, build_of(argc, argv));
  for (int a = 1; a < argc; ++a) {
    const std::string what = argv[a];
    if (what == "--plain")
      plain = true;
    else if (what == "--by-hand")
      by_hand = true;
    else if (what == "--no-table")
      by_hand = true, has_table = false;
    else if (what == "--near")
      is_near = true;
    else if (a + 1 == argc)
      throw Error("option " + what + " needs a value; see the head of relax.cpp");
    else if (what == "--cells")
      cells = std::atoi(argv[++a]);
    else if (what == "--steps")
      steps = std::atoi(argv[++a]);
    else if (what == "--threads")
      set_threads(std::atoi(argv[++a]));
    else if (what == "--throw")
      throws = std::atoi(argv[++a]);
    else if (what == "--kill")
      kill = std::atoi(argv[++a]);
    else if (what == "--sizes")
      other = std::atoi(argv[++a]);
    else if (what == "--fail")
      fails = std::atoi(argv[++a]);
    else if (what == "--options")
      options = argv[++a];
    else if (what == "--build")
      ++a;
    else
      throw Error("there is no option " + what + "; see the head of relax.cpp");
  }
  ranks.agree("option", options);
  if (fails >= 0 && ranks.rank() >= fails) ranks.fail("the springs cannot be found");
  const Mesh mesh(other == ranks.rank() ? cells + 1 : cells, is_near);
  if (plain) {
    run_plain(mesh, steps);
    return 0;
  }
  if (kill == ranks.rank()) std::raise(SIGKILL);
  ranks.guard([&] {
    if (by_hand) {
      run_by_hand(ranks, mesh, steps, has_table);
    } else {
      run_on(ranks, mesh, steps, throws == ranks.rank());
    }
  });
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
