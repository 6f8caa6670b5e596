// cube.vtkhdf of a run: the body or its surface alone, and its states.
#pragma once

#include <optional>

#include "body_state.h"
#include "fields.h"
#include "options.h"
#include "output/vtkhdf.h"
#include "scene.h"

namespace physgen::truthcube {

inline constexpr const char* viewers_name = "cube.vtkhdf";

class ViewersFile {
 public:
  /// Begins the file in options.out anew, or continues it after its first steps. All ranks have one.
  /// @param scene stays alive as long as this @param writes whether this is the rank that writes
  /// @throw Error as VtkHdfWriter
  ViewersFile(const Options& options, const Scene& scene, int steps_done, bool writes);

  /// All ranks call it. @param time as viewers show it
  /// @throw Error as VtkHdfWriter
  void write_step(double time, BodyState& state);

 private:
  std::optional<DrawnFields> fields_;
  std::optional<VtkHdfWriter> file_;  // of the rank that writes
};

}  // namespace physgen::truthcube
