// The tags of a file become numbers from 0, ascending: by a table where tags are dense, else by search.
#include <fem/mesh/check.h>
#include <fem/mesh/gmsh_file.h>
#include <fem/mesh/gmsh_groups.h>
#include <fem/mesh/gmsh_input.h>
#include <fem/mesh/gmsh_sections.h>
#include <fem/mesh/mapped_file.h>
#include <fem/mesh/stages.h>
#include <physgen/detail/launch.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

namespace physgen::fem {

namespace {

using Tags = std::vector<std::uint64_t>;
constexpr Index none = -1;

bool ascends(const Tags& tags) { return std::ranges::adjacent_find(tags, std::ranges::greater_equal()) == tags.end(); }

template <class List>
List picked(const List& values, const std::vector<std::size_t>& order) {
  List result;
  result.reserve(order.size());
  for (const std::size_t i : order) result.push_back(values[i]);
  return result;
}

// Brings nodes or tets into the order of their tags. One that stands there twice, as an element does in two groups, is
// taken once.
template <class List>
void sort_by_tag(const GmshInput& input, const std::string& kind, Tags& tags, List& values,
                 const HostList<std::uint64_t>& places) {
  if (ascends(tags)) return;
  std::vector<std::size_t> order(tags.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return tags[i]; });
  std::size_t kept = 0;
  for (const std::size_t i : order) {
    if (kept > 0 && tags[order[kept - 1]] == tags[i]) {
      const std::size_t before = order[kept - 1];
      if (values[before] == values[i]) continue;
      input.refuse(kind + " " + std::to_string(tags[i]) + " stands " + input.place_at(places[before]) +
                   " and, with other values, " + input.place_at(places[i]) +
                   "; give each a number of its own, or write the mesh again");
    }
    order[kept++] = i;
  }
  order.resize(kept);
  tags = picked(tags, order);
  values = picked(values, order);
}

// The numbers of nodes by their tags.
class Numbers {
 public:
  /// @pre tags ascend
  explicit Numbers(const Tags& tags) : tags_(tags) {
    if (tags.empty() || (tags.back() - tags.front()) / 4 > tags.size()) return;
    table_.assign(tags.back() - tags.front() + 1, none);
    physgen::detail::for_each_index(0, static_cast<index_t>(tags.size()), [&](index_t n) {
      table_[tags[static_cast<std::size_t>(n)] - tags.front()] = static_cast<Index>(n);
    });
  }
  [[nodiscard]] Index operator[](std::uint64_t tag) const {
    if (!table_.empty()) return tag - tags_.front() < table_.size() ? table_[tag - tags_.front()] : none;
    const auto found = std::ranges::lower_bound(tags_, tag);
    return found != tags_.end() && *found == tag ? static_cast<Index>(found - tags_.begin()) : none;
  }

 private:
  const Tags& tags_;
  std::vector<Index> table_;  // from the lowest tag on
};

[[noreturn]] void refuse_node(const GmshInput& input, std::uint64_t element, std::uint64_t node) {
  input.refuse("element " + std::to_string(element) + " names node " + std::to_string(node) +
               ", which the file does not have; write the mesh again, with all its nodes");
}

// The corners of all tets as numbers of nodes; marks those nodes.
std::vector<std::array<Index, 4>> number_tets(const GmshInput& input, const GmshSections& file, const Numbers& numbers,
                                              std::vector<std::uint8_t>& is_used) {
  std::vector<std::array<Index, 4>> tets(file.tets.size());
  std::atomic<std::size_t> first_missing = tets.size();
  physgen::detail::for_each_index<4>(0, static_cast<index_t>(tets.size()), [&](index_t i) {
    const auto t = static_cast<std::size_t>(i);
    for (std::size_t c = 0; c < 4; ++c) {
      const Index node = numbers[file.tets[t][c]];
      tets[t][c] = node;
      if (node != none) {
        std::atomic_ref(is_used[static_cast<std::size_t>(node)]).store(1, std::memory_order_relaxed);
      } else {
        for (std::size_t first = first_missing; t < first && !first_missing.compare_exchange_weak(first, t);) {
        }
      }
    }
  });
  if (const std::size_t t = first_missing; t < tets.size()) {
    refuse_node(input, file.tet_tags[t],
                file.tets[t][static_cast<std::size_t>(std::ranges::find(tets[t], none) - tets[t].begin())]);
  }
  return tets;
}

// Of the nodes of no tet, leaves out those of other elements, and all in the versions before 4, of which Gmsh does so.
void leave_out(const std::vector<std::uint8_t>& is_used, const std::vector<std::uint8_t>& is_of_others, bool all,
               ReadMesh& mesh) {
  std::vector<Index> number(is_used.size(), none);
  std::size_t kept = 0;
  for (std::size_t n = 0; n < is_used.size(); ++n) {
    if (is_used[n] == 0 && (all || is_of_others[n] != 0)) {
      mesh.left_out_nodes.push_back(mesh.node_tags[n]);
      continue;
    }
    mesh.node_tags[kept] = mesh.node_tags[n];
    mesh.rest[kept] = mesh.rest[n];
    number[n] = static_cast<Index>(kept++);
  }
  if (mesh.left_out_nodes.empty()) return;
  mesh.node_tags.resize(kept);
  mesh.rest.resize(kept);
  physgen::detail::for_each_index<4>(0, static_cast<index_t>(mesh.tets.size()), [&](index_t t) {
    for (Index& corner : mesh.tets[static_cast<std::size_t>(t)]) corner = number[static_cast<std::size_t>(corner)];
  });
}

/// A word of a command, in quotes where a shell needs them.
std::string typed(const std::filesystem::path& path) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./+-";
  if (path.string().find_first_not_of(plain) == std::string::npos) return path.string();
  std::string word = "'";
  for (const char c : path.string()) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

}  // namespace

ReadMesh read_gmsh(const std::filesystem::path& path) {
  InStage stage("reading of the mesh");
  const MappedFile bytes(path);
  GmshInput input(path.string(), bytes.is_open() ? bytes.bytes() : "");
  if (!bytes.is_open()) input.refuse("cannot be read; check its name and your rights");
  constexpr std::array known{"$MeshFormat", "$NOD", "$Comments", "$PhysicalNames"};
  constexpr std::array others{".inp", ".vtu", ".vtk", ".xdmf", ".med", ".mesh", ".bdf", ".nas", ".exo", ".e"};
  std::string end = path.extension().string();
  for (char& c : end) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (std::ranges::find(others, end) != others.end()) {
    input.refuse("is not in Gmsh's mesh format; convert it with its groups: physgen-convert-mesh " + typed(path) + " " +
                 typed(std::filesystem::path(path).replace_extension(".msh")) +
                 " (in a checkout tools/fem/mesh/convert.py)");
  }
  if (path.extension() != ".msh" || std::ranges::find(known, GmshInput(input).line()) == known.end()) {
    input.refuse("is not in Gmsh's mesh format; save the mesh as .msh (gmsh FILE -save -o FILE.msh)");
  }
  GmshSections file = read_gmsh_sections(input);
  if (file.tets.empty()) {
    input.refuse(std::string("has no tets") + (file.others.empty() ? "" : ", only points, lines or surfaces") +
                 "; mesh the volume (gmsh -3), and save it with the elements of the volume");
  }
  const std::vector<GmshGroup> groups = gmsh_groups_of(file);
  sort_by_tag(input, "node", file.node_tags, file.nodes, file.node_places);
  sort_by_tag(input, "element", file.tet_tags, file.tets, file.tet_places);
  const Numbers numbers(file.node_tags);
  std::vector<std::uint8_t> is_used(file.node_tags.size()), is_of_others(is_used.size());
  ReadMesh mesh;
  mesh.tets = number_tets(input, file, numbers, is_used);
  for (const auto [element, node] : file.others) {
    if (numbers[node] == none) refuse_node(input, element, node);
    is_of_others[static_cast<std::size_t>(numbers[node])] = 1;
  }
  mesh.rest = std::move(file.nodes);
  mesh.node_tags = std::move(file.node_tags);
  mesh.tet_tags = std::move(file.tet_tags);
  leave_out(is_used, is_of_others, file.version < 4, mesh);
  mesh.groups = number_groups(groups, mesh.node_tags, mesh.tet_tags, mesh.tets);
  stage.moves(bytes.bytes(), mesh.rest, mesh.tets, mesh.node_tags, mesh.tet_tags);
  return mesh;
}

}  // namespace physgen::fem
