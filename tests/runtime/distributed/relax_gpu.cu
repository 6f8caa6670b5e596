// relax on CUDA: the springs of a lattice, on as many ranks as it is started with, each with a GPU of its own; prints
// what relax prints.
//
//   --cells N    edges of the lattice along each side (default 24)
//   --steps N    at most (default 20)
//   --pinned     through pinned memory and MPI, not by NCCL
//   --plain      arrays of all objects, without anything of distributed/ (one process)
//   --near       no edges to far nodes
//   --no-table   no kernel is known
//   --poison 0   stale ghosts keep their values
//   --kill R     rank R is killed in its steps, by a signal that it cannot handle
//   --fill R     rank R takes the memory of its GPU before it makes its arrays
// Exit status: 77 where there is no CUDA device.
#include <physgen/distributed/cuda/executor.h>
#include <relax.distributed.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "relax_mesh.h"

namespace {

using namespace relaxed;
using Body = scenes::relax_scene::Body<Cuda>;

struct Options {
  index_t cells = 24;
  int steps = 20, kill = -1, fill = -1;
  bool plain = false, is_near = false, pinned = false, has_table = true, poisons = true;
};

template <class Array>
auto on_host(const Array& array) {
  detail::OnHost<Array> here(array.size());
  copy(here, array);
  return here;
}

void print(const Digest& digest, const Body& body, const std::string& more) {
  const auto here = on_host(body.state);
  const auto state = here.const_view()[index_t{0}].f().get();
  std::printf("digest %016llx square %a node %.0f steps %.0f%s\n", static_cast<unsigned long long>(digest.hash),
              state[0], state[1], state[2], more.c_str());
}

void run_plain(const Mesh& mesh, int steps) {
  Body body;
  body.allocate({.node = mesh.nodes(), .edge = mesh.springs(), .end = 2 * mesh.springs()});
  std::int32_t end = 0;
  auto ranges = on_host(body.ranges.contents());
  auto ends = on_host(body.ends.contents());
  auto edges = on_host(body.edges.contents());
  auto positions = on_host(body.positions);
  for (index_t i = 0; i < mesh.nodes(); ++i) {
    positions.view().put(i, mesh.position(i));
    ranges[i].begin() = end;
    for (const auto& one : mesh.row(i)) ends.view().put(index_t{end++}, one);
    ranges[i].end() = end;
  }
  for (index_t e = 0; e < edges.size(); ++e) {
    const auto& nodes = mesh.edge(e);
    edges[e].nodes() = Eigen::Vector2i(static_cast<int>(nodes[0]), static_cast<int>(nodes[1]));
  }
  copy(body.ranges.contents(), std::as_const(ranges));
  copy(body.ends.contents(), std::as_const(ends));
  copy(body.edges.contents(), std::as_const(edges));
  copy(body.positions, std::as_const(positions));
  synchronize();
  CudaExecutor on(std::max(mesh.nodes(), mesh.springs()));
  scenes::relax::program(on, body, steps, at_rest, -1);
  on.wait();
  Digest digest;
  add(digest, on_host(body.positions).const_view());
  print(digest, body, "");
}

template <class On>
void run_steps(const Ranks& ranks, On& on, Body& body, const Options& options, const auto& each_block) {
  if (options.kill >= 0) {  // some steps first
    scenes::relax::program(on, body, 3, at_rest, -1);
    on.wait();
    if (options.kill == ranks.rank()) std::raise(SIGKILL);
  }
  const auto start = std::chrono::steady_clock::now();
  scenes::relax::program(on, body, options.steps, at_rest, -1);
  on.wait();
  const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
  const Traffic traffic = on.traffic();
  Digest digest;
  each_block([&](index_t /*first*/, auto positions) { add(digest, positions); });
  std::string more = " exchanges " + std::to_string(traffic.exchanges) + " gathers " + std::to_string(traffic.gathers) +
                     " overlapped " + std::to_string(traffic.overlapped);
  for (const std::string& kernel : on.unknown_kernels()) more += " unknown " + kernel;
  more += " us/step " + std::to_string(time.count() / options.steps) + " by " + on.transport_name();
  if (ranks.is_first()) print(digest, body, more);
}

void run_distributed(const Ranks& ranks, const Mesh& mesh, const Options& options) {
  scenes::relax_scene::Distributed<Cuda> body(
      ranks, {.node = mesh.nodes(), .edge = mesh.springs(), .end = 2 * mesh.springs()});
  body.connect(body.edges, [&](index_t e) { return mesh.edge(e); });
  body.connect(body.ranges, body.ends, [&](index_t node) -> const auto& { return mesh.row(node); });
  body.cut();
  body.fill(body.positions, [&](index_t node) { return mesh.position(node); });
  if (options.fill == ranks.rank()) {
    index_t bytes = index_t{256} << 30;
    for (void* memory = nullptr; bytes > 1 << 20;) {
      if (cudaMalloc(&memory, static_cast<std::size_t>(bytes)) != cudaSuccess) bytes /= 2;
    }
    cudaGetLastError();
    const elasticity::NodePositionArray<double, Cuda> one_more(1 << 20);
  }
  DistributedExecutor<CudaExecutor> on(ranks, body,
                                       {.poisons_stale_ghosts = options.poisons, .uses_nccl = !options.pinned});
  run_steps(ranks, on, body, options, [&](const auto& use) { body.each_block(body.positions, use, 1 << 16); });
}

void run_without_table(const Ranks& ranks, const Mesh& mesh, const Options& options) {
  Body body;
  DistributedArrays arrays(ranks, HaloUses());
  arrays.add_set("node", mesh.nodes());
  arrays.add_set("edge", mesh.springs());
  arrays.add_replicated_set("one", 1);
  arrays.follow("edge", "node");
  arrays.add("body.positions", "node", body.positions);
  arrays.add("body.forces", "node", body.forces);
  arrays.add("body.ranges", "node", body.ranges.contents());
  arrays.add("body.edges", "edge", body.edges.contents());
  arrays.add("body.springs", "edge", body.springs);
  arrays.add("body.state", "one", body.state);
  arrays.connect(body.edges.contents(), "nodes", "node", [&](index_t e) { return mesh.edge(e); });
  arrays.connect_rows(body.ranges.contents(), "body.ends", body.ends.contents(), "element", "edge",
                      [&](index_t node) -> const auto& { return mesh.row(node); });
  arrays.cut();
  arrays.fill(body.positions, [&](index_t node) { return mesh.position(node); });
  DistributedExecutor<CudaExecutor> on(ranks, arrays,
                                       {.poisons_stale_ghosts = options.poisons, .uses_nccl = !options.pinned});
  run_steps(ranks, on, body, options, [&](const auto& use) { arrays.each_block(body.positions, use, 1 << 16); });
}

Options read(int argc, char** argv) {
  Options options;
  for (int a = 1; a < argc; ++a) {
    const std::string what = argv[a];
    if (what == "--plain")
      options.plain = true;
    else if (what == "--near")
      options.is_near = true;
    else if (what == "--pinned")
      options.pinned = true;
    else if (what == "--no-table")
      options.has_table = false;
    else if (a + 1 == argc)
      throw Error("option " + what + " needs a value; see the head of relax_gpu.cu");
    else if (what == "--cells")
      options.cells = std::atoi(argv[++a]);
    else if (what == "--steps")
      options.steps = std::atoi(argv[++a]);
    else if (what == "--poison")
      options.poisons = std::atoi(argv[++a]) != 0;
    else if (what == "--kill")
      options.kill = std::atoi(argv[++a]);
    else if (what == "--fill")
      options.fill = std::atoi(argv[++a]);
    else
      throw Error("there is no option " + what + "; see the head of relax_gpu.cu");
  }
  return options;
}

int run(int argc, char** argv) {
  const Ranks ranks(argc, argv);
  const Options options = read(argc, argv);
  if (!cuda_available()) {
    std::printf("skipped: there is no CUDA device\n");
    return 77;
  }
  const Mesh mesh(options.cells, options.is_near);
  if (options.plain) {
    run_plain(mesh, options.steps);
    return 0;
  }
  ranks.guard([&] {
    if (options.has_table)
      run_distributed(ranks, mesh, options);
    else
      run_without_table(ranks, mesh, options);
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
