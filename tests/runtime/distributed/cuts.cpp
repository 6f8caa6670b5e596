// cuts: what cut() makes of random sets, of which it leaves out groups that name nothing of others, against a search
// over all objects (cuts.h): the runs, the ghosts, the objects that lead to ghosts, and the local numbers in index
// fields and rows. On as many ranks as it is started with.
//
//   --seeds A B     seeds A .. B-1
// It prints how often edges were asked for their nodes, where these lie in their order and each rank owns some.
// Exit status: 0 all equal; 3 differences were found.
#include "cuts.h"

#include <elasticity.physgen.h>
#include <physgen/distributed/arrays.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <exception>

namespace cuts {

struct Rows {
  elasticity::IncidenceRangeArray<float> ranges;
  elasticity::IncidenceArray<float> entries;
};
struct Body {
  elasticity::EdgeArray<float> edges, link_nodes, link_edges, link_links, homes;
  elasticity::TetArray<float> quads;
  Rows ends, touches, members;
};

elasticity::Incidence<float> incidence(index_t element, int local) {
  elasticity::Incidence<float> value{};
  value.element = static_cast<std::int32_t>(element);
  value.local = local;
  return value;
}

/// @param asked counts how often an edge is asked for its nodes
void distribute(DistributedArrays& arrays, Body& body, const Sets& sets, std::atomic<index_t>& asked) {
  for (int s = 0; s < Sets::count; ++s) {
    s == Sets::group ? arrays.add_replicated_set(Sets::name[at(s)], sets.size[at(s)])
                     : arrays.add_set(Sets::name[at(s)], sets.size[at(s)]);
  }
  for (int s = 0; s < Sets::count; ++s) {
    if (sets.follows[at(s)]) arrays.follow(Sets::name[at(s)], "node");
  }
  const auto connect = [&](const char* name, auto& array, Sets::Field field) {
    const Names& names = sets.names[field];
    arrays.add(name, Sets::name[at(names.source)], array);
    arrays.connect(array, "nodes", Sets::name[at(names.target)], [&, field](index_t i) -> const auto& {
      if (field == Sets::edge_nodes) asked.fetch_add(1, std::memory_order_relaxed);
      return names.of[at(i)];
    });
  };
  connect("b.edges", body.edges, Sets::edge_nodes);
  connect("b.quads", body.quads, Sets::quad_nodes);
  connect("b.link_nodes", body.link_nodes, Sets::link_nodes);
  connect("b.link_edges", body.link_edges, Sets::link_edges);
  connect("b.link_links", body.link_links, Sets::link_links);
  connect("b.homes", body.homes, Sets::homes);
  const auto row_of = [&sets](Sets::Field field, int local) {
    return [&names = sets.names[field], local](index_t i, std::vector<elasticity::Incidence<float>>& row) {
      for (const index_t number : names.of[at(i)]) row.push_back(incidence(number, local));
    };
  };
  const auto rows = [&](const std::string& name, Rows& of, Sets::Field field) {
    const Names& names = sets.names[field];
    arrays.add(name + "_ranges", Sets::name[at(names.source)], of.ranges);
    arrays.connect_rows(of.ranges, name, of.entries, "element", Sets::name[at(names.target)],
                        [put = row_of(field, 0)](index_t i) {
                          std::vector<elasticity::Incidence<float>> row;
                          put(i, row);
                          return row;
                        });
  };
  rows("b.ends", body.ends, Sets::ends);
  rows("b.touches", body.touches, Sets::touches);
  arrays.add("b.members_ranges", "group", body.members.ranges);
  arrays.connect_rows(
      body.members.ranges, "b.members", body.members.entries, "element", {"edge", "node"},
      [put_edges = row_of(Sets::edges_of, 0), put_nodes = row_of(Sets::nodes_of, 1)](index_t i) {
        std::vector<elasticity::Incidence<float>> row;
        put_edges(i, row);
        put_nodes(i, row);
        return row;
      },
      0, [](const auto& entry) { return int(entry.local); });
  arrays.cut();
}

/// Of each global number the local one, or -1; found without LocalSet::local().
std::vector<index_t> local_numbers(const LocalSet& set) {
  std::vector<index_t> numbers(at(set.runs().size()), -1);
  for (index_t i = set.first(); i < set.last(); ++i) numbers[at(set.global(i))] = i;
  return numbers;
}

class Comparison {
 public:
  Comparison(const DistributedArrays& arrays, const Sets& sets)
      : arrays_(arrays), sets_(sets), found_(search(sets, arrays.ranks().rank(), arrays.ranks().count())) {}

  /// How many of the sets, fields and rows differ.
  int differences(const Body& body) {
    for (int s = 0; s < Sets::count; ++s) locals_.push_back(local_numbers(set(s)));
    int sum = 0;
    for (int s = 0; s < Sets::count; ++s) sum += is_same(s) ? 0 : 1;
    sum += field(body.edges, Sets::edge_nodes) + field(body.quads, Sets::quad_nodes);
    sum += field(body.link_nodes, Sets::link_nodes) + field(body.link_edges, Sets::link_edges);
    sum += field(body.link_links, Sets::link_links) + field(body.homes, Sets::homes);
    return sum + rows(body.ends, {Sets::ends}) + rows(body.touches, {Sets::touches}) +
           rows(body.members, {Sets::edges_of, Sets::nodes_of});
  }

 private:
  const DistributedArrays& arrays_;
  const Sets& sets_;
  Found found_;
  std::vector<std::vector<index_t>> locals_;

  [[nodiscard]] const LocalSet& set(int s) const { return arrays_.set(Sets::name[at(s)]); }
  [[nodiscard]] const DistributedSet& kept(int s) const {
    return *std::ranges::find(arrays_.sets(), Sets::name[at(s)], &DistributedSet::name);
  }
  static bool are_same(const Runs& one, const Runs& other) {
    bool same = one.ranks() == other.ranks() && one.size() == other.size();
    for (int r = 0; same && r < one.ranks(); ++r) same = one.begin(r) == other.begin(r);
    return same;
  }
  [[nodiscard]] bool is_same(int s) const {
    const LocalSet& here = set(s);
    if (!are_same(here.runs(), found_.runs[at(s)])) return false;
    if (s == Sets::group) return are_same(*kept(s).computed, found_.computed);
    if (!std::ranges::equal(here.ghosts(), found_.ghosts(s, here.rank()))) return false;
    if (here.runs().ranks() == 1) return kept(s).reached.empty();
    std::vector<std::uint64_t> reached(at((here.size() + DistributedSet::group - 1) / DistributedSet::group), 0);
    for (index_t i = 0; i < here.size(); ++i) {
      const index_t global = here.global(i);
      reached[at(i / DistributedSet::group)] |= global < 0 ? ~std::uint64_t{0} : found_.reached[at(s)][at(global)];
    }
    return reached == kept(s).reached;
  }
  [[nodiscard]] index_t local(int target, index_t number) const {
    return number < 0 ? -1 : locals_[at(target)][at(number)];
  }
  template <class Array>
  int field(const Array& array, Sets::Field which) const {
    const Names& names = sets_.names[which];
    const LocalSet& here = set(names.source);
    for (index_t i = here.first(); i < here.last(); ++i) {
      const std::vector<index_t>& wanted = names.of[at(here.global(i))];
      for (std::size_t k = 0; k < wanted.size(); ++k) {
        if (array.const_view()[i].nodes()[static_cast<int>(k)] != local(names.target, wanted[k])) return 1;
      }
    }
    return 0;
  }
  /// @param which that have entries, those of the first with local 0
  int rows(const Rows& rows, const std::vector<Sets::Field>& which) const {
    const int source = sets_.names[which.front()].source;
    const LocalSet& here = set(source);
    const auto ranges = rows.ranges.const_view();
    const auto entries = rows.entries.const_view();
    index_t next = 0;
    for (index_t i = 0; i < here.size(); ++i) {
      const index_t global = here.global(i);
      const bool has_row = source == Sets::group ? found_.computed.owns(arrays_.ranks().rank(), global)
                                                 : here.begin() <= i && i < here.end();
      if (ranges[i].begin() != next) return 1;
      for (std::size_t w = 0; has_row && w < which.size(); ++w) {
        const Names& names = sets_.names[which[w]];
        for (const index_t number : names.of[at(global)]) {
          if (next >= entries.size()) return 1;
          const auto entry = entries[next++];
          if (entry.element() != local(names.target, number) || entry.local() != static_cast<int>(w)) return 1;
        }
      }
      if (ranges[i].end() != next) return 1;
    }
    return 0;
  }
};

}  // namespace cuts

int main(int argc, char** argv) {
  using namespace cuts;
  const Ranks ranks(argc, argv);
  unsigned first = 0, last = 1;
  for (int a = 1; a + 2 < argc; ++a) {
    if (argv[a] != std::string("--seeds")) continue;
    first = static_cast<unsigned>(std::atoi(argv[a + 1]));
    last = static_cast<unsigned>(std::atoi(argv[a + 2]));
  }
  int sum = 0;
  index_t edges = 0, asked_of_ordered = 0;
  ranks.guard([&] {
    for (unsigned seed = first; seed < last; ++seed) {
      std::mt19937 random(seed);
      const bool is_ordered = seed % 6 == 1;
      const Sets sets(random, seed % 5 == 0 ? 64 : 20000, is_ordered && seed % 5 != 0);
      Body body;
      DistributedArrays arrays(ranks, {});
      std::atomic<index_t> asked = 0;
      distribute(arrays, body, sets, asked);
      const int found = Comparison(arrays, sets).differences(body);
      if (found > 0) std::printf("seed %u, rank %d: %d sets, fields or rows differ\n", seed, ranks.rank(), found);
      sum += found;
      if (!is_ordered || sets.size[Sets::node] < Runs::block * ranks.count()) continue;
      edges += sets.size[Sets::edge];
      asked_of_ordered += asked;
    }
  });
  std::printf("rank %d: seeds %u to %u: %d differences; %lld edges were asked %lld times\n", ranks.rank(), first,
              last - 1, sum, static_cast<long long>(edges), static_cast<long long>(asked_of_ordered));
  return sum == 0 ? 0 : 3;
}
