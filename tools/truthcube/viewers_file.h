// cube.vtkhdf of a run: the body or its surface alone, and its states.
#pragma once

#include <fem/solver/quasistatic.h>

#include <array>
#include <optional>
#include <vector>

#include "fields.h"
#include "options.h"
#include "output/vtkhdf.h"
#include "scene.h"
#include "surface.h"

namespace physgen::truthcube {

inline constexpr const char* viewers_name = "cube.vtkhdf";

class ViewersFile {
 public:
  /// Begins the file in options.out anew, or continues it after its first steps.
  /// @param scene stays alive as long as this
  /// @throw Error as VtkHdfWriter
  ViewersFile(const Options& options, const Scene& scene, int steps_done);

  /// @param time as viewers show it @param stresses of the solver, per tet [Pa]
  void write_step(double time, const std::vector<fem::Point>& positions,
                  const std::vector<std::array<double, 9>>& stresses);

 private:
  const fem::MeshLevel& level_;
  const fem::Renumbering& numbers_;  // the file has the mesh's own
  Strain strain_;
  std::optional<Surface> surface_;  // under the mesh's own numbers
  std::optional<VtkHdfWriter> file_;
};

}  // namespace physgen::truthcube
