// Which neighbouring steps of a program become one fused step. Joining them must change no bit, so it asks of them that
//
//   - they stand one behind the other in the program's own text, with nothing but declarations between them
//   - they run over the same objects, in packs of the same width
//   - what one of them stores, the others use at their own index alone
//
// and it must save something: an array between them that nothing else uses becomes local, which holds no memory. All
// that is read of it has been stored before by a step of the group, whole and on every path.
#pragma once

#include "scenes/needs.h"
#include "scenes/program.h"

namespace physgen::scenes {

/// Finds the groups, and says which arrays are local to them: fills needs.groups, needs.apart and ArrayNeed::group.
/// @pre needs are sound, of this scene and this usage
void join_steps(const Scene& scene, const usage::Usage& usage, const ProgramText& program, Needs& needs);

}  // namespace physgen::scenes
