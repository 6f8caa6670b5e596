// What a report of a mesh's faults says, in sentences.
#include <fem/mesh/check.h>

#include <string>

namespace physgen::fem {

namespace {

using Tags = std::span<const std::size_t>;

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
            " from element " + name(static_cast<std::size_t>(part.lowest_tet), tet_tags) + " and node " +
            name(static_cast<std::size_t>(part.lowest_node), node_tags);
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
