// Which arrays nothing but some neighbouring steps uses, so that they need no memory where these are one step.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "scenes/needs.h"
#include "scenes/program.h"

namespace physgen::scenes {

/// "ComputeSvd" of "physgen::fem::ComputeSvd(body.gradients, body.svds)".
[[nodiscard]] std::string short_name(const std::string& step);
/// "ComputeSvd, ComputeStress and ComputeForces"
[[nodiscard]] std::string short_names(const std::vector<std::string>& steps);

/// The uses of steps, by the steps' names.
class StepUses {
 public:
  StepUses(const Scene& scene, const usage::Usage& usage);

  /// @return null: there is none of this name, or more than one
  [[nodiscard]] const usage::StepUse* of(const std::string& step) const;
  /// Whether a step that runs over such objects uses the field of others, or may do so.
  [[nodiscard]] bool of_others(const usage::FieldUse& use, const std::string& runs) const;

 private:
  const Scene& scene_;
  std::map<std::string, const usage::StepUse*> steps_;
};

/// An array that steps from number `first` to `last` of a list use, and nothing else does.
struct Local {
  std::string array;
  std::size_t first = 0, last = 0;
};

class LocalArrays {
 public:
  LocalArrays(const Scene& scene, const usage::Usage& usage, const ProgramText& program, const Needs& needs,
              const StepUses& uses)
      : scene_(scene), usage_(usage), program_(program), needs_(needs), uses_(uses) {}

  /// Arrays that are local where steps first .. last are one.
  [[nodiscard]] std::vector<Local> of(const ProgramSteps& list, std::size_t first, std::size_t last) const;
  /// Why no array is local to steps on both sides of step k, of those that they share.
  [[nodiscard]] std::vector<std::string> why_none(const ProgramSteps& list, std::size_t first, std::size_t k,
                                                  std::size_t last) const;

 private:
  struct Range;
  [[nodiscard]] std::string why_not(const Range& range, const std::string& name, const Array& array) const;
  [[nodiscard]] std::string remedy(const Range& range, const std::string& name, const Array& array) const;
  [[nodiscard]] std::string why_not_used_here(const Range& range, const std::string& name) const;
  [[nodiscard]] std::string why_not_stored(const Range& range, const std::string& name) const;

  const Scene& scene_;
  const usage::Usage& usage_;
  const ProgramText& program_;
  const Needs& needs_;
  const StepUses& uses_;
};

/// How many objects an array has, in the words of ProgramStep::runs.
[[nodiscard]] std::string counted(const Group& group, const Array& array);

}  // namespace physgen::scenes
