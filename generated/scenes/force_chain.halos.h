// What each kernel of the scene scenes::force_chain uses of its own objects and of others. Written by physgen from
// scenes/force_chain.h: change that, not this file.
#pragma once

#include <physgen/distributed/halo_uses.h>

namespace scenes::force_chain_scene {

inline constexpr ::physgen::HaloUse halos[] = {
    {"physgen::fem::ComputeCornerForces", 0, "dm_inverse", {.reads_own = true}},
    {"physgen::fem::ComputeCornerForces", 0, "volume", {.reads_own = true}},
    {"physgen::fem::ComputeCornerForces", 1, "P", {.reads_own = true}},
    {"physgen::fem::ComputeCornerForces", 2, "G", {.writes_own = true}},
    {"physgen::fem::ComputeDeformationGradient", 0, "nodes", {.reads_own = true}},
    {"physgen::fem::ComputeDeformationGradient", 1, "x", {.reads_others = true}, "body.tets.nodes"},
    {"physgen::fem::ComputeDeformationGradient", 2, "dm_inverse", {.reads_own = true}},
    {"physgen::fem::ComputeDeformationGradient", 3, "F", {.writes_own = true}},
    {"physgen::fem::ComputeStress", 0, "U", {.reads_own = true}},
    {"physgen::fem::ComputeStress", 0, "V", {.reads_own = true}},
    {"physgen::fem::ComputeStress", 0, "s", {.reads_own = true}},
    {"physgen::fem::ComputeStress", 1, "P", {.writes_own = true}},
    {"physgen::fem::ComputeSvd", 0, "F", {.reads_own = true}},
    {"physgen::fem::ComputeSvd", 1, "U", {.writes_own = true}},
    {"physgen::fem::ComputeSvd", 1, "V", {.writes_own = true}},
    {"physgen::fem::ComputeSvd", 1, "s", {.writes_own = true}},
    {"physgen::fem::GatherForces", 0, "begin", {.reads_own = true}},
    {"physgen::fem::GatherForces", 0, "end", {.reads_own = true}},
    {"physgen::fem::GatherForces", 1, "element", {.reads_others = true}, "body.node_ranges.begin, body.node_ranges.end"},
    {"physgen::fem::GatherForces", 1, "local", {.reads_others = true}, "body.node_ranges.begin, body.node_ranges.end"},
    {"physgen::fem::GatherForces", 2, "G", {.reads_others = true}, "body.node_tets.element"},
    {"physgen::fem::GatherForces", 3, "f", {.writes_own = true}},
};

}  // namespace scenes::force_chain_scene
