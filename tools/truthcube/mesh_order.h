// The order of a user's mesh that --order asks for.
#pragma once

#include "options.h"
#include "scene.h"

namespace physgen::truthcube {

/// @throw Error when a cube is to be ordered, or this build has no METIS
void check_order(const Options& options, bool is_given);

/// Gives the mesh the new numbers that options.order asks for; of a run that goes on, those in its folder. All levels,
/// patches and groups follow.
/// @throw Error as order_by_parts() and read_order()
void bring_into_order(GivenMesh& given, const Options& options);

}  // namespace physgen::truthcube
