// The arrays that preconditioners have beside those of levels: LevelOver::extra, and what the host knows of them.
#pragma once

#include <fem/solver/preconditioners/schwarz/schwarz_arrays.h>

namespace physgen::fem {

/// @tparam Group of a scene
template <class Group>
using ExtraOver = SchwarzOver<Group>;
using ExtraFacts = SchwarzFacts;

}  // namespace physgen::fem
