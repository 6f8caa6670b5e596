// Fields by name, and nested objects, which have fields of their own: array.svd.U, array.points[2].x, array["svd.U"].
#pragma once

#include <physgen/python/device_field.h>

#include <set>

namespace physgen::python {

/// The fields whose names begin with a prefix, of all objects of an array. The array itself is that of no prefix.
class Part {
 public:
  explicit Part(py::object array, std::string prefix = "") : owner_(std::move(array)), prefix_(std::move(prefix)) {}

  /// A field, or a part of this one. Null: there is none of this name
  [[nodiscard]] py::object find(const std::string& name) const {
    const std::string full = full_name(name);
    for (std::size_t f = 0; f < fields().size(); ++f)
      if (fields()[f].name == full) return seen_field(array(), f);
    return is_part(full) ? py::cast(Part(owner_, full)) : py::object();
  }
  /// Sets a field. @return whether there is one of this name
  [[nodiscard]] bool set(const std::string& name, const py::object& values) const {
    const std::string full = full_name(name);
    for (std::size_t f = 0; f < fields().size(); ++f) {
      if (fields()[f].name != full) continue;
      write_field(array(), f, values);
      return true;
    }
    return false;
  }
  /// The entry of a fixed array of objects. @throw an IndexError
  [[nodiscard]] py::object entry(index_t index) const {
    const std::string name = "[" + std::to_string(index) + "]";
    if (py::object found = find(name)) return found;
    throw py::index_error(text() + " has no entry " + std::to_string(index));
  }

  /// The number of a field. @throw a KeyError
  [[nodiscard]] std::size_t number(const std::string& name) const {
    for (std::size_t f = 0; f < fields().size(); ++f)
      if (fields()[f].name == full_name(name)) return f;
    throw py::key_error(unknown(name));
  }

  /// Names of its fields and parts.
  [[nodiscard]] py::list names() const {
    std::set<std::string> found;
    const std::string begin = prefix_.empty() ? "" : prefix_ + ".";
    for (const FieldInfo& field : fields()) {
      if (!field.name.starts_with(begin)) continue;
      const std::string_view rest = field.name.substr(begin.size());
      found.emplace(rest.substr(0, rest.find_first_of(".[")));
    }
    py::list list;
    for (const std::string& name : found) list.append(name);
    return list;
  }
  /// "model::Stress.svd"
  [[nodiscard]] std::string text() const {
    return std::string(array().type().name) + (prefix_.empty() ? "" : "." + prefix_);
  }
  /// The words of an error: there is no such field, and which is nearest.
  [[nodiscard]] std::string unknown(const std::string& name) const {
    const py::list known = names();
    const py::list near = py::module_::import("difflib").attr("get_close_matches")(name, known, 1);
    const std::string hint = near.empty() ? "it has " + py::str(", ").attr("join")(known).cast<std::string>()
                                          : "did you mean '" + near[0].cast<std::string>() + "'?";
    return text() + " has no field '" + name + "'; " + hint;
  }

 private:
  [[nodiscard]] const ObjectArray& array() const { return owner_.cast<const ObjectArray&>(); }
  [[nodiscard]] std::span<const FieldInfo> fields() const { return array().fields(); }
  [[nodiscard]] std::string full_name(const std::string& name) const {
    return prefix_.empty() || name.starts_with('[') ? prefix_ + name : prefix_ + "." + name;
  }
  [[nodiscard]] bool is_part(const std::string& full) const {
    for (const FieldInfo& field : fields())
      if (field.name.starts_with(full + ".") || field.name.starts_with(full + "[")) return true;
    return false;
  }

  py::object owner_;
  std::string prefix_;
};

}  // namespace physgen::python
