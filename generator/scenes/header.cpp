// See header.h.
#include "scenes/header.h"

#include <algorithm>
#include <cctype>

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
    out_.line("#include <physgen/scene_arrays.h>");
    out_.line();
    out_.line("#include \"" + scene_.include + "\"");
    out_.line();
    if (!scene_.doc.empty()) out_.comment("///", scene_.doc);
    out_.line("namespace " + namespace_ + " {");
    out_.line();
    for (const Group& group : scene_.groups) {
      for (const Array& array : group.arrays) formats(group, array);
      this->group(group);
    }
    out_.line("}  // namespace " + namespace_);
    return std::move(out_).text();
  }

 private:
  // ---- How fields are stored ---------------------------------------------------------------------------------------

  static std::string tags(const Group& group, const Array& array) {
    return "pruned::" + group.variable + "::" + array.name;
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
    out_.line("namespace pruned::" + group.variable + " {");
    out_.open("struct " + array.name + " {");
    for (const FieldNeed* need : fields) {
      std::string tag = joined_name(need->field.name);
      if (tag == array.name) tag += '_';  // a class has no member of its own name
      out_.line("struct " + tag + ";");
      leaves.push_back({need->field.name, "physgen::format::Pruned<" + scene_.name + ", " + tags(group, array) + ", " +
                                              tags(group, array) + "::" + tag + ">"});
    }
    out_.close("};");
    out_.line("}  // namespace pruned::" + group.variable);
    out_.line();
    std::string comment = "How " + array.object + " is stored in " + group.full_name(array) + ". Not stored:";
    for (const auto& [names, why] : by_reason(fields)) comment.append("\n- " + names + ": " + why);
    out_.comment("///", comment);
    out_.line("template <class Space>");
    struct_of(formats_name(group, array), "physgen::FormatsOf<" + outer_name(array, "Object") + ", Space>", leaves);
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

  // ---- The arrays of a group ---------------------------------------------------------------------------------------

  [[nodiscard]] std::string type(const Group& group, const Array& array) const {
    std::string type = outer_name(array, "Array") + "<" + array.real + ", Space>";
    if (!pruned(group, array).empty())
      type = "physgen::WithFormats<" + type + ", " + formats_name(group, array) + "<Space>>";
    if (array.uniform) return "physgen::UniformArray<" + type + ">";
    return is_read_only(group, array) ? "physgen::ReadOnlyArray<" + type + ">" : type;
  }

  [[nodiscard]] bool is_read_only(const Group& group, const Array& array) const {
    return array.input && needs_.of(group.full_name(array)).read_only;
  }

  void group(const Group& group) {
    if (!group.doc.empty()) out_.comment("///", group.doc);
    out_.line("template <class Space_ = physgen::Host>");
    out_.open("struct " + group.name + " {");
    out_.line("using Space = Space_;");
    if (!scene_.real.empty()) out_.line("using Real = " + scene_.real + ";");
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
    std::vector<std::string> names;
    for (const Array& array : group.arrays) names.push_back(array.name);
    const std::string bytes = "[[nodiscard]] physgen::index_t bytes() const", sum = "return physgen::bytes_of(";
    out_.line("/// Of memory held by all arrays, padding included.");
    const std::string statement = sum + model::joined(names) + ");";
    if (bytes.size() + statement.size() < emit::Printer::columns - 10) {
      out_.function(bytes, {statement});
    } else {
      out_.open(bytes + " {");
      out_.filled(sum, names, ");");
      out_.close("}");
    }
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
      const std::string count = array.set.empty() ? std::to_string(array.count) : "counts." + array.set;
      std::string unset;
      for (const FieldNeed& field : needs_.of(group.full_name(array)).fields)
        if (field.kept && !array.is_input(field.field.name) && !field.field.initial)
          unset += (unset.empty() ? "\"" : ", \"") + field.field.name + "\"";
      statements.push_back("physgen::allocate(" + array.name + ", " + count +
                           (unset.empty() ? "" : ", {" + unset + "}") + ");");
    }
    out_.open(std::string("void allocate(") + (group.sets().empty() ? "" : "const Counts& counts") + ") {");
    for (const std::string& statement : statements) out_.wrapped(statement);
    out_.close("}");
    out_.line();
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
