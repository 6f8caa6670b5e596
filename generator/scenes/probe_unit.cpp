// See probe_unit.h.
#include "scenes/probe_unit.h"

#include "emit/printer.h"

namespace physgen::scenes {

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
  out.comment("///",
              "Arrays whose reads and writes are found; arrays with all fields; and arrays that store nothing. "
              "Code that is not the same over all three depends on how fields are stored.");
  const auto arrays = [&](const char* name, const char* type) {
    out.line("struct " + std::string(name) + " { template <class Array, class Tag> using type = " + type + "; };");
  };
  arrays("Probed", "physgen::ProbeOf<Array, Tag>");
  arrays("AllFields", "Array");
  arrays("StoringNothing", "physgen::ProbeOf<Array, physgen::probe::StoringNothing<Tag>>");
  out.line();
  for (const Group& group : scene.groups) {
    out.line("namespace tags_of_" + group.name + " {");
    for (const Array& array : group.arrays)
      out.line("struct " + array.name + " { static constexpr const char* name = \"" + group.full_name(array) +
               "\"; };");
    out.line("}");
    out.line("template <class Arrays>");
    out.open("struct " + group.name + " {");
    out.line("using Space = physgen_probe_unit::Space;");
    if (!scene.real.empty()) out.line("using Real = " + scene.real + ";");
    for (const Array& array : group.arrays)
      out.line("typename Arrays::template type<" + generated_name(array, "Array") + "<" + array.real +
               ", Space>, tags_of_" + group.name + "::" + array.name + "> " + array.name + ";");
    out.close("};");
    out.line();
  }
  out.comment("///", "Nothing calls it: who compiles this unit for what its probes register links a body.");
  out.line("template <class T>");
  out.line("std::remove_reference_t<T>& some() { std::abort(); }");
  out.line();
  std::string parameters = "physgen::ProbeExecutor<Space>& on", arguments = "on";
  for (const Group& group : scene.groups) {
    parameters += ", " + group.name + "<Arrays>& the_" + group.variable;
    arguments += ", the_" + group.variable;
  }
  for (const std::string& type : scene.parameters) arguments += ", some<" + type + ">()";
  out.line("template <class Arrays>");
  out.open("void instantiate(" + parameters + ") {");
  out.line("::" + scene.qualified_name() + "::program(" + arguments + ");");
  out.close("}");
  std::string types = "physgen::ProbeExecutor<Space>&";
  for (const Group& group : scene.groups) types += ", " + group.name + "<Arrays>&";
  for (const std::string arrays_of : {"Probed", "AllFields", "StoringNothing"}) {
    std::string of = types;
    for (std::size_t at = 0; (at = of.find("<Arrays>", at)) != std::string::npos;)
      of.replace(at, 8, "<" + arrays_of + ">");
    out.line("template void instantiate<" + arrays_of + ">(" + of + ");");
  }
  out.line();
  out.line("}  // namespace physgen_probe_unit");
  return std::move(out).text();
}

}  // namespace physgen::scenes
