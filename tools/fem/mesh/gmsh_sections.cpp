// A description of the format: Gmsh's reference manual, chapters "MSH file format" and its "legacy" versions 1 and 2.
#include <fem/mesh/check.h>
#include <fem/mesh/gmsh_sections.h>

#include <algorithm>
#include <span>
#include <string>

namespace physgen::fem {

namespace {

struct Kind {
  int type, dimension, order;
  std::size_t nodes;
  const char* name;  // as Gmsh has it; of elements with volume alone
};

constexpr int tet = 4;

// Up to order 5, by type.
constexpr std::array kinds{
    Kind{1, 1, 1, 2, ""},
    Kind{2, 2, 1, 3, ""},
    Kind{3, 2, 1, 4, ""},
    Kind{tet, 3, 1, 4, "Tetrahedron 4"},
    Kind{5, 3, 1, 8, "Hexahedron 8"},
    Kind{6, 3, 1, 6, "Prism 6"},
    Kind{7, 3, 1, 5, "Pyramid 5"},
    Kind{8, 1, 2, 3, ""},
    Kind{9, 2, 2, 6, ""},
    Kind{10, 2, 2, 9, ""},
    Kind{11, 3, 2, 10, "Tetrahedron 10"},
    Kind{12, 3, 2, 27, "Hexahedron 27"},
    Kind{13, 3, 2, 18, "Prism 18"},
    Kind{14, 3, 2, 14, "Pyramid 14"},
    Kind{15, 0, 0, 1, ""},
    Kind{16, 2, 2, 8, ""},
    Kind{17, 3, 2, 20, "Hexahedron 20"},
    Kind{18, 3, 2, 15, "Prism 15"},
    Kind{19, 3, 2, 13, "Pyramid 13"},
    Kind{20, 2, 3, 9, ""},
    Kind{21, 2, 3, 10, ""},
    Kind{22, 2, 4, 12, ""},
    Kind{23, 2, 4, 15, ""},
    Kind{24, 2, 5, 15, ""},
    Kind{25, 2, 5, 21, ""},
    Kind{26, 1, 3, 4, ""},
    Kind{27, 1, 4, 5, ""},
    Kind{28, 1, 5, 6, ""},
    Kind{29, 3, 3, 20, "Tetrahedron 20"},
    Kind{30, 3, 4, 35, "Tetrahedron 35"},
    Kind{31, 3, 5, 56, "Tetrahedron 56"},
    Kind{32, 3, 4, 22, "Tetrahedron 22"},
    Kind{33, 3, 5, 28, "Tetrahedron 28"},
    Kind{36, 2, 3, 16, ""},
    Kind{37, 2, 4, 25, ""},
    Kind{38, 2, 5, 36, ""},
    Kind{39, 2, 3, 12, ""},
    Kind{40, 2, 4, 16, ""},
    Kind{41, 2, 5, 20, ""},
    Kind{92, 3, 3, 64, "Hexahedron 64"},
    Kind{93, 3, 4, 125, "Hexahedron 125"},
};

class Reader {
 public:
  explicit Reader(GmshInput& input) : input_(input) {}

  GmshSections read() && {
    for (auto line = input_.line(); !line.empty(); line = input_.line()) {
      if (!line.starts_with('$') || line.starts_with("$End") || line.starts_with("$END")) continue;  // as Gmsh does
      start_ = line.data();
      name_ = line;
      end_ = (name_ == "$NOD" || name_ == "$ELM" ? "$END" : "$End") + name_.substr(1);
      bool skips = false;
      if (name_ == "$MeshFormat") {
        read_format();
        skips = true;  // what later versions may add
      } else if (name_ == "$NOD" || name_ == "$Nodes" || name_ == "$ParametricNodes") {
        require_version();
        is_of_blocks() ? read_blocks_of_nodes() : read_nodes();
      } else if (name_ == "$ELM" || name_ == "$Elements") {
        require_version();
        is_of_blocks() ? read_blocks_of_elements() : read_elements();
      } else {
        skips = true;
      }
      if (input_.pass(end_, skips)) continue;
      if (skips) refuse_end();
      refuse_rows();
    }
    refuse_other_solids();
    return std::move(file_);
  }

 private:
  [[nodiscard]] bool is_of_blocks() const { return file_.version >= 4; }
  [[nodiscard]] std::string section() const { return name_ + " " + input_.place(start_); }

  void read_format() {
    const std::string_view line = input_.line();
    std::array<double, 3> words{};
    const char *at = line.data(), *end = at + line.size();
    for (double& word : words) {
      while (at < end && *at == ' ') ++at;
      at = std::from_chars(at, end, word).ptr;
    }
    file_.version = words[0];
    input_.is_binary = words[1] != 0;
    if (!(words[0] >= 2 && words[0] <= 2.2) && words[0] != 4.1) {
      const std::string version(line.substr(0, std::min(line.find(' '), std::size_t{20})));
      input_.refuse("is in version " + version +
                    " of Gmsh's format; save it in version 4.1 (gmsh FILE -save -format msh41 -o FILE.msh)");
    }
    if (!input_.is_binary) return;
    const char* place = input_.here();
    const std::int64_t one = input_.integer();
    if (one == 0x01000000) {
      input_.refuse(
          "has numbers of another order of bytes; save it on a machine like this one, or as text (Gmsh: Mesh.Binary = "
          "0)");
    }
    if (one != 1 || words[2] != 8) input_.refuse_at(place, "this is no binary file with numbers of 8 bytes");
  }

  void require_version() const {
    if ((name_ != "$NOD" && name_ != "$ELM") == (file_.version >= 2)) return;
    input_.refuse_at(
        start_, name_ + " is not of version " + (file_.version < 2 ? "1" : "2 or 4.1") + ", as which the file begins");
  }

  // The numbers of a section's first row.
  std::array<std::uint64_t, 2> counts() {
    if (input_.is_binary && is_of_blocks()) {
      std::array<std::uint64_t, 2> numbers{};
      for (std::uint64_t& number : numbers) number = input_.natural<std::uint64_t>();
      for (int k = 0; k < 2; ++k) input_.natural<std::uint64_t>();  // the lowest and the highest tag
      return numbers;
    }
    const std::string_view line = input_.line();
    if (line.empty()) refuse_end();
    constexpr std::uint64_t most = std::uint64_t{1} << 60;
    std::array<std::uint64_t, 2> numbers{};
    const char *at = line.data(), *end = at + line.size();
    for (std::size_t k = 0; k < (is_of_blocks() ? 2 : 1); ++k) {
      while (at < end && (*at == ' ' || *at == '\t')) ++at;
      const auto [next, error] = std::from_chars(at, end, numbers.at(k));
      if (error != std::errc() || numbers.at(k) > most || (next < end && *next != ' ' && *next != '\t')) {
        input_.refuse_at(line.data(), name_ + " must begin with the counts of what follows, not with '" +
                                          std::string(line.substr(0, 40)) + "'");
      }
      at = next;
    }
    return numbers;
  }

  // ---- Rows

  void row() {
    if (!input_.row(end_)) refuse_rows();
  }

  /// @throw Error when there cannot be as many rows, of so many bytes in a binary file, in what is left of it
  void require_rows(std::uint64_t count, std::uint64_t bytes) const {
    if (!input_.is_binary || count <= input_.bytes_left() / bytes) return;
    input_.refuse_at(input_.at(), name_ + " has " + std::to_string(count) + " rows of " + std::to_string(bytes) +
                                      " bytes from here on by its counts, and the file ends after " +
                                      std::to_string(input_.bytes_left()) + " bytes");
  }

  /// How many rows to make room for: no more than a file of this size can have.
  [[nodiscard]] std::size_t room_for(std::uint64_t count) const { return std::min(count, input_.bytes_left() / 8); }

  [[noreturn]] void refuse_end() const { input_.refuse(section() + " has no " + end_ + GmshInput::again); }

  // For a section that does not end where it should.
  [[noreturn]] void refuse_rows() const {
    GmshInput again(input_, start_);
    again.line();  // the section's name
    if (input_.is_binary) {
      if (!again.pass(end_, true)) refuse_end();
      input_.refuse_at(input_.at(), section() + " has other rows than it counts");
    }
    again.line();  // the counts
    std::uint64_t lines = 0;
    std::string_view line = again.line();
    for (; !line.empty() && line != end_; line = again.line()) ++lines;
    if (line.empty()) refuse_end();
    if (lines == said_) {
      input_.refuse(section() + " has blocks that have other sums than its first counts" + GmshInput::again);
    }
    input_.refuse(section() + " should have " + std::to_string(said_) + " lines by its counts, but has " +
                  std::to_string(lines) + " before " + end_ + " " + input_.place(line.data()) + GmshInput::again);
  }

  // The rows of a block, taken from those that are left of a section.
  std::uint64_t take(std::uint64_t rows, std::uint64_t& left) const {
    if (rows > left) refuse_rows();
    left -= rows;
    return rows;
  }

  // ---- Nodes

  void make_room_for_nodes(std::uint64_t count) {
    if (count > std::numeric_limits<Index>::max()) {
      input_.refuse("has " + std::to_string(count) + " nodes, more than 32-bit numbers hold; mesh more coarsely");
    }
    file_.node_tags.reserve(file_.node_tags.size() + room_for(count));
    file_.node_places.reserve(file_.node_places.size() + room_for(count));
    file_.nodes.reserve(file_.nodes.size() + room_for(count));
  }

  template <class Stored>
  void read_tag_of_node() {
    file_.node_places.push_back(input_.offset_of(input_.here()));
    file_.node_tags.push_back(input_.natural<Stored>());
  }
  void read_position() {
    Point x{};
    for (double& coordinate : x) coordinate = input_.real();
    file_.nodes.push_back(x);
  }

  void read_nodes() {
    said_ = counts()[0];
    require_rows(said_, 28);
    make_room_for_nodes(said_);
    for (std::uint64_t n = 0; n < said_; ++n) {
      row();
      read_tag_of_node<std::int32_t>();
      read_position();
      if (name_ == "$ParametricNodes") {
        const std::int64_t dimension = input_.integer();
        input_.integer();  // the entity's tag
        for (std::int64_t k = 0; k < dimension && dimension < 3; ++k) input_.real();
      }
      input_.end_row();
    }
  }

  void read_blocks_of_nodes() {
    auto [blocks, left] = counts();
    said_ = blocks + 2 * left;
    make_room_for_nodes(left);
    for (; blocks > 0; --blocks) {
      row();
      const std::int64_t dimension = input_.integer();
      input_.integer();  // the entity's tag
      const std::int64_t parameters =
          input_.integer() == 0 ? 0 : std::clamp(dimension, std::int64_t{0}, std::int64_t{3});
      const std::uint64_t count = take(input_.natural<std::uint64_t>(), left);
      input_.end_row();
      require_rows(count, 8 * static_cast<std::uint64_t>(4 + parameters));
      for (std::uint64_t n = 0; n < count; ++n) {
        row();
        read_tag_of_node<std::uint64_t>();
        input_.end_row();
      }
      for (std::uint64_t n = 0; n < count; ++n) {
        row();
        read_position();
        for (std::int64_t k = 0; k < parameters; ++k) input_.real();
        input_.end_row();
      }
    }
    if (left > 0) refuse_rows();
  }

  // ---- Elements

  const Kind& kind_of(std::int64_t type, const char* place) const {
    const auto* found = std::ranges::lower_bound(kinds, type, {}, &Kind::type);
    if (found != kinds.end() && found->type == type) return *found;
    input_.refuse("has " + input_.place(place) + " an element of type " + std::to_string(type) +
                  ", which is not known here; mesh the volume with linear tetrahedra alone");
  }

  // The nodes of an element, which are next.
  template <class Stored>
  void read_element(const Kind& kind, std::uint64_t tag, std::uint64_t place) {
    ++found_.at(static_cast<std::size_t>(&kind - kinds.data()));
    if (kind.type == tet) {
      require_fits(1);
      std::array<std::uint64_t, 4> nodes{};
      for (std::uint64_t& node : nodes) node = input_.natural<Stored>();
      file_.tets.push_back(nodes);
      file_.tet_tags.push_back(tag);
      file_.tet_places.push_back(place);
      return;
    }
    for (std::size_t c = 0; c < kind.nodes; ++c) {
      const std::uint64_t node = input_.natural<Stored>();
      if (kind.dimension < 3) file_.others.push_back({tag, node});
    }
  }

  void require_fits(std::uint64_t more_tets) const {
    const std::uint64_t tets = file_.tets.size() + more_tets;
    if (fits_32_bits(0, tets)) return;
    input_.refuse("has at least " + std::to_string(tets) +
                  " tets, more than 32-bit numbers can count; mesh more coarsely, or solve parts of the body");
  }

  void make_room_for_tets(std::uint64_t count) {
    file_.tets.reserve(file_.tets.size() + room_for(count));
    file_.tet_tags.reserve(file_.tet_tags.size() + room_for(count));
    file_.tet_places.reserve(file_.tet_places.size() + room_for(count));
  }

  void read_elements() {
    said_ = counts()[0];
    require_rows(said_, 12);
    make_room_for_tets(said_);
    for (std::uint64_t e = 0; e < said_;) {
      row();
      const char* place = input_.here();
      const std::uint64_t offset = input_.offset_of(place);
      std::uint64_t tag = 0, count = 1, groups = 2;
      if (!input_.is_binary) tag = input_.natural<std::int32_t>();
      const Kind& kind = kind_of(input_.integer(), place);
      if (input_.is_binary) count = input_.natural<std::int32_t>();
      if (file_.version >= 2) groups = input_.natural<std::int32_t>();
      if (input_.is_binary) require_rows(count, 4 * (1 + kind.nodes));
      if (count == 0 || count > said_ - e) refuse_rows();
      e += count;
      for (; count > 0; --count) {
        if (input_.is_binary) tag = input_.natural<std::int32_t>();
        for (std::uint64_t g = 0; g < groups; ++g) input_.integer();
        if (file_.version < 2 && input_.natural<std::int32_t>() != kind.nodes) {
          input_.refuse_at(place, "an element of type " + std::to_string(kind.type) + " has " +
                                      std::to_string(kind.nodes) + " nodes");
        }
        read_element<std::int32_t>(kind, tag, offset);
        input_.end_row();
      }
    }
  }

  void read_blocks_of_elements() {
    auto [blocks, left] = counts();
    said_ = blocks + left;
    make_room_for_tets(left);
    for (; blocks > 0; --blocks) {
      row();
      const char* place = input_.here();
      input_.integer();  // the entity's dimension
      input_.integer();  // and tag
      const Kind& kind = kind_of(input_.integer(), place);
      const std::uint64_t count = take(input_.natural<std::uint64_t>(), left);
      input_.end_row();
      require_rows(count, 8 * (1 + kind.nodes));
      if (kind.type == tet) require_fits(count);
      for (std::uint64_t e = 0; e < count; ++e) {
        row();
        const std::uint64_t offset = input_.offset_of(input_.here());
        const std::uint64_t tag = input_.natural<std::uint64_t>();
        read_element<std::uint64_t>(kind, tag, offset);
        input_.end_row();
      }
    }
    if (left > 0) refuse_rows();
  }

  void refuse_other_solids() const {
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      const Kind& kind = kinds.at(k);
      if (kind.dimension < 3 || kind.type == tet || found_.at(k) == 0) continue;
      const std::string name = kind.name;
      const std::string found = "has " + std::to_string(found_.at(k)) + " elements of the kind '" + name + "'";
      if (!name.starts_with("Tet")) input_.refuse(found + "; mesh the volume with tetrahedra alone");
      input_.refuse(found + " of order " + std::to_string(kind.order) +
                    "; save linear tetrahedra (Gmsh: Mesh.ElementOrder = 1, or -order 1)");
    }
  }

  GmshInput& input_;
  GmshSections file_;
  std::array<std::uint64_t, kinds.size()> found_{};
  // The section that is being read.
  const char* start_ = nullptr;
  std::string name_, end_;
  std::uint64_t said_ = 0;  // lines behind the first one, as that says
};

}  // namespace

GmshSections read_gmsh_sections(GmshInput& input) { return Reader(input).read(); }

}  // namespace physgen::fem
