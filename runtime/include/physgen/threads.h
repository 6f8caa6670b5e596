// The number of threads on which the host's launches run: parallel_for(), parallel_reduce(), copies, gathers.
#pragma once

#include <string>

namespace physgen {

/// The threads that launches on the host use together, at most, the one that launches among them. Threads that have
/// nothing to do sleep, and a launch of less than some 20 us of work runs on its own thread alone; so the number need
/// not be lowered for small arrays or on a machine with other work. Results do not depend on it.
///
/// Where set_threads() has said nothing, it is the first number of the environment's OMP_NUM_THREADS, or else
/// allowed_processors(), of either no more than OMP_THREAD_LIMIT; all three are read once, when they are first needed.
/// In a child of fork(), a process that had launched on several threads before, it is 1.
/// @return at least 1
[[nodiscard]] int threads();

/// Sets that number for the whole process, for all launches that begin later; it precedes the environment's.
/// @param count from 1 to 4096, also more than there are processors; or 0, for what threads() is without this call
/// @throw Error for another number
void set_threads(int count);

/// What a program should tell its user once, when it begins: that threads() is more than allowed_processors(), where
/// threads only wait for each other, or that the environment's words contradict each other or are no numbers.
/// @return a sentence without a full stop; empty where all is well
[[nodiscard]] std::string remark_on_threads();

}  // namespace physgen
