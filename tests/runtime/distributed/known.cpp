// known: arrays over random graphs, of which each rank knows no more objects than it has, against those of ranks that
// know all: they have the same objects, and name the same. On as many ranks as it is started with.
//
//   --seeds A B     seeds A .. B-1
//   --lacks SET     the last rank that has some knows one object of the set less: cut() must end all ranks
// Exit status: 0 all equal; 3 differences were found.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>

#include "graph_body.h"

namespace graphs {

using OfGraph = InFloat<Host>;

/// What a rank has of a set, or of what all have.
KnownObjects known_of(const DistributedArrays& arrays, const std::string& name) {
  const LocalSet& set = arrays.set(name);
  const auto number = std::ranges::find(arrays.sets(), name, &DistributedSet::name) - arrays.sets().begin();
  if (const auto& computed = arrays.sets()[static_cast<std::size_t>(number)].computed) {
    return {computed->begin(arrays.ranks().rank()), computed->end(arrays.ranks().rank())};
  }
  if (set.first() == set.last()) return {set.runs().begin(set.rank()), set.runs().begin(set.rank())};
  return {set.global(set.first()), set.global(set.last() - 1) + 1};
}

bool are_equal(const LocalSet& one, const LocalSet& other) {
  return one.size() == other.size() && one.begin() == other.begin() && one.owned() == other.owned() &&
         one.runs().begin(one.rank()) == other.runs().begin(one.rank()) &&
         std::ranges::equal(one.ghosts(), other.ghosts());
}

template <class Array>
bool are_equal(const Array& one, const Array& other) {
  if (one.size() != other.size()) return false;
  for (index_t i = 0; i < one.size(); ++i) {
    for (int k = 0; k < Array::elements; ++k) {
      if (one.getdata(i, k) != other.getdata(i, k)) return false;
    }
  }
  return true;
}

/// How many sets and arrays differ.
int differences(const Ranks& ranks, unsigned seed, const std::string& lacking) {
  std::mt19937 random(seed);
  const auto nodes = static_cast<index_t>(1 + random() % (seed % 5 == 0 ? 64U : 20000U));
  const Graph graph(nodes, random);
  const bool follows = random() % 2 == 0, has_others = random() % 2 == 0;
  OfGraph all, some;
  DistributedArrays of_all(ranks, {}), of_some(ranks, {});
  distribute(of_all, all, graph, follows, has_others);
  distribute(of_some, some, graph, follows, has_others, [&](const char* set) {
    KnownObjects known = known_of(of_all, set);
    if (set == lacking && known.first < known.last && known.last == of_all.set(set).runs().size()) --known.last;
    return known;
  });
  int found = 0;
  for (const char* set : {"node", "edge", "quad", "group"})
    found += are_equal(of_all.set(set), of_some.set(set)) ? 0 : 1;
  const auto compare = [&](const auto&... arrays) { found += (... + (are_equal(all.*arrays, some.*arrays) ? 0 : 1)); };
  using B = OfGraph;
  compare(&B::edges, &B::others, &B::quads, &B::links, &B::homes, &B::ranges, &B::touched, &B::member_ranges, &B::ends,
          &B::touches, &B::members);
  return found;
}

}  // namespace graphs

int main(int argc, char** argv) {
  physgen::Ranks ranks(argc, argv);
  unsigned first = 0, last = 1;
  std::string lacking;
  for (int a = 1; a < argc; ++a) {
    const std::string word = argv[a];
    if (word == "--seeds" && a + 2 < argc) {
      first = static_cast<unsigned>(std::atoi(argv[a + 1]));
      last = static_cast<unsigned>(std::atoi(argv[a + 2]));
    }
    if (word == "--lacks" && a + 1 < argc) lacking = argv[a + 1];
  }
  int found = 0;
  ranks.guard([&] {
    for (unsigned seed = first; seed < last; ++seed) found += graphs::differences(ranks, seed, lacking);
  });
  std::printf("rank %d: %d differences\n", ranks.rank(), found);
  return found == 0 ? 0 : 3;
}
