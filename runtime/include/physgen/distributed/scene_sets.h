// The sets and arrays of a scene on several ranks, as the headers declare them that physgen writes of scenes; users
// call distributed_scene.h.
#pragma once

#include <physgen/distributed/arrays.h>
#include <physgen/distributed/scene_names.h>
#include <physgen/scenes/scene_arrays.h>

#include <functional>
#include <initializer_list>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

namespace physgen::detail {

/// What may be written of an array: the array itself, or what stands behind an array that programs only read.
template <class Array>
[[nodiscard]] auto& contents_of(Array& array) {
  if constexpr (requires { array.contents(); }) {
    return array.contents();
  } else {
    return array;
  }
}

class SceneSets : public DistributedArrays {
 public:
  using DistributedArrays::DistributedArrays;

  // ---- What a scene declares, in the constructor of its arrays. ----

  /// @throw Error when the size is not given
  void add_set(const std::string& name, index_t size) {
    SceneNames::require_given(name, size);
    DistributedArrays::add_set(name, size);
  }
  /// The set of arrays that have so many objects on every rank; its name is none that a scene can give.
  [[nodiscard]] std::string set_of_all(index_t count) {
    std::string name = std::to_string(count) + (count == 1 ? " object" : " objects");
    if (std::ranges::find(sets(), name, &DistributedSet::name) == sets().end()) add_replicated_set(name, count);
    return name;
  }
  /// @param array as generated: stored, uniform, or local to joined steps
  /// @param written_first fields that hold no value before the program writes them
  template <class Array>
  void add_array(const std::string& name, std::string_view set, Array& array,
                 std::initializer_list<std::string_view> written_first = {}) {
    scene_names_.add(&array, name);
    if constexpr (requires { array.untyped(); }) {
      add_stored(name, set, contents_of(array), written_first);
    } else {
      // It holds no objects, or one record for all of them, and has as many as the others of its set.
      if constexpr (requires { array.contents(); }) {
        add(name, set_of_all(1), array.contents());
        arrays().back().uniform_of = number_of(set);
      }
      sizes_.emplace_back([&array, of = std::string(set), this] { array.resize(this->set(of).size()); });
    }
  }
  template <class Array>
  void names(const Array& array, const std::string& field, const std::string& set) {
    scene_names_.add_index_field(&array, field, set);
  }
  /// @param name of the entries, which connect() adds
  /// @param entries_of_all how many there are in the rows of all ranks, or not given
  template <class Ranges, class Entries>
  void rows(const Ranges& ranges, const std::string& name, const Entries& entries, const std::string& field,
            const std::string& set, int shift, index_t entries_of_all) {
    scene_names_.add_rows(&ranges, name, &entries, field, set, shift, entries_of_all);
  }

  // ---- What the arrays are asked for. ----

  [[nodiscard]] SceneNames& scene_names() { return scene_names_; }
  /// The set of an array before cut().
  [[nodiscard]] const DistributedSet& declared_set(const void* array) const {
    return sets()[static_cast<std::size_t>(arrays()[static_cast<std::size_t>(number_of_array(array))].set)];
  }
  /// @throw Error when an index field is not connected, and what DistributedArrays throws
  void cut() {
    scene_names_.require_all_connected();
    DistributedArrays::cut();
    scene_names_.cut();
    for (const auto& size : sizes_) size();
    for (const SceneNames::RowsOfScene& rows : scene_names_.rows()) {
      if (rows.entries_of_all != SceneNames::not_given) SceneNames::require_entries(rows, entries_of_all(rows));
    }
  }

 private:
  template <class Array>
  void add_stored(const std::string& name, std::string_view set, Array& array,
                  std::vector<std::string_view> written_first) {
    const auto resize = [&array, this, fields = std::move(written_first)](index_t size) {
      array = make_array<Array>(size, ranks(), transport());
      if constexpr (checked_build) {
        for (const std::string_view field : fields) start_without_values(array.untyped(), {field});
      }
    };
    Partition::add_array({name, number_of(set), &array, [&array] { return array.untyped(); }, resize});
  }
  /// Each rank counts the entries of the rows that it owns.
  [[nodiscard]] index_t entries_of_all(const SceneNames::RowsOfScene& rows) const {
    const index_t mine = entries_of_owned(number_of_array(rows.ranges));
    std::vector<index_t> all(static_cast<std::size_t>(ranks().count()));
    const std::vector<index_t> sizes(all.size(), index_t{sizeof(mine)});
    transport().gather(std::as_bytes(std::span(&mine, 1)), sizes, std::as_writable_bytes(std::span(all)));
    return std::accumulate(all.begin(), all.end(), index_t{0});
  }

  SceneNames scene_names_;
  std::vector<std::function<void()>> sizes_;  // of arrays that hold no objects by themselves
};

}  // namespace physgen::detail
