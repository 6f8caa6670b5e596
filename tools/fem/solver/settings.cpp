#include <fem/solver/material_names.h>
#include <fem/solver/settings.h>
#include <physgen/error.h>

namespace physgen::fem {

std::vector<ElasticConstants> constants_of(const SolverSettings& settings) {
  if (settings.materials.empty()) return {{settings.youngs_modulus, settings.poissons_ratio}};
  return settings.materials;
}

void add_increment(NewtonResult& total, NewtonResult result) {
  result.steps += total.steps;
  result.iterations += total.iterations;
  result.halvings += total.halvings;
  result.filtered += total.filtered;
  result.returns += total.returns;
  result.coarse_steps += total.coarse_steps;
  result.coarse_iterations += total.coarse_iterations;
  result.bisections = total.bisections;
  total = result;
}

UsedLevels used_levels(const SolverSettings& settings, std::size_t levels, std::size_t meshes) {
  const bool coarser = asks_for(settings.newton.preconditioner.kind, asks::coarser) || settings.nested;
  const std::size_t all = coarser ? levels : 1;
  const auto kept = static_cast<std::size_t>(std::max(settings.coarsest_nested, 0));
  const std::size_t solved = settings.nested && all > kept ? std::min(all - kept, meshes) : 1;
  return {settings.newton.product == Product::assembled ? all : solved, solved};
}

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
  throw Error("the energy of '" + name + "' has no separate volume part that patches or nodes could average; use " +
              list(true) + ", or volume by tets");
}

}  // namespace physgen::fem
