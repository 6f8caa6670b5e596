// How a run ends.
#pragma once

namespace physgen::truthcube {

/// Ends of a run, as exit statuses.
enum class Outcome { done = 0, not_converged = 3, interrupted = 130 };

}  // namespace physgen::truthcube
