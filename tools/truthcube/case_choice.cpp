#include "case_choice.h"

#include <physgen/error.h>

#include <algorithm>
#include <initializer_list>

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

}  // namespace

void apply_case(Options& options, const Given& given) {
  refuse(given, {"--cells", "--grading", "--mesh"}, "the file names the mesh of its body");
  refuse(given, {"--material", "--young", "--poisson", "--density"}, "the file says the material");
  refuse(given, {"--compress", "--top", "--plates", "--plate-stiffness", "--plate-tolerance"},
         "its groups hold and load the body, and no plates");
  refuse(given, {"--beads"}, "only the cube has beads: name probes in the file");
  refuse(given, {"--historical", "--repeat", "--restart"}, "it is for runs between plates");
  if (options.scene != SceneKind::everything && options.scene != SceneKind::linear_elastic) {
    throw Error("--case cannot take --scene " + name_of(scene_kinds, options.scene) +
                ", which moves or is for plates; take --scene everything or linear-elastic");
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
  if (read.law.empty()) return;
  if (options.scene == SceneKind::linear_elastic) {
    throw Error("case " + options.case_file.string() + ": material.law: --scene linear-elastic has a law of its own; " +
                "remove the key, or the scene");
  }
  options.solver.material = read.law;
}

}  // namespace physgen::truthcube
