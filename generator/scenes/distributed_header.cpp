// The header with the arrays of a scene for several ranks. See distribution.h.
#include "emit/printer.h"
#include "scenes/distribution.h"
#include "scenes/header.h"

namespace physgen::scenes {
namespace {

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

class DistributedHeader {
 public:
  DistributedHeader(const Scene& scene, const Needs& needs, const Distribution& of)
      : scene_(scene), needs_(needs), of_(of), is_one_(scene.groups.size() == 1) {}

  std::string text() && {
    out_.comment("//", "Arrays of the scene " + scene_.name + " for several ranks. Written by physgen from " +
                           scene_.include + " and the kernels that it runs: change these, not this file.");
    out_.line("#pragma once");
    out_.line();
    out_.line("#include <physgen/distributed/distributed_scene.h>");
    out_.line();
    out_.line("#include <utility>");
    out_.line();
    for (const char* ending : {".halos.h", ".program.h"}) out_.line("#include \"" + file_of(scene_, ending) + "\"");
    out_.line();
    out_.line("namespace " + scene_.qualified_name() + "_scene {");
    out_.line();
    struct_of_arrays();
    program();
    out_.line("}  // namespace " + scene_.qualified_name() + "_scene");
    return std::move(out_).text();
  }

 private:
  [[nodiscard]] std::string parameters(const char* of_space, const char* of_real, const char* of_stored) const {
    return std::string(of_space) + ", " + (scene_.real.empty() ? "" : std::string(of_real) + ", ") + of_stored;
  }
  /// "this->edges" or "this->body.edges"
  [[nodiscard]] std::string member(const Group& group, const Array& array) const {
    return "this->" + (is_one_ ? "" : group.variable + ".") + array.name;
  }
  [[nodiscard]] std::string member(const std::string& full_name) const {
    return "this->" + (is_one_ ? full_name.substr(full_name.find('.') + 1) : full_name);
  }

  void struct_of_arrays() {
    const std::string of = parameters("Space_", "Real_", "Stored_");
    out_.comment("///", is_one_ ? "The arrays of this rank, and what crosses to others: " + scene_.groups.front().name +
                                      ", with the functions of physgen::DistributedScene."
                                : "The arrays of this rank, and what crosses to others: the scene's groups, with the "
                                  "functions of physgen::DistributedScene.");
    out_.line("template <" +
              parameters("class Space_ = physgen::Host", ("class Real_ = " + scene_.real).c_str(),
                         "class Stored_ = physgen::StoredAsDeclared") +
              ">");
    out_.line("  requires physgen::SpaceOfRanks<Space_>");
    out_.open("struct Distributed : " + (is_one_ ? scene_.groups.front().name + "<" + of + ">, " : "") +
              "physgen::DistributedScene {");
    if (!is_one_) {
      for (const Group& group : scene_.groups) out_.line(group.name + "<" + of + "> " + group.variable + ";");
      out_.line();
    }
    counts();
    constructor();
    if (is_one_) out_.line("void allocate() = delete;  // cut() gives the arrays their objects");
    out_.close("};");
    out_.line();
  }

  void counts() {
    out_.line("/// How many objects all ranks together have of each kind.");
    out_.open("struct Counts {");
    for (const Distribution::Set& set : of_.sets) {
      if (set.has_entries) out_.line("/// Of entries; if given, it is compared with the rows.");
      out_.line("physgen::index_t " + set.name + " = not_given;");
    }
    out_.close("};");
    out_.line();
  }

  void constructor() {
    out_.line("/// @throw physgen::Error when a number of objects is not given or is negative");
    out_.open("Distributed(const physgen::Ranks& ranks, const Counts& counts) : DistributedScene(ranks, halos) {");
    for (const Distribution::Set& set : of_.sets)
      if (!set.has_entries) out_.line("scene_.add_set(" + quoted(set.name) + ", counts." + set.name + ");");
    for (const Distribution::Set& set : of_.sets)
      if (!set.follows.empty()) out_.line("scene_.follow(" + quoted(set.name) + ", " + quoted(set.follows) + ");");
    for (const Group& group : scene_.groups)
      for (const Array& array : group.arrays) add(group, array);
    for (const Distribution::IndexField& one : of_.names)
      out_.wrapped("scene_.names(" + member(one.array) + ", " + quoted(one.field) + ", " + quoted(one.set) + ");");
    for (const Distribution::Rows& rows : of_.rows)
      out_.wrapped("scene_.rows(" + member(rows.ranges) + ", " + quoted(rows.entries) + ", " + member(rows.entries) +
                   ", " + quoted(rows.field) + ", " + quoted(rows.set) + ", " + std::to_string(rows.shift) +
                   ", counts." + find(scene_, rows.entries)->set + ");");
    out_.close("}");
  }

  void add(const Group& group, const Array& array) {
    const std::string name = group.full_name(array);
    for (const Distribution::Rows& rows : of_.rows)
      if (rows.entries == name) return;
    std::string fields;
    for (const std::string& field : fields_without_values(array, needs_.of(name)))
      fields += (fields.empty() ? "" : ", ") + quoted(field);
    out_.wrapped("scene_.add_array(" + quoted(name) + ", " +
                 (array.set.empty() ? "scene_.set_of_all(" + std::to_string(array.count) + ")" : quoted(array.set)) +
                 ", " + member(group, array) + (fields.empty() ? "" : ", {" + fields + "}") + ");");
  }

  void program() {
    out_.line("/// The scene's program over them; `on` is a DistributedExecutor of theirs.");
    out_.line("template <class On, " + parameters("class Space", "class Real", "class Stored") +
              ", class... Parameters>");
    out_.open("void program(On& on, Distributed<" + parameters("Space", "Real", "Stored") +
              ">& all, Parameters&&... parameters) {");
    std::string groups;
    if (is_one_)
      groups = ", static_cast<" + scene_.groups.front().name + "<" + parameters("Space", "Real", "Stored") + ">&>(all)";
    else
      for (const Group& group : scene_.groups) groups += ", all." + group.variable;
    out_.wrapped("fused::program(on" + groups + ", std::forward<Parameters>(parameters)...);");
    out_.close("}");
    out_.line();
  }

  const Scene& scene_;
  const Needs& needs_;
  const Distribution& of_;
  bool is_one_;
  emit::Printer out_;
};

}  // namespace

std::string distributed_header(const Scene& scene, const Needs& needs, const Distribution& distribution) {
  return DistributedHeader(scene, needs, distribution).text();
}

}  // namespace physgen::scenes
