// Gmsh is one per process and changes settings of it: each reading opens it, takes the lists and closes it again.
#include <fcntl.h>
#include <fem/mesh/gmsh_file.h>
#include <fem/mesh/gmsh_text.h>
#include <gmsh.h>
#include <omp.h>
#include <physgen/error.h>
#include <unistd.h>

#include <algorithm>
#include <clocale>
#include <fstream>
#include <limits>
#include <mutex>
#include <span>
#include <string>
#include <utility>

namespace physgen::fem {

namespace {

using Tags = std::vector<std::size_t>;

// Keeps, and puts back, the settings that Gmsh changes for the whole process.
class KeptSettings {
 public:
  KeptSettings() : threads_(omp_get_max_threads()) {
    if (const char* name = std::setlocale(LC_ALL, nullptr)) locale_ = name;
  }
  ~KeptSettings() {
    omp_set_num_threads(threads_);
    static_cast<void>(std::setlocale(LC_ALL, locale_.c_str()));
  }
  KeptSettings(const KeptSettings&) = delete;
  KeptSettings& operator=(const KeptSettings&) = delete;

 private:
  int threads_;
  std::string locale_;
};

// Gmsh from initialize() to finalize(), without a word on the terminal.
class Session {
 public:
  Session() {
    try {
      gmsh::initialize(0, nullptr, false);
      gmsh::option::setNumber("General.Terminal", 0);
    } catch (...) {  // numbers, strings or exceptions, by the version of Gmsh
      throw Error("the Gmsh library does not start");
    }
  }
  ~Session() {
    try {
      gmsh::finalize();
    } catch (...) {  // nothing is left to do
      static_cast<void>(0);
    }
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
};

constexpr const char* unreadable = "cannot be read; check its name and your rights";

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& what) {
  throw Error("mesh file " + path.string() + ": " + what);
}

// The file, opened, under a name of the system: next to a file FILE Gmsh looks for FILE.opt, and runs the commands
// there. Nothing is left of that name, however the process ends.
class Opened {
 public:
  explicit Opened(const std::filesystem::path& path) : file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (file_ >= 0 && ::access(name().c_str(), R_OK) == 0) return;
    const bool is_open = file_ >= 0;
    close();
    refuse(path, is_open ? "cannot be read by the name " + name() + ", as Gmsh needs it; mount /proc" : unreadable);
  }
  ~Opened() { close(); }
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;

  [[nodiscard]] std::string name() const { return "/proc/self/fd/" + std::to_string(file_); }

 private:
  void close() const {
    if (file_ >= 0) ::close(file_);
  }

  int file_;
};

// Gmsh goes by a file's first characters, and runs whatever it does not know as a script. It passes over elements
// beyond those that a file counts.
void check_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path)) refuse(path, unreadable);
  std::string line;
  file >> line;
  constexpr std::array known{"$MeshFormat", "$NOD", "$Comments", "$PhysicalNames"};
  if (path.extension() != ".msh" || std::ranges::find(known, line) == known.end()) {
    refuse(path, "is not in Gmsh's mesh format; save the mesh as .msh (gmsh FILE -save -o FILE.msh)");
  }
  file.seekg(0);
  if (const std::string fault = fault_in_gmsh_text(file); !fault.empty()) refuse(path, fault);
}

struct Elements {
  std::vector<std::pair<std::size_t, std::array<std::size_t, 4>>> tets;  // tags of tet and nodes
  Tags others;  // nodes of elements without volume, some more than once
};

Elements elements_of(const std::filesystem::path& path) {
  Elements elements;
  std::vector<int> types;
  std::vector<Tags> tags, nodes;
  gmsh::model::mesh::getElements(types, tags, nodes);
  for (std::size_t i = 0; i < types.size(); ++i) {
    std::string name;
    int dimension = 0, order = 0, count = 0, primary = 0;
    std::vector<double> local;
    gmsh::model::mesh::getElementProperties(types[i], name, dimension, order, count, local, primary);
    if (dimension < 3) {
      elements.others.insert(elements.others.end(), nodes[i].begin(), nodes[i].end());
      continue;
    }
    const auto found = std::to_string(tags[i].size()) + " elements of the kind '" + name + "'";
    if (primary != 4) refuse(path, "has " + found + "; mesh the volume with tetrahedra alone");
    if (order != 1) {
      refuse(path, "has " + found + " of order " + std::to_string(order) +
                       "; save linear tetrahedra (Gmsh: Mesh.ElementOrder = 1, or -order 1)");
    }
    for (std::size_t t = 0; t < tags[i].size(); ++t) {
      const auto corner = std::span(nodes[i]).subspan(4 * t, 4);
      elements.tets.push_back({tags[i][t], {corner[0], corner[1], corner[2], corner[3]}});
    }
  }
  if (elements.tets.empty()) {
    refuse(path, std::string("has no tets") + (elements.others.empty() ? "" : ", only points, lines or surfaces") +
                     "; mesh the volume (gmsh -3), and save it with the elements of the volume");
  }
  std::ranges::sort(elements.tets);
  return elements;
}

void ascend_without_repeats(Tags& tags) {
  std::ranges::sort(tags);
  const auto repeats = std::ranges::unique(tags);
  tags.erase(repeats.begin(), repeats.end());
}

ReadMesh read_open_model(const std::filesystem::path& path) {
  Elements elements = elements_of(path);
  ascend_without_repeats(elements.others);
  Tags of_tets;
  of_tets.reserve(4 * elements.tets.size());
  for (const auto& [tag, corners] : elements.tets) of_tets.insert(of_tets.end(), corners.begin(), corners.end());
  ascend_without_repeats(of_tets);

  Tags tags;
  std::vector<double> coordinates, unused;
  gmsh::model::mesh::getNodes(tags, coordinates, unused, -1, -1, false, false);
  std::vector<std::pair<std::size_t, Point>> nodes;
  nodes.reserve(tags.size());
  for (std::size_t n = 0; n < tags.size(); ++n) {
    nodes.push_back({tags[n], {coordinates[3 * n], coordinates[3 * n + 1], coordinates[3 * n + 2]}});
  }
  std::ranges::sort(nodes, {}, [](const auto& node) { return node.first; });
  ReadMesh mesh;
  for (const auto& [tag, x] : nodes) {
    if (!std::ranges::binary_search(of_tets, tag) && std::ranges::binary_search(elements.others, tag)) {
      mesh.left_out_nodes.push_back(tag);
      continue;
    }
    mesh.node_tags.push_back(tag);
    mesh.rest.push_back(x);
  }
  if (mesh.rest.size() > std::numeric_limits<Index>::max()) {
    refuse(path,
           "has " + std::to_string(mesh.rest.size()) + " nodes, more than 32-bit numbers hold; mesh more coarsely");
  }
  for (const auto& [tag, corners] : elements.tets) {
    std::array<Index, 4> tet{};
    for (std::size_t c = 0; c < 4; ++c) {
      const auto node = std::ranges::lower_bound(mesh.node_tags, corners[c]);
      if (node == mesh.node_tags.end() || *node != corners[c]) {
        refuse(path, "element " + std::to_string(tag) + " names node " + std::to_string(corners[c]) +
                         ", which the file does not have; write the mesh again, with all its nodes");
      }
      tet[c] = static_cast<Index>(node - mesh.node_tags.begin());
    }
    mesh.tets.push_back(tet);
    mesh.tet_tags.push_back(tag);
  }
  return mesh;
}

// The last words of Gmsh, with the file's name in the place of the system's.
std::string last_words(const std::filesystem::path& path, const Opened& file) {
  std::string said;
  try {
    gmsh::logger::getLastError(said);
  } catch (...) {
    return "";
  }
  const std::string name = file.name();
  if (const std::size_t place = said.find(name); place != std::string::npos) {
    said.replace(place, name.size(), path.string());
  }
  return said.empty() ? "" : " (" + said + ")";
}

}  // namespace

ReadMesh read_gmsh(const std::filesystem::path& path) {
  check_text(path);
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  const KeptSettings settings;
  const Opened file(path);
  const Session session;
  try {
    gmsh::merge(file.name());
    return read_open_model(path);
  } catch (const Error&) {
    throw;
  } catch (...) {  // as in Session; or no memory for counts that are no counts
    refuse(path,
           "Gmsh cannot read it" + last_words(path, file) + "; the file may be cut off or damaged: write it again");
  }
}

}  // namespace physgen::fem
