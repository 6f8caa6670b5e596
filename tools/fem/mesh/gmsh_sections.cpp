// Rows are read one after the other, in text as in binary files.
#include <fem/mesh/check.h>
#include <fem/mesh/gmsh_format.h>
#include <fem/mesh/gmsh_kinds.h>
#include <fem/mesh/gmsh_sections.h>

#include <algorithm>
#include <span>
#include <string>

namespace physgen::fem {

namespace {

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
        file_.version = read_gmsh_format(input_);
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
    refuse_other_solids(input_, found_);
    return std::move(file_);
  }

 private:
  [[nodiscard]] bool is_of_blocks() const { return file_.version >= 4; }
  [[nodiscard]] std::string section() const { return name_ + " " + input_.place(start_); }

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

  // The nodes of an element, which are next.
  template <class Stored>
  void read_element(const GmshKind& kind, std::uint64_t tag, std::uint64_t place) {
    ++found_.at(static_cast<std::size_t>(&kind - gmsh_kinds.data()));
    if (kind.type == gmsh_tet) {
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
      const GmshKind& kind = gmsh_kind_of(input_, input_.integer(), place);
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
      const GmshKind& kind = gmsh_kind_of(input_, input_.integer(), place);
      const std::uint64_t count = take(input_.natural<std::uint64_t>(), left);
      input_.end_row();
      require_rows(count, 8 * (1 + kind.nodes));
      if (kind.type == gmsh_tet) require_fits(count);
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

  GmshInput& input_;
  GmshSections file_;
  std::array<std::uint64_t, gmsh_kinds.size()> found_{};
  // The section that is being read.
  const char* start_ = nullptr;
  std::string name_, end_;
  std::uint64_t said_ = 0;  // lines behind the first one, as that says
};

}  // namespace

GmshSections read_gmsh_sections(GmshInput& input) { return Reader(input).read(); }

}  // namespace physgen::fem
