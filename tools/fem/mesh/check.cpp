// Each kind of defect is found by a pass of its own, on all threads.
#include <fem/mesh/at.h>
#include <fem/mesh/check.h>
#include <fem/mesh/faces.h>
#include <fem/mesh/geometry.h>
#include <fem/mesh/stages.h>
#include <physgen/fill_rows.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

namespace physgen::fem {

namespace {

using Tet = std::array<Index, 4>;

void note(Finding& finding, std::size_t place) {
  if (++finding.count <= Finding::shown) finding.first.push_back(place);
}

bool is_finite(const Point& x) {
  return std::ranges::all_of(x, [](double value) { return std::isfinite(value); });
}

// Notes each of the objects 0 .. size-1 under its kind, which kind_of(i) says; one of kKinds or more is not noted.
template <std::size_t kKinds, class KindOf>
void look_at_each(std::size_t size, const std::array<Finding*, kKinds>& findings, const KindOf& kind_of) {
  constexpr std::size_t block = 1024;
  std::vector<std::array<Finding, kKinds>> of_blocks((size + block - 1) / block);
  physgen::detail::for_each_index<8 * block>(0, static_cast<index_t>(of_blocks.size()), [&](index_t b) {
    const std::size_t begin = block * static_cast<std::size_t>(b);
    for (std::size_t i = begin; i < std::min(size, begin + block); ++i) {
      if (const std::size_t kind = kind_of(i); kind < kKinds) note(of_blocks[begin / block][kind], i);
    }
  });
  for (const auto& of_block : of_blocks) {
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
      Finding& finding = *findings[kind];
      finding.count += of_block[kind].count;
      for (const std::size_t place : of_block[kind].first) {
        if (finding.first.size() < Finding::shown) finding.first.push_back(place);
      }
    }
  }
}

constexpr std::size_t sound = std::numeric_limits<std::size_t>::max();  // no kind

void look_at_volumes(MeshReport& report, std::span<const Point> rest, std::span<const Tet> tets) {
  look_at_each<2>(tets.size(), {&report.flat, &report.inverted}, [&](std::size_t t) {
    if (!std::ranges::all_of(tets[t], [&](Index node) { return is_finite(rest[at(node)]); })) return sound;
    double square = 0;
    for (const auto& [a, b] : tet_edges) {
      const Point edge = difference(rest[at(tets[t][at(b)])], rest[at(tets[t][at(a)])]);
      square = std::max(square, dot(edge, edge));
    }
    const double volumes = six_volumes(tets[t], rest), limit = MeshReport::flat_limit * square * std::sqrt(square);
    if (!(std::abs(volumes) > limit)) return std::size_t{0};  // or NaN, where products of coordinates overflow
    return volumes < 0 ? std::size_t{1} : sound;
  });
}

// Of each node, the tets that have it as one of their two lowest.
struct LowNodeTets {
  HostList<Index> first, tets;

  LowNodeTets(std::size_t nodes, std::span<const Tet> of) {
    fill_rows(
        Host{}, static_cast<index_t>(nodes), static_cast<index_t>(of.size()),
        [of](index_t t, const auto& put) {
          const Tet& tet = of[static_cast<std::size_t>(t)];
          const auto [low, high] = std::minmax(tet[0], tet[1]);
          const auto [other_low, other_high] = std::minmax(tet[2], tet[3]);
          const Index second = std::min(std::max(low, other_low), std::min(high, other_high));
          put(std::min(low, other_low), static_cast<Index>(t));
          if (second != std::min(low, other_low)) put(second, static_cast<Index>(t));
        },
        first, tets);
  }
};

// Faces tell of duplicates, too: tets that share a face and the node opposite. Each duplicate is looked for at the face
// without its highest node.
void look_at_faces(MeshReport& report, std::size_t nodes, std::span<const Tet> tets) {
  std::vector<std::array<std::size_t, 2>> duplicates;  // the duplicate, the tet before
  std::vector<std::size_t> crowded;
  std::mutex mutex;  // of these lists
  const LowNodeTets rows(nodes, tets);
  const auto tets_of = [&rows](Index node, const auto& act) {
    for (Index k = rows.first[at(node)]; k < rows.first[at(node) + 1]; ++k) act(rows.tets[at(k)]);
  };
  each_face(static_cast<Index>(nodes), tets, tets_of, [&](Index /*node*/, std::span<const FaceUse> uses) {
    if (uses.size() == 1) return;
    std::size_t different = 1;
    const FaceUse* original = uses.data();
    for (const FaceUse& use : uses.subspan(1)) {
      if (use.opposite() != original->opposite()) {
        original = &use;
        ++different;
      } else if (use.opposite() > use.third()) {
        const std::lock_guard lock(mutex);
        duplicates.push_back({at(use.tet()), at(original->tet())});
      }
    }
    if (different <= 2) return;
    const std::lock_guard lock(mutex);
    crowded.push_back(at(uses[0].tet()));
  });
  std::ranges::sort(duplicates);
  for (const auto& [duplicate, original] : duplicates) {
    note(report.duplicates, duplicate);
    if (report.originals.size() < Finding::shown) report.originals.push_back(original);
  }
  std::ranges::sort(crowded);
  for (const std::size_t tet : crowded) note(report.crowded, tet);
}

// Sets of nodes that hang together; the lowest node of each is its name. Several threads may unite at once.
class Sets {
 public:
  explicit Sets(std::size_t nodes) : parent_(nodes) {
    physgen::detail::for_each_index(0, static_cast<index_t>(nodes),
                                    [this](index_t n) { parent_[at(n)] = static_cast<Index>(n); });
  }

  Index find(Index node) {
    for (;;) {
      const Index parent = load(node);
      if (parent == node) return node;
      const Index above = load(parent);
      if (above != parent) std::atomic_ref(parent_[at(node)]).store(above, std::memory_order_relaxed);
      node = above;
    }
  }

  void unite(Index a, Index b) {
    for (;;) {
      a = find(a);
      b = find(b);
      if (a == b) return;
      Index high = std::max(a, b);
      if (std::atomic_ref(parent_[at(high)]).compare_exchange_weak(high, std::min(a, b))) return;
    }
  }

 private:
  [[nodiscard]] Index load(Index node) { return std::atomic_ref(parent_[at(node)]).load(std::memory_order_relaxed); }

  std::vector<Index> parent_;  // of a node, one that is not higher
};

void look_at_components(MeshReport& report, std::size_t nodes, std::span<const Tet> tets) {
  Sets sets(nodes);
  std::vector<std::uint8_t> referenced(nodes);
  physgen::detail::for_each_index<8>(0, static_cast<index_t>(tets.size()), [&](index_t t) {
    const Tet& tet = tets[at(t)];
    for (const Index node : tet) {
      std::atomic_ref(referenced[at(node)]).store(1, std::memory_order_relaxed);
      if (node != tet[0]) sets.unite(tet[0], node);
    }
  });
  std::vector<Index> place(nodes, -1);  // of the sets among the components that are shown
  for (std::size_t n = 0; n < nodes; ++n) {
    const auto node = static_cast<Index>(n);
    if (referenced[n] == 0) {
      note(report.unreferenced, n);
      continue;
    }
    const Index set = sets.find(node);
    if (set == node && ++report.component_count <= Finding::shown) {
      place[n] = static_cast<Index>(report.components.size());
      report.components.push_back({0, 0, node, -1});
    }
    if (place[at(set)] >= 0) ++report.components[at(place[at(set)])].nodes;
  }
  for (std::size_t t = 0; t < tets.size(); ++t) {
    const Index shown = place[at(sets.find(tets[t][0]))];
    if (shown < 0) continue;
    Component& component = report.components[at(shown)];
    if (component.tets++ == 0) component.lowest_tet = static_cast<Index>(t);
    if (report.component_count == 1) {  // which has them all
      component.tets = tets.size();
      break;
    }
  }
}

// @pre all tets are of nodes that exist
void look_at_usable(MeshReport& report, std::span<const Point> rest, std::span<const Tet> tets) {
  look_at_volumes(report, rest, tets);
  look_at_faces(report, rest.size(), tets);
  look_at_components(report, rest.size(), tets);
}

}  // namespace

bool fits_32_bits(std::size_t nodes, std::size_t tets) {
  constexpr std::size_t most = std::numeric_limits<Index>::max();
  return nodes <= most && tets <= most / (2 * tet_edges.size());  // each edge of a loose tet touches two nodes
}

MeshReport check_mesh(std::span<const Point> rest, std::span<const Tet> tets) {
  InStage stage("checks of the mesh");
  stage.moves(rest, tets);
  MeshReport report;
  report.nodes = rest.size();
  report.tets = tets.size();
  report.too_large = !fits_32_bits(rest.size(), tets.size());
  if (report.too_large) return report;

  look_at_each<1>(rest.size(), {&report.not_finite},
                  [&](std::size_t n) { return is_finite(rest[n]) ? sound : std::size_t{0}; });
  look_at_each<1>(tets.size(), {&report.out_of_range}, [&](std::size_t t) {
    const auto [low, high] = std::ranges::minmax(tets[t]);
    return low >= 0 && std::cmp_less(high, rest.size()) ? sound : std::size_t{0};
  });
  if (report.out_of_range.count == 0) {
    look_at_usable(report, rest, tets);
    return report;
  }
  std::vector<Tet> usable;
  std::vector<std::size_t> numbers;  // of the usable tets
  for (std::size_t t = 0; t < tets.size(); ++t) {
    const auto [low, high] = std::ranges::minmax(tets[t]);
    if (low < 0 || std::cmp_greater_equal(high, rest.size())) continue;
    usable.push_back(tets[t]);
    numbers.push_back(t);
  }
  look_at_usable(report, rest, usable);
  for (Finding* finding : {&report.flat, &report.inverted, &report.duplicates, &report.crowded}) {
    for (std::size_t& place : finding->first) place = numbers[place];
  }
  for (std::size_t& place : report.originals) place = numbers[place];
  for (Component& component : report.components)
    component.lowest_tet = static_cast<Index>(numbers[at(component.lowest_tet)]);
  return report;
}

}  // namespace physgen::fem
