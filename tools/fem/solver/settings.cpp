#include <fem/solver/material_names.h>
#include <physgen/error.h>

namespace physgen::fem {

namespace {

std::string list(bool averages) {
  std::string text;
  for (const std::string& name : material_names()) {
    if (averages && !can_average_volume(name)) continue;
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

}  // namespace

const std::vector<std::string>& material_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for_each_material([&]<class Material>(const char* name) { result.emplace_back(name); });
    return result;
  }();
  return names;
}

bool can_average_volume(const std::string& material) {
  bool found = false, splits = false;
  for_each_material([&]<class Material>(const char* name) {
    if (material != name) return;
    found = true;
    splits = splits_volume<Material>;
  });
  if (!found) refuse_material(material);
  return splits;
}

void refuse_material(const std::string& name) {
  throw Error("there is no material '" + name + "': it is one of " + list(false));
}

void refuse_averages(const std::string& name) {
  throw Error("the energy of '" + name +
              "' has no separate part of the volume, which patches or nodes would average: use " + list(true) +
              ", or volume by tets");
}

}  // namespace physgen::fem
