// Looks for the material that solver_catalog.py adds among those of users, and compares all with their plain energies.
#include <fem/materials/materials.h>
#include <fem/reference/energy.h>
#include <fem/solver/settings.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace fem = physgen::fem;

namespace {

int wrong = 0;

template <class Model>
void compare() {
  const auto model = Model::from(1000, 0.3);
  const Eigen::Matrix<double, 3, 1> s(1.2, 0.95, 0.8);
  const auto jet = [&](int k) { return fem::reference::Jet(fem::reference::Quad(s[k])); };
  const fem::reference::Stretches jets{jet(0), jet(1), jet(2)};
  const auto expected = static_cast<double>(fem::reference::energy(model, jets).value);
  const double found = model.energy(s);
  std::printf("%s: %.15g J/m^3\n", Model::name, found);
  if (!(std::abs(found - expected) <= 1e-12 * std::abs(expected)) || !(expected > 0)) ++wrong;
}
template <class... Models>
void compare_all(fem::MaterialList<Models...> /*all*/) {
  (compare<Models>(), ...);
}

}  // namespace

int main() {
  compare_all(fem::AllMaterials<double>());
  const auto& names = fem::material_names();
  if (std::ranges::find(names, "also-corotated") == names.end() || !fem::can_average_volume("also-corotated")) ++wrong;
  std::printf("%d wrong\n", wrong);
  return wrong;
}
