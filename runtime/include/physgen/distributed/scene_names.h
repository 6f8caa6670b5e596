// What a scene says of the arrays of ranks: their names, what their index fields name, and which are rows. For the
// headers that physgen writes of scenes; users call distributed_scene.h.
#pragma once

#include <physgen/config.h>

#include <deque>
#include <limits>
#include <string>
#include <string_view>

namespace physgen::detail {

/// Arrays are told by their addresses.
class SceneNames {
 public:
  /// In place of a number of objects.
  static constexpr index_t not_given = std::numeric_limits<index_t>::min();

  struct IndexField {
    const void* array;
    std::string name;  ///< of the array, "body.edges"
    std::string field, set;
    bool is_connected = false;
  };
  struct RowsOfScene {
    const void *ranges, *entries;
    std::string of_ranges, name;  ///< "body.ranges", "body.ends"
    std::string field, set;       ///< of the entries, and what it names
    int shift;
    index_t entries_of_all;  ///< or not_given
    bool is_connected = false;
  };

  void add(const void* array, const std::string& name) { names_.push_back({array, name}); }
  void add_index_field(const void* array, const std::string& field, const std::string& set);
  void add_rows(const void* ranges, const std::string& name, const void* entries, const std::string& field,
                const std::string& set, int shift, index_t entries_of_all);

  /// @param field empty: the only one
  /// @throw Error when there is none, or it is connected
  [[nodiscard]] IndexField& to_be_connected(const void* array, std::string_view field);
  /// @throw Error when these are no rows, or they are connected
  [[nodiscard]] RowsOfScene& to_be_connected(const void* ranges, const void* entries);
  /// @throw Error when the size of a set is not given
  static void require_given(const std::string& set, index_t size);
  /// @throw Error when there are not as many rows as objects that have them
  static void require_rows(const RowsOfScene& rows, index_t given, const std::string& set, index_t size);
  /// @throw Error when there are more or fewer entries than were given
  static void require_entries(const RowsOfScene& rows, index_t there);
  /// @throw Error when something is not
  void require_all_connected() const;
  void cut() { is_cut_ = true; }
  /// @throw Error before cut()
  void require_cut() const;
  [[nodiscard]] const std::deque<RowsOfScene>& rows() const { return rows_; }

 private:
  struct Name {
    const void* array;
    std::string name;
  };
  [[nodiscard]] const std::string& name_of(const void* array) const;

  std::deque<Name> names_;
  std::deque<IndexField> index_fields_;
  std::deque<RowsOfScene> rows_;
  bool is_cut_ = false;
};

}  // namespace physgen::detail
