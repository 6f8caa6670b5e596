// What a state of a case comes to, of its solver's positions and forces.
#pragma once

#include <fem/mesh/locate.h>
#include <fem/solver/quasistatic.h>

#include <optional>
#include <string>
#include <vector>

#include "case_file.h"
#include "output/case_state.h"
#include "scene.h"

namespace physgen::truthcube {

/// @throw Error naming the probe that lies outside of the body
[[nodiscard]] std::vector<fem::Location> locate_probes(const std::vector<Probe>& probes, const fem::MeshLevel& level);

/// Of a loading at its factor of 1: forces, and those of pressures that follow the surface, there [N].
[[nodiscard]] std::vector<fem::Point> external_forces(const fem::Loading& loading,
                                                      const std::vector<fem::Point>& positions);

/// Of each support of a case, the direction of its axis; none where it has no axis.
[[nodiscard]] std::vector<std::optional<fem::Point>> axes_of(const Scene& scene, const Case& given);

/// @param axes of the supports @param forces of the solver
[[nodiscard]] CaseState case_state_of(const Scene& scene, const Case& given,
                                      const std::vector<fem::Location>& locations,
                                      const std::vector<std::optional<fem::Point>>& axes, double load,
                                      const std::vector<fem::Point>& positions, const std::vector<fem::Point>& forces);

/// Lines for the terminal: the largest displacement, the reactions of supports, and the probes.
[[nodiscard]] std::vector<std::string> describe(const CaseState& state, const fem::LoadCase& load_case);

}  // namespace physgen::truthcube
