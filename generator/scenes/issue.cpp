// See issue.h.
#include "scenes/issue.h"

namespace physgen::scenes {

std::string name_of(const usage::StepUse& step) {
  const std::string kernel = step.kernel.ends_with("()") ? step.kernel.substr(0, step.kernel.size() - 2) : step.kernel;
  return step.arrays.empty() ? step.kernel : kernel + "(" + model::joined(step.arrays) + ")";
}

std::string listed(const std::vector<std::string>& words) {
  constexpr std::size_t most = 4;
  if (words.size() <= most) return model::joined(words, " and ");
  return model::joined({words.begin(), words.begin() + most}) + " and " + std::to_string(words.size() - most) + " more";
}

}  // namespace physgen::scenes
