// The common part of structs over groups of arrays. A group has the arrays of its name in solver_groups.h, as physgen
// writes it for one scene or another; what a program has no arrays for, it does not compile.
#pragma once

#include <physgen/arrays/view.h>
#include <physgen/rows.h>

#include <limits>
#include <memory>
#include <type_traits>

namespace physgen::fem {

/// Stands for a group of arrays that a program does not have.
struct NoArrays {};

/// Arrays that a program has where its choices at run time ask for them; NoArrays where it never does.
template <class Group>
using Optional = std::conditional_t<std::is_same_v<Group, NoArrays>, NoArrays, std::unique_ptr<Group>>;

/// The type that an Optional may hold.
template <class Arrays>
using GroupOf = typename std::remove_cvref_t<Arrays>::element_type;

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
/// Makes arrays with these arguments. @pre the program may have them
template <class Arrays, class... Arguments>
void make(std::unique_ptr<Arrays>& arrays, const Arguments&... arguments) {
  arrays = std::make_unique<Arrays>(arguments...);
}
template <class... Arguments>
void make(NoArrays& /*arrays*/, const Arguments&... /*arguments*/) {}

/// Bytes of arrays, where there are such.
template <class Arrays>
[[nodiscard]] index_t bytes_where(const Arrays& arrays) {
  index_t bytes = 0;
  where(arrays, [&](const auto& some) { bytes = some.bytes(); });
  return bytes;
}

/// The same of two levels. @pre where the first has such arrays, the second has
template <class Arrays, class Body>
void where(Arrays& arrays, Arrays& others, const Body& body) {
  if constexpr (may_have<Arrays>) {
    if (arrays != nullptr) body(*arrays, *others);
  }
}

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
  /// Rows.
  [[nodiscard]] index_t size() const { return ranges_->size(); }

 private:
  static constexpr index_t targets =
      std::numeric_limits<std::int32_t>::max();  // who fills the entries has checked them

  Ranges* ranges_;
  Entries* entries_;
};

}  // namespace physgen::fem
