// The header with the table of halos. See halos.h.
#include <array>

#include "scenes/halos.h"

namespace physgen::scenes {
namespace {

/// "{.reads_own = true, .writes_own = true}"
std::string access(const HaloRow& row) {
  const std::array<std::pair<const char*, bool>, 4> flags = {{{".reads_own", row.reads_own},
                                                              {".reads_others", row.reads_others},
                                                              {".writes_own", row.writes_own},
                                                              {".writes_others", row.writes_others}}};
  std::string text;
  for (const auto& [name, holds] : flags)
    if (holds) text += (text.empty() ? "" : ", ") + std::string(name) + " = true";
  return "{" + text + "}";
}

}  // namespace

std::string halos_header(const Scene& scene, const Halos& halos) {
  std::string text = "// What each kernel of the scene " + scene.qualified_name() +
                     " uses of its own objects and of others. Written by physgen from\n// " + scene.include +
                     ": change that, not this file.\n#pragma once\n\n#include <physgen/distributed/halo_uses.h>\n\n"
                     "namespace " +
                     scene.qualified_name() + "_scene {\n\n";
  const std::string end = "}  // namespace " + scene.qualified_name() + "_scene\n";
  if (halos.table.empty()) return text + "inline constexpr ::physgen::HaloUses halos;\n\n" + end;
  text += "inline constexpr ::physgen::HaloUse halos[] = {\n";
  for (const HaloRow& row : halos.table) {
    text += "    {\"" + row.kernel + "\", " + std::to_string(row.view) + ", \"" + row.field + "\", " + access(row);
    if (!row.through.empty()) text += ", \"" + model::joined(row.through) + "\"";
    text += "},\n";
  }
  return text + "};\n\n" + end;
}

}  // namespace physgen::scenes
