// The solver's program over groups of arrays by name, whoever has made them: a mesh on which equilibrium is sought, and
// a level of the preconditioner. What a program has no arrays for, it does not compile.
#pragma once

#include <fem/solver/tet_chunks.h>
#include <physgen/rows.h>
#include <physgen/view.h>

#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace physgen::fem {

/// Stands for a group of arrays that a program does not have.
struct NoArrays {};

/// Arrays that a program has where its choices at run time ask for them; NoArrays where it never does.
template <class Group>
using Optional = std::conditional_t<std::is_same_v<Group, NoArrays>, NoArrays, std::unique_ptr<Group>>;

/// Whether a program may have the arrays that an Optional is of.
template <class Arrays>
inline constexpr bool may_have = !std::is_same_v<std::remove_cvref_t<Arrays>, NoArrays>;

/// Calls body(*arrays) where there are such arrays. @return whether
template <class Arrays, class Body>
bool where(Arrays& arrays, const Body& body) {
  if constexpr (may_have<Arrays>) {
    if (arrays == nullptr) return false;
    body(*arrays);
    return true;
  } else {
    return false;
  }
}
/// The same of two levels. @pre where the first has such arrays, the second has
template <class Arrays, class Body>
void where(Arrays& arrays, Arrays& others, const Body& body) {
  if constexpr (may_have<Arrays>) {
    if (arrays != nullptr) body(*arrays, *others);
  }
}

/// What a program of the solver may be asked for at run time; the rest is not compiled.
struct AnyChoice {
  static constexpr bool assembled = true;    ///< a stiffness that is assembled, and multigrid
  static constexpr bool matrix_free = true;  ///< products by tets
  static constexpr bool grids = true;        ///< levels of a background grid
};

/// Two arrays as the rows that they are. @pre they stay where they are
template <class Ranges, class Entries>
class RowsOf {
 public:
  using View = Rows<typename Ranges::ConstView, typename Entries::View>;
  using ConstView = Rows<typename Ranges::ConstView, typename Entries::ConstView>;

  RowsOf(Ranges& ranges, Entries& entries) : ranges_(&ranges), entries_(&entries) {}
  RowsOf(const RowsOf&) = delete;
  RowsOf& operator=(const RowsOf&) = delete;
  ~RowsOf() = default;

  [[nodiscard]] View view() { return {ranges_->const_view(), entries_->view(), targets}; }
  [[nodiscard]] ConstView view() const { return const_view(); }
  [[nodiscard]] ConstView const_view() const { return {ranges_->const_view(), entries_->const_view(), targets}; }

 private:
  static constexpr index_t targets =
      std::numeric_limits<std::int32_t>::max();  // who fills the entries has checked them

  Ranges* ranges_;
  Entries* entries_;
};

/// @tparam Group with the arrays of Patches in solver_groups.h, as are those of the others
template <class Group>
struct PatchesOver : Group {
  explicit PatchesOver(Group&& arrays) : Group(std::move(arrays)) {}

  RowsOf<decltype(Group::patch_tet_ranges), decltype(Group::patch_tet_entries)> patch_tets{this->patch_tet_ranges,
                                                                                           this->patch_tet_entries};
  RowsOf<decltype(Group::edge_patch_ranges), decltype(Group::edge_patch_entries)> edge_patches{
      this->edge_patch_ranges, this->edge_patch_entries};
  RowsOf<decltype(Group::node_patch_ranges), decltype(Group::node_patch_entries)> node_patches{
      this->node_patch_ranges, this->node_patch_entries};
};

template <class Group>
struct RingsOver : Group {
  explicit RingsOver(Group&& arrays) : Group(std::move(arrays)) {}

  RowsOf<decltype(Group::node_ranges), decltype(Group::node_entries)> nodes{this->node_ranges, this->node_entries};
};

/// A mesh on which equilibrium is sought.
template <class Real_, class Body, class Patches, class Rings, class Chunk>
struct EquilibriumOver : Body {
  using Real = Real_;

  std::vector<TetChunk> chunks;
  Optional<Patches> patches;            ///< where volumes are averaged over them
  Optional<Rings> rings;                ///< where volumes are averaged at nodes
  std::shared_ptr<Chunk> chunk_arrays;  ///< meshes of one solver share them
  RowsOf<decltype(Body::node_tet_ranges), decltype(Body::node_tet_entries)> node_tets{this->node_tet_ranges,
                                                                                      this->node_tet_entries};
  RowsOf<decltype(Body::edge_tet_ranges), decltype(Body::edge_tet_entries)> edge_tets{this->edge_tet_ranges,
                                                                                      this->edge_tet_entries};

  explicit EquilibriumOver(Body&& arrays) : Body(std::move(arrays)) {}

  [[nodiscard]] index_t nodes() const { return this->rest.size(); }
  [[nodiscard]] index_t tet_count() const { return this->tets.size(); }
  /// As one chunk. @pre the tangents of all tets are kept
  [[nodiscard]] TetChunk all_tets() const { return {0, tet_count(), 0, nodes(), 0, 0}; }
};

}  // namespace physgen::fem
