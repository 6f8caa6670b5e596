// See header.h.
#include "scenes/header.h"

#include <algorithm>
#include <cctype>
#include <map>

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
  Header(const Scene& scene, const Needs& needs) : scene_(scene), needs_(needs) {}

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
    out_.line("namespace " + namespace_of(scene_) + " {");
    out_.line();
    for (const Group& group : scene_.groups) {
      for (const Array& array : group.arrays) formats(group, array);
      this->group(group);
    }
    out_.line("}  // namespace " + namespace_of(scene_));
    return std::move(out_).text();
  }

 private:
  // ---- How fields are stored ---------------------------------------------------------------------------------------

  static std::string tags(const Group& group, const Array& array) {
    return "pruned::" + group.variable + "::" + array.name;
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
    out_.line("namespace pruned::" + group.variable + " {");
    std::string names;
    for (const FieldNeed* need : fields) names += " struct " + joined_name(need->field.name) + ";";
    out_.line("struct " + array.name + " {" + names + " };");
    out_.line("}  // namespace pruned::" + group.variable);
    std::string comment = "How " + array.object + " is stored in " + group.full_name(array) + ". Not stored:";
    for (const FieldNeed* need : fields) comment += "\n- " + need->field.name + ": " + need->why;
    out_.comment("///", comment);
    out_.line("template <class Space>");
    std::map<std::string, std::string> names_of_fields;
    for (const FieldNeed* need : fields) names_of_fields[need->field.name] = joined_name(need->field.name);
    struct_of(formats_name(group, array), "physgen::FormatsOf<" + generated_name(array, "Object") + ", Space>",
              names_of_fields, tags(group, array));
    out_.line();
  }

  /// @param fields their names, and what their tags are called
  void struct_of(const std::string& name, const std::string& base, const std::map<std::string, std::string>& fields,
                 const std::string& tags) {
    out_.open("struct " + name + " : " + base + " {");
    std::map<std::string, std::map<std::string, std::string>> nested;
    for (const auto& [field, tag] : fields) {
      const auto [object, rest] = split(field);
      if (!object.empty())
        nested[object][rest] = tag;
      else
        out_.wrapped("using " + field + " = physgen::format::Pruned<" + scene_.name + ", " + tags + ", " + tags +
                     "::" + tag + ">;");
    }
    for (const auto& [object, inner] : nested) {
      struct_of(capital(object) + "Formats", "" + base + "::" + object, inner, tags);
      out_.line("using " + object + " = " + capital(object) + "Formats;");
    }
    out_.close("};");
  }

  // ---- The arrays of a group ---------------------------------------------------------------------------------------

  [[nodiscard]] std::string type(const Group& group, const Array& array) const {
    std::string type = generated_name(array, "Array") + "<" + array.real + ", Space>";
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
    out_.line("template <class Space = physgen::Host>");
    out_.open("struct " + group.name + " {");
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
    std::string sum;
    for (const Array& array : group.arrays) sum += (sum.empty() ? "" : " + ") + array.name + ".bytes()";
    out_.line("/// Of memory held by all arrays, padding included.");
    out_.function("[[nodiscard]] physgen::index_t bytes() const", {"return " + sum + ";"});
    out_.close("};");
    out_.line();
  }

  [[nodiscard]] std::string comment(const Group& group, const Array& array) const {
    std::vector<std::string> parts;
    if (!array.doc.empty()) parts.push_back(array.doc);
    const ArrayNeed& need = needs_.of(group.full_name(array));
    const std::string per = array.set.empty() ? std::to_string(array.count) : "per " + array.set;
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
      if (array.uniform) {
        statements.push_back(array.name + ".resize(" + count + ");");
        continue;
      }
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
  emit::Printer out_;
};

}  // namespace

std::string file_of(const Scene& scene, const std::string& ending) { return scene.name + ending; }

std::string namespace_of(const Scene& scene) { return scene.qualified_name() + "_scene"; }

std::string header(const Scene& scene, const Needs& needs) { return Header(scene, needs).text(); }

}  // namespace physgen::scenes
