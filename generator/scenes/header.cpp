// See header.h.
#include "scenes/header.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "emit/printer.h"

namespace physgen::scenes {
namespace {

std::string capital(std::string name) {
  if (!name.empty()) name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
  return name;
}

/// "svd.U": the nested object "svd", and "U" in it; "U": "" and "U".
std::pair<std::string, std::string> split(const std::string& field) {
  const std::size_t dot = field.find('.');
  if (dot == std::string::npos) return {"", field};
  return {field.substr(0, dot), field.substr(dot + 1)};
}

/// "svd.U" as one name of C++.
std::string joined_name(std::string field) {
  std::replace(field.begin(), field.end(), '.', '_');
  return field;
}

class Header {
 public:
  Header(const Scene& scene, const Needs& needs, std::string space)
      : scene_(scene), needs_(needs), namespace_(std::move(space)) {}

  std::string text() && {
    out_.comment("//", "Arrays of the scene " + scene_.name +
                           ", with the fields that its program needs. Written by physgen from " + scene_.include +
                           " and the kernels that it runs: change these, not this file.");
    out_.line("#pragma once");
    out_.line();
    if (has_locals()) out_.line("#include <physgen/arrays/local_array.h>");
    out_.line("#include <physgen/scenes/scene_arrays.h>");
    out_.line();
    std::set<std::string> headers;
    for (const Group& group : scene_.groups)
      for (const Array& array : group.arrays) headers.insert(array.header);
    for (const std::string& name : headers) out_.line("#include <" + name + ">");
    out_.line();
    scene_by_name();
    if (!scene_.doc.empty()) out_.comment("///", scene_.doc);
    out_.line("namespace " + namespace_ + " {");
    out_.line();
    for (const Group& group : scene_.groups) {
      tags(group);
      for (const Array& array : group.arrays) formats(group, array);
      this->group(group);
    }
    out_.line("}  // namespace " + namespace_);
    return std::move(out_).text();
  }

 private:
  /// The scene, whose program may be one over these arrays: its declaration is not included.
  void scene_by_name() {
    const std::string name = "struct " + scene_.name + ";";
    out_.line(scene_.scope.empty() ? name : "namespace " + scene_.scope + " { " + name + " }");
    out_.line();
  }

  // ---- How fields are stored ---------------------------------------------------------------------------------------

  static std::string tag(const Group& group, const Array& array) {
    return "tags::" + group.variable + "::" + array.name;
  }
  /// "svd.U" as one name, which is none that its array's tag has by itself.
  static std::string tag(const Array& array, const Field& field) {
    std::string tag = joined_name(field.name);
    if (tag == array.name || tag == "name") tag += '_';
    return tag;
  }

  /// A type for each array of a group, in which there is one for each field that is not stored.
  void tags(const Group& group) {
    out_.line("namespace tags::" + group.variable + " {");
    for (const Array& array : group.arrays) {
      std::vector<std::string> members = {"static constexpr const char* name = \"" + group.full_name(array) + "\";"};
      for (const FieldNeed* need : pruned(group, array)) members.push_back("struct " + tag(array, need->field) + ";");
      out_.filled("struct " + array.name + " { ", members, " };", "");
    }
    out_.line("}  // namespace tags::" + group.variable);
    out_.line();
  }

  /// The name of what is generated for an object: from the outermost namespace on, since a scene, of this header or of
  /// another, may have the name of the object's namespace.
  [[nodiscard]] static std::string outer_name(const Array& array, const std::string& ending) {
    return "::" + generated_name(array, ending);
  }
  static std::string formats_name(const Group& group, const Array& array) {
    return group.name + capital(array.name) + "Formats";
  }

  [[nodiscard]] std::vector<const FieldNeed*> pruned(const Group& group, const Array& array) const {
    std::vector<const FieldNeed*> fields;
    for (const FieldNeed& need : needs_.of(group.full_name(array)).fields)
      if (!need.kept) fields.push_back(&need);
    return fields;
  }

  void formats(const Group& group, const Array& array) {
    const auto fields = pruned(group, array);
    if (fields.empty()) return;
    std::vector<Leaf> leaves;
    const std::string of_array = tag(group, array);
    for (const FieldNeed* need : fields)
      leaves.push_back({need->field.name, "physgen::format::Pruned<" + scene_.name + ", " + of_array + ", " + of_array +
                                              "::" + tag(array, need->field) + ">"});
    std::string comment = "How " + array.object + " is stored in " + group.full_name(array) + ". Not stored:";
    for (const auto& [names, why] : by_reason(fields)) comment.append("\n- " + names + ": " + why);
    out_.comment("///", comment);
    out_.line("template <class Stored>");
    struct_of(formats_name(group, array), "Stored", leaves);
    out_.line();
  }

  /// Names of fields that are not stored for one reason, and the reason.
  static std::vector<std::pair<std::string, std::string>> by_reason(const std::vector<const FieldNeed*>& fields) {
    std::vector<std::pair<std::string, std::string>> reasons;
    for (const FieldNeed* need : fields) {
      const auto same =
          std::find_if(reasons.begin(), reasons.end(), [&](const auto& reason) { return reason.second == need->why; });
      if (same == reasons.end())
        reasons.emplace_back(need->field.name, need->why);
      else
        same->first += ", " + need->field.name;
    }
    return reasons;
  }

  /// A field by its name in the struct that it is declared in, and its format.
  struct Leaf {
    std::string name, format;
  };

  void struct_of(const std::string& name, const std::string& base, const std::vector<Leaf>& leaves) {
    out_.open("struct " + name + " : " + base + " {");
    std::vector<std::pair<std::string, std::vector<Leaf>>> nested;  // by objects, in order of declaration
    for (const Leaf& leaf : leaves) {
      const auto [object, rest] = split(leaf.name);
      if (object.empty()) {
        out_.wrapped("using " + rest + " = " + leaf.format + ";");
        continue;
      }
      const std::string& outer = object;
      auto known = std::find_if(nested.begin(), nested.end(), [&](const auto& entry) { return entry.first == outer; });
      if (known == nested.end()) known = nested.insert(nested.end(), {object, {}});
      known->second.push_back({rest, leaf.format});
    }
    for (const auto& [object, inner] : nested) {
      struct_of(capital(object) + "Formats", base + "::" + object, inner);
      out_.line("using " + object + " = " + capital(object) + "Formats;");
    }
    out_.close("};");
  }

  [[nodiscard]] bool has_locals() const {
    return std::any_of(needs_.arrays.begin(), needs_.arrays.end(), [](const ArrayNeed& need) { return need.local(); });
  }

  // ---- The arrays of a group ---------------------------------------------------------------------------------------

  [[nodiscard]] std::string type(const Group& group, const Array& array) const {
    std::string type =
        outer_name(array, "Array") + "<" + (scene_.has_own_real(array) ? "Real" : array.real) + ", Space>";
    type = "physgen::StoredArray<Stored, " + tag(group, array) + ", " + type + ">";
    if (!pruned(group, array).empty()) type = "physgen::PrunedArray<" + type + ", " + formats_name(group, array) + ">";
    if (needs_.of(group.full_name(array)).local())
      return "physgen::LocalArray<" + type + ", " + tag(group, array) + ">";
    if (array.uniform) return "physgen::UniformArray<" + type + ">";
    return is_read_only(group, array) ? "physgen::ReadOnlyArray<" + type + ">" : type;
  }

  [[nodiscard]] bool is_read_only(const Group& group, const Array& array) const {
    return array.input && needs_.of(group.full_name(array)).read_only;
  }

  void group(const Group& group) {
    if (!group.doc.empty()) out_.comment("///", group.doc);
    const bool has_real = !scene_.real.empty();
    out_.line("template <class Space_ = physgen::Host, " + (has_real ? "class Real_ = " + scene_.real + ", " : "") +
              "class Stored_ = physgen::StoredAsDeclared>");
    out_.open("struct " + group.name + " {");
    out_.line("using Space = Space_;");
    if (has_real) out_.line("using Real = Real_;");
    out_.line("using Stored = Stored_;");
    out_.line();
    const auto sets = group.sets();
    if (!sets.empty()) {
      out_.line("/// How many objects there are of each kind.");
      out_.open("struct Counts {");
      for (const std::string& set : sets) out_.line("physgen::index_t " + set + " = 0;");
      out_.close("};");
      out_.line();
    }
    for (const Array& array : group.arrays) {
      out_.comment("///", comment(group, array));
      out_.wrapped(type(group, array) + " " + array.name + ";");
    }
    out_.line();
    allocate(group);
    bytes(group);
    out_.close("};");
    out_.line();
  }

  [[nodiscard]] std::string comment(const Group& group, const Array& array) const {
    const ArrayNeed& need = needs_.of(group.full_name(array));
    const std::string per = set_of(array);
    std::string kept, left;
    for (const FieldNeed& field : need.fields)
      (field.kept ? kept : left) += ((field.kept ? kept : left).empty() ? "" : ", ") + field.field.name;
    std::string text = array.object + ", " + per + ": " + (kept.empty() ? "left out, takes stores" : kept);
    if (need.local()) text += "; local to steps that are one, so it holds no memory";
    if (!left.empty() && !kept.empty()) text += "; without " + left;
    return array.doc.empty() ? text : array.doc + "\n" + text;
  }

  void allocate(const Group& group) {
    out_.comment("///",
                 "Makes all arrays anew, of objects with initial values. Where the runtime is checked, fields that the "
                 "program writes before it reads them begin as signalling NaN instead.\n@throw physgen::Error when a "
                 "count is negative or the memory cannot be had");
    std::vector<std::string> statements;
    for (const Array& array : group.arrays) {
      std::string unset;
      for (const std::string& field : fields_without_values(array, needs_.of(group.full_name(array))))
        unset += (unset.empty() ? "\"" : ", \"") + field + "\"";
      statements.push_back("physgen::allocate(" + array.name + ", " + count(array) +
                           (unset.empty() ? "" : ", {" + unset + "}") + ");");
    }
    out_.open(std::string("void allocate(") + (group.sets().empty() ? "" : "const Counts& counts") + ") {");
    for (const std::string& statement : statements) out_.wrapped(statement);
    out_.close("}");
    out_.line();
  }

  static std::string count(const Array& array) {
    return array.set.empty() ? std::to_string(array.count) : "counts." + array.set;
  }

  void bytes(const Group& group) {
    std::vector<std::string> held, counted;
    for (const Array& array : group.arrays) {
      held.push_back(array.name + ".bytes()");
      counted.push_back("physgen::bytes_of_array<decltype(" + array.name + ")>(" + count(array) + ")");
    }
    out_.line("/// Bytes of memory held by all arrays, padding included.");
    sum("[[nodiscard]] physgen::index_t bytes() const {", held);
    if (group.sets().empty()) return;
    out_.line("/// The same of arrays of so many objects, without making them. @pre no count is negative");
    sum("[[nodiscard]] static constexpr physgen::index_t bytes(const Counts& counts) {", counted);
  }

  void sum(const char* signature, const std::vector<std::string>& terms) {
    out_.open(signature);
    out_.list("return ", terms, ";", " +");
    out_.close("}");
  }

  const Scene& scene_;
  const Needs& needs_;
  std::string namespace_;
  emit::Printer out_;
};

}  // namespace

std::string file_of(const Scene& scene, const std::string& ending) { return scene.name + ending; }

std::string header(const Scene& scene, const Needs& needs, const std::string& suffix) {
  return Header(scene, needs, scene.qualified_name() + suffix).text();
}

}  // namespace physgen::scenes
