// The multilevel Schwarz preconditioner.
#pragma once

#include <fem/solver/levels/preconditioner.h>
#include <fem/solver/levels/scaled_blocks.h>
#include <fem/solver/preconditioners/schwarz/schwarz.h>
#ifdef __CUDACC__
#include <fem/solver/preconditioners/schwarz/schwarz_cuda.h>
#else
#include <fem/solver/preconditioners/schwarz/schwarz_host.h>
#endif

namespace physgen::fem {

struct Schwarz {
  template <class Level>
  static void make_arrays(Level& level, const LevelGraph& graph, const std::vector<Point>& rest) {
    make(level.extra, make_schwarz_hierarchy(graph, rest), level.edge_count());
  }
  /// From above: blocks follow a curve through the nodes, so their number is not known before; what stands here of
  /// supernodes and edges is what cubes have.
  template <class Extra>
  static PreconditionerBytes bytes(std::int64_t nodes, std::int64_t edges) {
    const std::int64_t blocks = (nodes + schwarz_slots - 1) / schwarz_slots;  // if none were prescribed
    const std::int64_t coarse = blocks > 1 ? 1 + blocks / 18 : 0, all = blocks + coarse;
    const std::int64_t supernodes = schwarz_slots * coarse, inside = edges * 9 / 20;
    PreconditionerBytes bytes;
    if constexpr (requires { &Extra::factors; }) {
      bytes.device = Extra::bytes({.node = nodes,
                                   .slot = schwarz_slots * all,
                                   .block = all,
                                   .supernode = supernodes,
                                   .supernode_term = nodes + inside,
                                   .pair = supernodes * edges / nodes,
                                   .pair_term = edges - inside,
                                   .block_edge = inside,
                                   .factor = schwarz_factors * all});
    }
    bytes.lists = 2 * std::int64_t{sizeof(Index)} * (2 * nodes + 2 * edges);  // slots, edges and terms
    return bytes;
  }
  template <class On, class Levels>
  static void prepare(On& on, Levels& levels, std::size_t top, const PreconditionerSettings& /*settings*/,
                      bool /*fresh*/) {
    scale_nodes(on, *levels[top], true);
    prepare_schwarz(on, *levels[top]);
  }
  template <class On, class Levels>
  static void apply(On& on, Levels& levels, std::size_t top, const PreconditionerSettings& /*settings*/) {
    apply_schwarz(on, *levels[top]);
  }
};

}  // namespace physgen::fem
