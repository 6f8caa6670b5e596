// What is wrong with the calls for the arrays of a scene, with the remedy.
#include <physgen/distributed/scene_names.h>
#include <physgen/error.h>

#include <algorithm>

namespace physgen::detail {

const std::string& SceneNames::name_of(const void* array) const {
  const auto found = std::ranges::find(names_, array, &Name::array);
  if (found == names_.end()) {
    throw Error("an array is none of those of the scene; give a member of the struct whose function this is");
  }
  return found->name;
}

void SceneNames::add_index_field(const void* array, const std::string& field, const std::string& set) {
  index_fields_.push_back({array, name_of(array), field, set});
}

void SceneNames::add_rows(const void* ranges, const std::string& name, const void* entries, const std::string& field,
                          const std::string& set, int shift, index_t entries_of_all) {
  add(entries, name);
  rows_.push_back({ranges, entries, name_of(ranges), name, field, set, shift, entries_of_all});
}

SceneNames::IndexField& SceneNames::to_be_connected(const void* array, std::string_view field) {
  const std::string& name = name_of(array);
  if (is_cut_) throw Error(name + " is connected behind cut(); connect all arrays before it");
  const auto rows = std::ranges::find(rows_, array, &RowsOfScene::entries);
  if (rows != rows_.end()) {
    throw Error(name + " are the entries of the rows of " + rows->of_ranges + "; connect both, connect(" +
                rows->of_ranges + ", " + name + ", ...)");
  }
  IndexField* found = nullptr;
  std::string fields;
  bool are_several = false;
  for (IndexField& one : index_fields_) {
    if (one.array != array) continue;
    fields += (fields.empty() ? "" : " and ") + one.field;
    if (!field.empty() && one.field != field) continue;
    are_several = found != nullptr;
    found = &one;
  }
  if (fields.empty()) {
    throw Error(name +
                " names no objects by a field that the program reads; write names(\"...\", \"...\") where the scene "
                "declares it, or do not connect it");
  }
  if (found == nullptr) {
    throw Error(name + " names no objects by a field " + std::string(field) + "; it does by " + fields);
  }
  if (are_several) {
    throw Error(name + " names objects by its fields " + fields + "; connect each of them, connect(" + name + ", \"" +
                found->field + "\", ...)");
  }
  if (found->is_connected) {
    throw Error(name + "." + found->field + " is connected a second time; connect each field once");
  }
  return *found;
}

SceneNames::RowsOfScene& SceneNames::to_be_connected(const void* ranges, const void* entries) {
  const std::string &of_ranges = name_of(ranges), &name = name_of(entries);
  if (is_cut_) throw Error(name + " are connected behind cut(); connect all arrays before it");
  std::string all;
  for (RowsOfScene& one : rows_) {
    all += (all.empty() ? "" : ", ") + one.of_ranges + " with " + one.name;
    if (one.ranges != ranges || one.entries != entries) continue;
    if (one.is_connected) throw Error(name + " are connected a second time; connect the rows once");
    return one;
  }
  throw Error(of_ranges + " and " + name + " are no rows that the program reads; " +
              (all.empty() ? "it reads none" : "it reads " + all));
}

void SceneNames::require_given(const std::string& set, index_t size) {
  if (size != not_given) return;
  throw Error("the number of objects of set " + set + " is not given; give it with the others, {." + set + " = ...}");
}

void SceneNames::require_rows(const RowsOfScene& rows, index_t given, const std::string& set, index_t size) {
  if (given == size) return;
  throw Error(rows.of_ranges + ": " + std::to_string(given) + " rows are given for a set " + set + " of " +
              std::to_string(size) + " objects; give the rows of all objects");
}

void SceneNames::require_entries(const RowsOfScene& rows, index_t there) {
  if (rows.entries_of_all == not_given || there == rows.entries_of_all) return;
  throw Error("the rows of " + rows.of_ranges + " have " + std::to_string(there) + " entries, and " + rows.name +
              " was said to have " + std::to_string(rows.entries_of_all) + "; correct one of them");
}

void SceneNames::require_all_connected() const {
  for (const IndexField& one : index_fields_) {
    if (one.is_connected) continue;
    throw Error(one.name + "." + one.field + " names objects of " + one.set +
                ", and it is not known which; call connect(" + one.name + ", ...) before cut()");
  }
  for (const RowsOfScene& one : rows_) {
    if (one.is_connected) continue;
    throw Error("the rows of " + one.of_ranges + " name objects of " + one.set +
                ", and it is not known which; call connect(" + one.of_ranges + ", " + one.name + ", ...) before cut()");
  }
}

void SceneNames::require_cut() const {
  if (!is_cut_)
    throw Error(
        "the arrays of ranks have no objects before cut(); call cut() behind the last connect(), and then make the "
        "executor");
}

}  // namespace physgen::detail
