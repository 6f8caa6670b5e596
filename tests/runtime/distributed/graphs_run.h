// graphs: random programs over random graphs, on as many ranks as it is started with, against the same programs over
// whole arrays in one process. Every object that a rank owns must have the same bits, and every ghost of a field that
// is fresh.
//
//   --seeds A B     seeds A .. B-1
//   --without ROW   a row of the table is left out; ends with the first seed that shows it
//   --without each  each row that must be missed is left out in turn, and each must be missed
//   --lacking N     need N of each set (1: the first that is not of all ghosts) lacks an object of each message
//   --most N        nodes of the largest graph (default 5000)
//   --pinned        on CUDA: through pinned memory and MPI, not by NCCL
// Exit status: 0 all equal, or each row is missed; 3 differences were found; 4 a row is not missed.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

#include "graph_body.h"
#include "graph_mutants.h"
#include "graph_steps.h"
#include "graph_table.h"

namespace graphs {

/// One step of a program. @param chosen which
template <class On, class Body>
void step(On& on, Body& b, int chosen) {
  const index_t nodes = b.positions.size(), edges = b.edges.size();
  const auto ends = Rows(b.ranges.const_view(), b.ends.const_view(), edges);
  const auto touches = Rows(b.touched.const_view(), b.touches.const_view(), b.quads.size());
  const auto members = Rows(b.member_ranges.const_view(), b.members.const_view(), std::max(nodes, edges));
  const auto x = b.positions.const_view();
  switch (chosen) {
    case 0:
      return on.run(edges, Pull{b.edges.const_view(), x, b.springs.view()});
    case 1:
      return on.run(nodes, SumPulls{ends, b.springs.const_view(), b.forces.view()});
    case 2:
      return on.run(nodes, Move{b.forces.const_view(), b.means.const_view(), b.positions.view(), 0.0625F});
    case 3:
      return on.run(b.quads.size(), Share{b.quads.const_view(), x, b.shares.view()});
    case 4:
      return on.run(nodes, AddShares{touches, b.shares.const_view(), b.forces.view()});
    case 5:
      return on.run(nodes, Mix{b.forces.const_view(), b.means.view()});
    case 6:
      return on.reduce(edges, Lengths{x, b.edges.const_view()}, Sum{}, Store{b.state.view(), 0});
    case 7:
      return on.reduce(edges, Lengths{x, b.edges.const_view()}, Argmax{}, Store{b.state.view(), 1});
    case 8:
      return on.run(nodes, Drift{b.means.const_view(), b.positions.view()});
    case 9: {
      index_t first = 0, count = 0;
      do {  // one part at least
        count = std::min(index_t{4096}, edges - first);
        on.reduce_part({first, count, edges}, PullPart{first, b.edges.const_view(), x, b.springs.view()}, Sum{},
                       Store{b.state.view(), 2});
        first += count;
      } while (first < edges);
      return;
    }
    case 10:
      return sum_at_once(on, nodes, SumPulls{ends, b.springs.const_view(), b.forces.view()});
    case 11:
      return on.reduce(edges, PullPart{0, b.edges.const_view(), x, b.springs.view()}, Sum{}, Store{b.state.view(), 2});
    case 12:
      return on.run(nodes, Clear{x, b.forces.view()});
    case 13:
      return on.run(nodes, Degree{ends, b.positions.view()});
    case 14: {
      const auto pulls = local<elasticity::NodeForceObject, typename decltype(b.forces)::Precision>();
      return on.run(
          nodes, lanes<1>(fuse(locals(pulls), Quarter{b.forces.const_view(), pulls}, Push{pulls, b.positions.view()})));
    }
    case 15:
      return on.run(b.totals.size(), Collect{members, x, b.springs.const_view(), b.links.const_view(),
                                             b.calms.const_view(), b.totals.view()});
    case 16:
      return on.run(nodes, Spread{b.homes.const_view(), b.totals.const_view(), b.means.view()});
    case 17:
      return on.run(b.calms.size(), Settle{b.links.const_view(), b.totals.const_view(), b.calms.view()});
    case 18:
      return on.run(b.totals.size(), Members{members, b.totals.view()});
    case 19:
      return do_on_each(on, b.calms.size(), Settle{b.links.const_view(), b.totals.const_view(), b.calms.view()});
    default:
      return on.run(nodes, Smooth{ends, b.edges.const_view(), x, b.means.view()});
  }
}

/// Elements that differ from those of one process, of owned objects and of ghosts of fresh fields.
template <class Array>
index_t differences(const DistributedArrays& arrays, const Array& mine, const Array& whole) {
  const int number = arrays.find(mine.untyped().base);
  const DistributedArray& array = arrays.arrays()[static_cast<std::size_t>(number)];
  const LocalSet& set = *arrays.sets()[static_cast<std::size_t>(array.set)].local;
  const auto &here = on_host(mine), &all = on_host(whole);
  std::vector<char> is_stale(Graph::at(set.size()), 0);
  for (const auto& [first, count] : stale_ghosts(arrays.sets()[Graph::at(array.set)], array.fresh[0]).runs) {
    std::fill_n(is_stale.begin() + first, count, 1);
  }
  index_t found = 0;
  for (index_t i = set.first(); i < set.last(); ++i) {
    if (is_stale[Graph::at(i)] != 0) continue;
    for (int k = 0; k < Array::elements; ++k) found += here.getdata(i, k) == all.getdata(set.global(i), k) ? 0 : 1;
  }
  return found;
}

/// Of all objects, which rank 0 takes: index fields have the numbers of one process again.
template <class Array>
index_t differences_behind_taking(DistributedArrays& arrays, const Ranks& ranks, const Array& mine,
                                  const Array& whole) {
  const auto back = arrays.whole(mine);
  const auto& all = on_host(whole);
  if (back.size() != (ranks.is_first() ? all.size() : 0)) return 1;
  index_t found = 0;
  for (index_t i = 0; i < back.size(); ++i) {
    for (int k = 0; k < Array::elements; ++k) found += back.getdata(i, k) == all.getdata(i, k) ? 0 : 1;
  }
  return found;
}

/// An executor of one process. @param objects of the longest reduction
template <class On>
On make_plain(index_t objects) {
  if constexpr (std::is_same_v<typename On::Space, Host>) {
    return On();
  } else {
    return On(objects);
  }
}

/// What all seeds have shown.
struct Found {
  index_t differences = 0, exchanges = 0, overlapped = 0, bytes = 0;
  std::size_t needs = 0;  ///< most of a set, and one of all ghosts
};

/// @return the differences on all ranks
template <class On, class Body>
index_t run_seed(const Ranks& ranks, HaloUses uses, unsigned seed, index_t most, bool uses_nccl, int lacking,
                 Found& of_seeds) {
  std::mt19937 random(seed);
  const auto nodes = static_cast<index_t>(1 + random() % static_cast<unsigned long>(seed % 5 == 0 ? 64 : most));
  const Graph graph(nodes, random);
  const bool follows = random() % 2 == 0;
  Body whole, mine;
  DistributedArrays arrays(ranks, uses);
  const bool swaps = seed % 4 == 3;
  distribute(arrays, mine, graph, follows, swaps);
  fill_anywhere(whole, graph);  // behind cut(), which chooses the device
  arrays.fill(mine.positions, whole.positions);
  // Connected fields keep the numbers of this rank, whatever the filled objects have there.
  arrays.fill(mine.edges, whole.edges), arrays.fill(mine.quads, whole.quads), arrays.fill(mine.links, whole.links);
  arrays.fill(mine.homes, [](index_t) { return typename decltype(mine.homes)::Value{}; });
  arrays.fill(mine.ranges, whole.ranges);
  On plain = make_plain<On>(std::max({nodes, whole.edges.size(), whole.quads.size()}));
  DistributedExecutor<On> on(ranks, arrays, {.poisons_stale_ghosts = true, .uses_nccl = uses_nccl});
  // Each beginning has what shows that some rows of the table are missing: a field that is stale, and a step that would
  // then be done for ghosts, or would not fetch it.
  const std::vector<int> beginnings[] = {{0, 1, 2, 0, 3, 4},
                                         {20, 2, 20, 2, 0},
                                         {0, 1, 5, 8, 0, 2, 6, 7},
                                         {3, 4, 2, 0},
                                         {0, 10, 2, 9, 1, 2, 11, 1},
                                         {0, 15, 16, 8, 15, 0, 15, 17, 18, 19, 15, 16, 20, 3},
                                         {15, 18, 16, 2, 15, 17, 0, 15, 16}};
  std::vector<int> program;
  for (const int one : beginnings[seed % 7]) {
    if (one < 20 || follows) program.push_back(one);  // what reads through two index fields needs a set that follows
  }
  for (int k = 0; k < 20; ++k) program.push_back(static_cast<int>(random() % (follows ? 21 : 20)));
  std::set<int> lack_it;
  int steps = 0;
  for (const int chosen : program) {
    // The table says that kernels find nodes by b.edges, which has the memory of others now.
    if (swaps && ++steps % 5 == 0) std::swap(whole.edges, whole.others), std::swap(mine.edges, mine.others);
    step(plain, whole, chosen);
    step(on, mine, chosen);
    if (lacking > 0) drop_objects(arrays, lacking, lack_it);
  }
  for (const DistributedSet& set : arrays.sets()) of_seeds.needs = std::max(of_seeds.needs, set.needs.size());
  plain.wait();
  on.wait();
  const Traffic traffic = on.traffic();
  index_t found = differences(arrays, mine.positions, whole.positions) +
                  differences(arrays, mine.forces, whole.forces) + differences(arrays, mine.springs, whole.springs) +
                  differences(arrays, mine.means, whole.means) + differences(arrays, mine.shares, whole.shares) +
                  differences(arrays, mine.totals, whole.totals) + differences(arrays, mine.calms, whole.calms);
  for (int k = 0; k < 3; ++k) found += mine.state.getdata(0, k) == whole.state.getdata(0, k) ? 0 : 1;
  found += differences_behind_taking(arrays, ranks, mine.positions, whole.positions) +
           differences_behind_taking(arrays, ranks, mine.edges, whole.edges) +
           differences_behind_taking(arrays, ranks, mine.quads, whole.quads) +
           differences_behind_taking(arrays, ranks, mine.links, whole.links) +
           differences_behind_taking(arrays, ranks, mine.homes, whole.homes);
  const std::array<index_t, 3> counts{found, traffic.overlapped, traffic.bytes};
  std::vector<std::array<index_t, 3>> of_all(static_cast<std::size_t>(ranks.count()));
  const std::vector<index_t> sizes(of_all.size(), sizeof counts);
  arrays.transport().gather(std::as_bytes(std::span(counts)), sizes, std::as_writable_bytes(std::span(of_all)));
  of_seeds.exchanges += traffic.exchanges;
  index_t sum = 0;
  for (const auto& [differences_there, overlapped_there, bytes_there] : of_all) {
    sum += differences_there;
    of_seeds.overlapped += overlapped_there;
    of_seeds.bytes += bytes_there;
  }
  if (sum > 0 && ranks.is_first()) {
    std::printf("seed %u: %lld nodes, %zu edges, %zu quads: %lld differences\n", seed, static_cast<long long>(nodes),
                graph.edges.size(), graph.quads.size(), static_cast<long long>(sum));
  }
  return sum;
}

/// What a call asks for.
struct Options {
  unsigned first = 0, last = 20;
  index_t most = 5000;
  bool uses_nccl = true;
  int lacking = 0;
  std::string left_out;  ///< a row, "each", or empty: none
};

inline Options read_options(int argc, char** argv) {
  Options options;
  for (int a = 1; a < argc; ++a) options.uses_nccl = options.uses_nccl && argv[a] != std::string("--pinned");
  for (int a = 1; a + 1 < argc; ++a) {
    const std::string what = argv[a];
    if (what == "--seeds" && a + 2 < argc) {
      options.first = static_cast<unsigned>(std::atoi(argv[a + 1]));
      options.last = static_cast<unsigned>(std::atoi(argv[a + 2]));
    }
    if (what == "--lacking") options.lacking = std::atoi(argv[a + 1]);
    if (what == "--most") options.most = std::atoi(argv[a + 1]);
    if (what == "--without") options.left_out = argv[a + 1];
  }
  return options;
}

/// @param is_whole whether nothing may differ; else the first seed that differs is the last
template <class On>
Found run_seeds(const Ranks& ranks, const std::vector<HaloUse>& uses, const Options& options, bool is_whole) {
  Found found;
  const auto run_in = [&]<class Body>(unsigned seed) {
    found.differences += run_seed<On, Body>(ranks, uses, seed, options.most, options.uses_nccl, options.lacking, found);
  };
  for (unsigned seed = options.first; seed < options.last && (is_whole || found.differences == 0);
       ++seed) {  // all ranks know the sum
    ranks.guard([&] {
      using Space = typename On::Space;
      // nvcc takes minutes for each of these.
      constexpr bool has_all = std::is_same_v<Space, Host>;
      if constexpr (has_all) {
        if (seed % 3 == 0) run_in.template operator()<InFloat<Space>>(seed);
      }
      if (seed % 3 == 1) run_in.template operator()<InDouble<Space>>(seed);
      if (seed % 3 == 2 || (!has_all && seed % 3 == 0)) run_in.template operator()<InHalf<Space>>(seed);
    });
  }
  if (ranks.is_first())
    std::printf(
        "seeds %u to %u on %d ranks: %lld differences, %lld exchanges of %lld bytes, %lld exchanges overlapped, "
        "%zu needs of a set\n",
        options.first, options.last - 1, ranks.count(), static_cast<long long>(found.differences),
        static_cast<long long>(found.exchanges), static_cast<long long>(found.bytes),
        static_cast<long long>(found.overlapped), found.needs);
  return found;
}

template <class On>
int run(int argc, char** argv) {
  const Ranks ranks(argc, argv);
  const Options options = read_options(argc, argv);
  if (options.left_out == "each") {
    for (std::size_t row = 0; row < rows_that_count; ++row) {
      if (ranks.is_first()) std::printf("without row %zu: ", row);
      if (run_seeds<On>(ranks, without(row), options, false).differences > 0) continue;
      if (ranks.is_first()) std::fprintf(stderr, "without row %zu of the table nothing differs\n", row);
      return 4;
    }
    if (ranks.is_first()) std::printf("each of %zu rows of %zu is missed\n", rows_that_count, std::size(table));
    return 0;
  }
  const bool is_whole = options.left_out.empty();
  const std::vector<HaloUse> uses = is_whole ? std::vector<HaloUse>(std::begin(table), std::end(table))
                                             : without(static_cast<std::size_t>(std::stoul(options.left_out)));
  return run_seeds<On>(ranks, uses, options, is_whole).differences == 0 ? 0 : 3;
}

}  // namespace graphs
