// Which steps of a program are live, and which fields are wanted: the fixpoint of needs.h.
#pragma once

#include <set>
#include <vector>

#include "scenes/issue.h"

namespace physgen::scenes {

struct Liveness {
  std::set<FieldName> wanted;   ///< outputs, and what live steps and code outside of steps read
  std::set<FieldName> written;  ///< by live steps and code outside of steps
  bool complete = true;         ///< all names are the scene's, and all uses are known
  std::vector<Issue> errors;    ///< of steps and of names that the scene has not
};

[[nodiscard]] Liveness find_liveness(const Scene& scene, const usage::Usage& usage);

}  // namespace physgen::scenes
