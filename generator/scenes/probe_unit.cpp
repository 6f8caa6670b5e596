// See probe_unit.h.
#include "scenes/probe_unit.h"

#include <set>
#include <utility>

#include "emit/printer.h"
#include "scenes/header.h"
#include "scenes/issue.h"

namespace physgen::scenes {
namespace {

/// @param scope of the groups' types; empty: they are those of probes
void instantiation(const Scene& scene, const std::string& name, const std::string& scope, emit::Printer& out) {
  std::string types;
  for (const Group& group : scene.groups)
    types += ", " + (scope.empty() ? group.name : "::" + scope + "::" + group.name + "<Space>") + "&";
  out.line("struct " + name + ";");
  out.line("template void instantiate<" + name + ">(physgen::ProbeExecutor<Space>&" + types + ");");
}

/// What read_records() looks for: the records of all arrays, as the compiler has them.
void records(const Scene& scene, emit::Printer& out) {
  out.line("template <class Array>");
  out.line("struct OneOf { using Type = Array; };");
  out.line("template <class Array>");
  out.line("  requires requires { typename Array::Record; }");
  out.line("struct OneOf<Array> { using Type = typename Array::Record; };");
  out.line("struct Records { const char* layout; int needed, all; };");
  for (const auto& [variable, space] : {std::pair("records_host", "Host"), std::pair("records_cuda", "Cuda")}) {
    std::vector<std::string> rows;
    for (const Group& group : scene.groups)
      for (const Array& array : group.arrays) {
        const auto type = [&](const char* suffix) {
          return "OneOf<decltype(::" + scene.qualified_name() + suffix + "::" + group.name + "<physgen::" + space +
                 ">::" + array.name + ")>::Type::";
        };
        rows.push_back("{" + type("_all") + "Layout::name, " + type("_needed") + "record_bytes, " + type("_all") +
                       "record_bytes}");
      }
    out.list(std::string("inline constexpr Records ") + variable + "[] = {", rows, "};");
  }
}

/// The arrays as text in a unit, which is no file that could be included once.
std::string arrays(const Scene& scene, const Needs& needs, const std::string& suffix) {
  static const std::string once = "#pragma once\n";
  std::string text = header(scene, needs, suffix);
  return text.erase(text.find(once), once.size());
}

/// The fields that are kept, even if something else is wrong with the scene, so that its code can be compared in any
/// case.
Needs kept(const Scene& scene, const usage::Usage& usage) {
  std::set<FieldName> read, written;
  const auto add = [&](const std::vector<usage::FieldUse>& uses) {
    for (const usage::FieldUse& use : uses) {
      if (reads(use)) read.insert(name_of(use));
      if (writes(use)) written.insert(name_of(use));
    }
  };
  for (const auto& step : usage.steps) add(step.fields);
  add(usage.unattributed);
  Needs needs;
  for (const Group& group : scene.groups)
    for (const Array& array : group.arrays) {
      ArrayNeed& need = needs.arrays.emplace_back();
      need.array = group.full_name(array);
      need.read_only = true;
      for (const Field& field : array.fields) {
        const FieldName name{need.array, field.name};
        FieldNeed& of = need.fields.emplace_back();
        of.field = field;
        of.kept = read.contains(name) || array.is_output(field.name);
        need.read_only = need.read_only && !written.contains(name);
      }
    }
  return needs;
}

}  // namespace

std::string probe_unit(const Scene& scene, const std::string& space, const std::string& declaration) {
  emit::Printer out;
  out.comment("//", "The program of the scene " + scene.name + ", instantiated over probes. Written by physgen.");
  out.line("#include <physgen/probe.h>");
  out.line();
  out.line("#include <cstdlib>");
  out.line();
  out.line("#include \"" + declaration + "\"");
  out.line();
  out.line("namespace physgen_probe_unit {");
  out.line();
  out.line("using Space = physgen::" + space + ";");
  out.line();
  for (const Group& group : scene.groups) {
    out.line("namespace tags_of_" + group.name + " {");
    for (const Array& array : group.arrays)
      out.line("struct " + array.name + " { static constexpr const char* name = \"" + group.full_name(array) +
               "\"; };");
    out.line("}");
    out.open("struct " + group.name + " {");
    out.line("using Space = physgen_probe_unit::Space;");
    if (!scene.real.empty()) out.line("using Real = " + scene.real + ";");
    for (const Array& array : group.arrays)
      out.line("physgen::ProbeOf<" + generated_name(array, "Array") + "<" + array.real + ", Space>, tags_of_" +
               group.name + "::" + array.name + "> " + array.name + ";");
    out.close("};");
    out.line();
  }
  out.comment("///", "Nothing calls it: who compiles this unit for what its probes register links a body.");
  out.line("template <class T>");
  out.line("std::remove_reference_t<T>& some() { std::abort(); }");
  out.line();
  std::string parameters = "physgen::ProbeExecutor<Space>& on", arguments = "on", types;
  for (const Group& group : scene.groups) {
    types += ", class Of" + group.name;
    parameters += ", Of" + group.name + "& the_" + group.variable;
    arguments += ", the_" + group.variable;
  }
  for (const std::string& type : scene.parameters) arguments += ", some<" + type + ">()";
  out.line("template <class Arrays" + types + ">");
  out.open("void instantiate(" + parameters + ") {");
  out.line("::" + scene.qualified_name() + "::program(" + arguments + ");");
  out.close("}");
  instantiation(scene, "Probed", "", out);
  out.line();
  out.line("}  // namespace physgen_probe_unit");
  return std::move(out).text();
}

std::string rest_of_unit(const Scene& declared, const usage::Usage& usage) {
  const Needs needs = kept(declared, usage);
  Scene scene = declared;
  for (Group& group : scene.groups)  // what is uniform and written is an error of its own
    for (Array& array : group.arrays) array.uniform = array.uniform && needs.of(group.full_name(array)).read_only;
  emit::Printer out;
  out.line();
  out.line("namespace physgen_probe_unit {");
  instantiation(scene, "AllFields", scene.qualified_name() + "_all", out);
  instantiation(scene, "Needed", scene.qualified_name() + "_needed", out);
  records(scene, out);
  out.line("}  // namespace physgen_probe_unit");
  return arrays(scene, everything(needs), "_all") + arrays(scene, needs, "_needed") + std::move(out).text();
}

}  // namespace physgen::scenes
