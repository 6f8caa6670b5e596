// Rows are read one after the other, but for the tets and nodes of binary blocks, whose places are known at once.
#include <fem/mesh/check.h>
#include <fem/mesh/gmsh_format.h>
#include <fem/mesh/gmsh_kinds.h>
#include <fem/mesh/gmsh_rows.h>
#include <fem/mesh/gmsh_sections.h>
#include <physgen/detail/launch.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <string>

namespace physgen::fem {

namespace {

class Reader : private GmshRows {
 public:
  explicit Reader(GmshInput& input) : GmshRows(input) {}

  GmshSections read() && {
    for (auto line = input_.line(); !line.empty(); line = input_.line()) {
      if (!line.starts_with('$') || line.starts_with("$End") || line.starts_with("$END")) continue;  // as Gmsh does
      start_ = line.data();
      name_ = line;
      end_ = (name_ == "$NOD" || name_ == "$ELM" ? "$END" : "$End") + name_.substr(1);
      bool skips = false;
      if (name_ == "$MeshFormat") {
        file_.version = version_ = read_gmsh_format(input_);
        skips = true;  // what later versions may add
      } else if (name_ == "$NOD" || name_ == "$Nodes" || name_ == "$ParametricNodes") {
        require_version();
        is_of_blocks() ? read_blocks_of_nodes() : read_nodes();
      } else if (name_ == "$PhysicalNames") {
        said_ = read_gmsh_names(input_, end_, file_.names);
      } else if (name_ == "$Entities" && is_of_blocks() && !file_.names.empty()) {
        said_ = read_gmsh_entities(input_, end_, file_.entities);
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
      if (input_.is_binary && parameters == 0) {
        read_binary_nodes(count);
        continue;
      }
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

  // A block of version 4.1: the tags of its nodes, and then where these lie.
  void read_binary_nodes(std::uint64_t count) {
    const std::uint64_t offset = input_.offset_of(input_.at());
    const char* tags = input_.skip(8 * count);
    const char* positions = input_.skip(24 * count);
    const std::size_t before = file_.nodes.size();
    file_.node_tags.resize(before + count);
    file_.node_places.resize(before + count);
    file_.nodes.resize(before + count);
    physgen::detail::for_each_index<4>(0, static_cast<index_t>(count), [&](index_t i) {
      const auto n = static_cast<std::size_t>(i);
      file_.node_places[before + n] = offset + 8 * n;
      std::memcpy(&file_.node_tags[before + n], tags + 8 * n, 8);
      std::memcpy(file_.nodes[before + n].data(), positions + 24 * n, 24);
    });
  }

  // ---- Elements

  // The nodes of an element, which are next.
  template <class Stored>
  void read_element(const GmshKind& kind, std::int64_t owner, std::uint64_t tag, std::uint64_t place) {
    file_.add_to_run(kind.dimension, owner, kind.type, kind.type == gmsh_tet ? file_.tets.size() : file_.others.size(),
                     1);
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
      std::int64_t ignored = 0;
      if (!input_.is_binary) tag = input_.natural<std::int32_t>();
      const GmshKind& kind = gmsh_kind_of(input_, input_.integer(), place);
      if (input_.is_binary) count = input_.natural<std::int32_t>();
      if (version_ >= 2) groups = input_.natural<std::int32_t>();
      if (input_.is_binary) require_rows(count, 4 * (1 + kind.nodes));
      if (count == 0 || count > said_ - e) refuse_rows();
      e += count;
      for (; count > 0; --count) {
        if (input_.is_binary) tag = input_.natural<std::int32_t>();
        std::int64_t owner = 0;  // what comes first, if anything does
        for (std::uint64_t g = 0; g < groups; ++g) (g == 0 ? owner : ignored) = input_.integer();
        if (version_ < 2 && input_.natural<std::int32_t>() != kind.nodes) {
          input_.refuse_at(place, "an element of type " + std::to_string(kind.type) + " has " +
                                      std::to_string(kind.nodes) + " nodes");
        }
        read_element<std::int32_t>(kind, owner, tag, offset);
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
      const std::int64_t entity = input_.integer();
      const GmshKind& kind = gmsh_kind_of(input_, input_.integer(), place);
      const std::uint64_t count = take(input_.natural<std::uint64_t>(), left);
      input_.end_row();
      require_rows(count, 8 * (1 + kind.nodes));
      if (kind.type == gmsh_tet) require_fits(count);
      if (kind.type == gmsh_tet && input_.is_binary) {
        read_binary_tets(entity, count);
        found_.at(static_cast<std::size_t>(&kind - gmsh_kinds.data())) += count;
        continue;
      }
      for (std::uint64_t e = 0; e < count; ++e) {
        row();
        const std::uint64_t offset = input_.offset_of(input_.here());
        const std::uint64_t tag = input_.natural<std::uint64_t>();
        read_element<std::uint64_t>(kind, entity, tag, offset);
        input_.end_row();
      }
    }
    if (left > 0) refuse_rows();
  }

  // A block of version 4.1: of each tet its tag and the tags of its nodes.
  void read_binary_tets(std::int64_t entity, std::uint64_t count) {
    if (count == 0) return;
    const std::uint64_t offset = input_.offset_of(input_.at());
    const char* rows = input_.skip(40 * count);
    const std::size_t before = file_.tets.size();
    file_.add_to_run(3, entity, gmsh_tet, before, count);
    file_.tet_tags.resize(before + count);
    file_.tet_places.resize(before + count);
    file_.tets.resize(before + count);
    physgen::detail::for_each_index<4>(0, static_cast<index_t>(count), [&](index_t i) {
      const auto t = static_cast<std::size_t>(i);
      file_.tet_places[before + t] = offset + 40 * t;
      std::memcpy(&file_.tet_tags[before + t], rows + 40 * t, 8);
      std::memcpy(file_.tets[before + t].data(), rows + 40 * t + 8, 32);
    });
  }

  GmshSections file_;
  std::array<std::uint64_t, gmsh_kinds.size()> found_{};
};

}  // namespace

GmshSections read_gmsh_sections(GmshInput& input) { return Reader(input).read(); }

}  // namespace physgen::fem
