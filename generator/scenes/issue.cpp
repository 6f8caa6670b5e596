// See issue.h.
#include "scenes/issue.h"

namespace physgen::scenes {

std::string name_of(const usage::StepUse& step) {
  const std::string kernel = step.kernel.ends_with("()") ? step.kernel.substr(0, step.kernel.size() - 2) : step.kernel;
  return step.arrays.empty() ? step.kernel : kernel + "(" + model::joined(step.arrays) + ")";
}

}  // namespace physgen::scenes
