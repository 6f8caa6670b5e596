#include "case_choice.h"

#include <physgen/error.h>

#include <algorithm>
#include <initializer_list>

#include "arrays.h"
#include "choices.h"
#include "scene_choice.h"

namespace physgen::truthcube {

namespace {

using Given = std::function<bool(const std::string&)>;

void refuse(const Given& given, std::initializer_list<const char*> flags, const std::string& reason) {
  for (const char* flag : flags) {
    if (given(flag))
      throw Error(std::string("--case cannot take ") + flag + ", because " + reason + "; remove " + flag);
  }
}

/// As the file says.
void choose_output(Options& options, const Given& given) {
  const std::string& wanted = options.given_case.output;
  const auto found = std::ranges::find(outputs, wanted, &std::pair<std::string, Output>::first);
  if (found == outputs.end()) {
    throw Error("case " + options.case_file.string() + ": output: " + unknown("output", wanted, words_of(outputs)) +
                " There are " + joined(words_of(outputs)));
  }
  if (given("--output") && options.output != found->second) {
    throw Error("--output " + name_of(outputs, options.output) + ": the case " + options.case_file.string() +
                " says \"output\": \"" + wanted + "\"; remove one of them");
  }
  options.output = found->second;
}

/// @throw Error when the case has what the arrays of a scene of its own have not
void require_arrays_for(const Options& options) {
  const fem::SceneRow* const row = equilibrium_row(options.scene);
  if (row == nullptr) return;
  const Case& read = options.given_case;
  const auto refuse = [&](const std::string& place, const std::string& what) {
    throw Error("case " + options.case_file.string() + ": " + place + ": --scene " +
                name_of(scene_kinds, options.scene) + " " + what + "; take --scene everything");
  };
  if (!read.law.empty() && read.law != row->material) {
    refuse("material.law", "has no " + read.law + ", but " + row->material);
  }
  if (!read.of_groups.empty()) refuse("material.groups", "has one material");
  if (std::ranges::any_of(read.load_case.pressures, &fem::GroupPressure::follows)) {
    refuse("loads", "has no pressures that follow the surface");
  }
}

}  // namespace

void apply_case(Options& options, const Given& given) {
  refuse(given, {"--cells", "--grading", "--mesh"}, "the file names the mesh of its body");
  refuse(given, {"--material", "--young", "--poisson", "--density"}, "the file says the material");
  refuse(given, {"--compress", "--top", "--plates", "--plate-stiffness", "--plate-tolerance"},
         "its groups hold and load the body, and no plates");
  refuse(given, {"--beads"}, "only the cube has beads: name probes in the file");
  refuse(given, {"--historical", "--repeat", "--restart"}, "it is for runs between plates");
  if (options.moves()) {
    throw Error("--case cannot take --scene " + name_of(scene_kinds, options.scene) +
                ", which moves; take --scene everything, linear-elastic or quasistatic");
  }
  Case& read = options.given_case;
  read = read_case(options.case_file);
  options.mesh = read.mesh;
  options.solver.youngs_modulus = read.young;
  options.solver.poissons_ratio = read.poisson;
  if (!read.of_groups.empty()) {
    options.solver.materials = {{read.young, read.poisson}};
    options.solver.materials.insert(options.solver.materials.end(), read.of_groups.begin(), read.of_groups.end());
  }
  if (!read.output.empty()) choose_output(options, given);
  require_arrays_for(options);
  if (read.law.empty()) return;
  if (options.scene == SceneKind::linear_elastic) {
    throw Error("case " + options.case_file.string() + ": material.law: --scene linear-elastic has a law of its own; " +
                "remove the key, or the scene");
  }
  options.solver.material = read.law;
}

}  // namespace physgen::truthcube
