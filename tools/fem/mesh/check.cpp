// Each kind of defect is found by a pass of its own; the sentences stand at the end.
#include <fem/mesh/check.h>
#include <fem/mesh/faces.h>
#include <fem/mesh/geometry.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace physgen::fem {

namespace {

using Tet = std::array<Index, 4>;
using Tags = std::span<const std::size_t>;

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

void note(Finding& finding, std::size_t place) {
  if (++finding.count <= Finding::shown) finding.first.push_back(place);
}

bool is_finite(const Point& x) {
  return std::ranges::all_of(x, [](double value) { return std::isfinite(value); });
}

void look_at_volumes(MeshReport& report, std::span<const Point> rest, std::span<const Tet> tets,
                     const std::vector<std::size_t>& numbers) {
  for (std::size_t t = 0; t < tets.size(); ++t) {
    if (!std::ranges::all_of(tets[t], [&](Index node) { return is_finite(rest[at(node)]); })) continue;
    double square = 0;
    for (const auto& [a, b] : tet_edges) {
      const Point edge = difference(rest[at(tets[t][at(b)])], rest[at(tets[t][at(a)])]);
      square = std::max(square, dot(edge, edge));
    }
    const double volumes = six_volumes(tets[t], rest), limit = MeshReport::flat_limit * square * std::sqrt(square);
    if (!(std::abs(volumes) > limit)) {  // or NaN, where products of coordinates overflow
      note(report.flat, numbers[t]);
    } else if (volumes < 0) {
      note(report.inverted, numbers[t]);
    }
  }
}

// Faces tell of duplicates, too: tets that share a face and the node opposite. Each duplicate is looked for at the face
// without its highest node.
void look_at_faces(MeshReport& report, std::size_t nodes, std::span<const Tet> tets,
                   const std::vector<std::size_t>& numbers) {
  std::vector<std::array<std::size_t, 2>> duplicates;  // the duplicate, the tet before
  std::vector<std::size_t> crowded;
  each_face(static_cast<Index>(nodes), tets, [&](std::span<const FaceUse> uses) {
    std::size_t different = 1;
    const FaceUse* original = uses.data();
    for (const FaceUse& use : uses.subspan(1)) {
      if (use.opposite != original->opposite) {
        original = &use;
        ++different;
      } else if (use.opposite > use.nodes[2]) {
        duplicates.push_back({numbers[at(use.use.element)], numbers[at(original->use.element)]});
      }
    }
    if (different > 2) crowded.push_back(numbers[at(uses[0].use.element)]);
  });
  std::ranges::sort(duplicates);
  for (const auto& [duplicate, original] : duplicates) {
    note(report.duplicates, duplicate);
    if (report.originals.size() < Finding::shown) report.originals.push_back(original);
  }
  std::ranges::sort(crowded);
  for (const std::size_t tet : crowded) note(report.crowded, tet);
}

// Sets of nodes that hang together; the lowest node of each is its name.
class Sets {
 public:
  explicit Sets(std::size_t nodes) : parent_(nodes) { std::iota(parent_.begin(), parent_.end(), Index{0}); }

  Index find(Index node) {
    while (parent_[at(node)] != node) {
      parent_[at(node)] = parent_[at(parent_[at(node)])];
      node = parent_[at(node)];
    }
    return node;
  }

  void unite(Index a, Index b) {
    a = find(a);
    b = find(b);
    parent_[at(std::max(a, b))] = std::min(a, b);
  }

 private:
  std::vector<Index> parent_;
};

void look_at_components(MeshReport& report, std::size_t nodes, std::span<const Tet> tets,
                        const std::vector<std::size_t>& numbers) {
  Sets sets(nodes);
  std::vector<bool> referenced(nodes);
  for (const Tet& tet : tets) {
    for (const Index node : tet) {
      referenced[at(node)] = true;
      sets.unite(tet[0], node);
    }
  }
  std::vector<Index> place(nodes, -1);  // of the sets among the components that are shown
  for (std::size_t n = 0; n < nodes; ++n) {
    const auto node = static_cast<Index>(n);
    if (!referenced[n]) {
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
    if (component.tets++ == 0) component.lowest_tet = static_cast<Index>(numbers[t]);
  }
}

// ---- Sentences
// -------------------------------------------------------------------------------------------------------

std::string name(std::size_t place, Tags tags) { return std::to_string(place < tags.size() ? tags[place] : place); }

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

// " (nodes 3, 5, 8, ...)"
std::string places(const Finding& finding, const std::string& what, Tags tags) {
  std::string text = " (" + what + (finding.count == 1 ? " " : "s ");
  for (std::size_t i = 0; i < finding.first.size(); ++i) text += (i == 0 ? "" : ", ") + name(finding.first[i], tags);
  return text + (finding.count > finding.first.size() ? ", ...)" : ")");
}

}  // namespace

bool fits_32_bits(std::size_t nodes, std::size_t tets) {
  constexpr std::size_t most = std::numeric_limits<Index>::max();
  return nodes <= most && tets <= most / (2 * tet_edges.size());  // each edge of a loose tet touches two nodes
}

MeshReport check_mesh(std::span<const Point> rest, std::span<const Tet> tets) {
  MeshReport report;
  report.nodes = rest.size();
  report.tets = tets.size();
  report.too_large = !fits_32_bits(rest.size(), tets.size());
  if (report.too_large) return report;

  for (std::size_t n = 0; n < rest.size(); ++n) {
    if (!is_finite(rest[n])) note(report.not_finite, n);
  }
  std::vector<Tet> usable;
  std::vector<std::size_t> numbers;  // of the usable tets
  usable.reserve(tets.size());
  numbers.reserve(tets.size());
  for (std::size_t t = 0; t < tets.size(); ++t) {
    if (std::ranges::any_of(tets[t], [&](Index node) { return node < 0 || at(node) >= rest.size(); })) {
      note(report.out_of_range, t);
      continue;
    }
    usable.push_back(tets[t]);
    numbers.push_back(t);
  }
  look_at_volumes(report, rest, usable, numbers);
  look_at_faces(report, rest.size(), usable, numbers);
  look_at_components(report, rest.size(), usable, numbers);
  return report;
}

std::vector<std::string> MeshReport::errors(Tags node_tags, Tags tet_tags) const {
  std::vector<std::string> lines;
  const auto tell = [&](const Finding& finding, const std::string& kind, const std::string& what,
                        const std::string& remedy) {
    if (finding.count == 0) return;
    const Tags tags = kind == "node" ? node_tags : tet_tags;
    lines.push_back(counted(finding.count, kind) + " " + what + places(finding, kind, tags) + "; " + remedy);
  };
  if (too_large) {
    lines.push_back(counted(nodes, "node") + " and " + counted(tets, "element") +
                    " are more than 32-bit numbers can count; mesh more coarsely, or solve parts of the body");
    return lines;
  }
  if (tets == 0) lines.emplace_back("the mesh has no tetrahedra; mesh the volume, not only its surface");
  tell(out_of_range, "element", "with a node that does not exist", "write the mesh again, with all its nodes");
  tell(not_finite, "node", "with a coordinate that is not a finite number", "correct the coordinates or mesh again");
  tell(flat, "element", "without volume", "improve the mesh's quality there, or take the elements out");
  tell(inverted, "element", "of negative volume",
       inverted.count == tets ? "all are: the file numbers corners left-handed; exchange two corners of each element"
                              : "exchange two of their corners, or mesh again without overlaps");
  if (duplicates.count > 0) {
    std::string pairs = " (";
    for (std::size_t i = 0; i < duplicates.first.size(); ++i) {
      pairs += (i == 0 ? "" : ", ") + name(duplicates.first[i], tet_tags) + " as " + name(originals[i], tet_tags);
    }
    lines.push_back(counted(duplicates.count, "element") + " with the same four nodes as another" + pairs +
                    (duplicates.count > duplicates.first.size() ? ", ...)" : ")") + "; remove one of each");
  }
  tell(crowded, "element", "with a face of three or more elements",
       "parts of the mesh overlap; merge the volumes before meshing");
  tell(unreferenced, "node", "of no element", "remove what no element uses (in Gmsh: save the volumes alone)");
  return lines;
}

std::vector<std::string> MeshReport::warnings(Tags node_tags, Tags tet_tags) const {
  if (component_count < 2) return {};
  std::string text =
      "the mesh has " + std::to_string(component_count) + " parts that share no node; each needs supports of its own:";
  for (std::size_t i = 0; i < components.size(); ++i) {
    const Component& part = components[i];
    text += (i == 0 ? " " : ", ") + counted(part.tets, "element") + " and " + counted(part.nodes, "node") +
            " from element " + name(at(part.lowest_tet), tet_tags) + " and node " +
            name(at(part.lowest_node), node_tags);
  }
  return {text + (component_count > components.size() ? ", ..." : "")};
}

std::string MeshReport::describe(Tags node_tags, Tags tet_tags) const {
  std::string text = counted(nodes, "node") + ", " + counted(tets, "element") + "\n";
  for (const std::string& line : errors(node_tags, tet_tags)) text += "error: " + line + "\n";
  for (const std::string& line : warnings(node_tags, tet_tags)) text += "warning: " + line + "\n";
  return text;
}

}  // namespace physgen::fem
