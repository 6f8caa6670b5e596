// How many objects the steps of a fused kernel are called with at once.
#pragma once

namespace physgen::detail {

/// How many objects the steps of a fused kernel are called with where it is called with a pack: each with as many as by
/// itself, or all with those that lanes<W>() states.
enum class StepLanes { chosen, stated };

}  // namespace physgen::detail
