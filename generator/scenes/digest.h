// The digest of a scene: what its program needs, in short lines without places in sources, so that a moved line or a
// comment changes nothing of it. It is checked in beside the headers; reports with places are written beside it in
// builds.
#pragma once

#include <string>

#include "scenes/needs.h"

namespace physgen::scenes {

/// One line for each array, for each of its fields, for each step, and for each way in which a step uses fields. Words
/// are separated by single blanks:
///
///     array body.svds of elasticity::DeformationSvd<float> per tet; aosoa 84 of 84 bytes
///       field s float32 3 kept read written
///     step physgen::fem::ComputeStress(body.svds, body.stresses)
///       read own: body.svds.U body.svds.V body.svds.s
///
/// @param usage of the scene's program, from which the needs were found
[[nodiscard]] std::string digest(const Scene& scene, const Needs& needs, const usage::Usage& usage);

}  // namespace physgen::scenes
