// Stands between this program and the system's calls that change files: one of them can be made to fail as on a full
// disk, or to be the last thing that a process does.
#pragma once

#include <gtest/gtest.h>
#include <physgen/error.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace physgen::truthcube::testing {

enum class At { Nothing, Failure, FailureToGrow, Kill };

/// Lets `number` calls of write(), pwrite(), ftruncate() and rename() through. The next one kills the process;
/// or, from then on, calls that write, or that would make a file longer, fail with ENOSPC. Counts them all anew.
void stop_writes(At what, int number);
/// Whether fallocate() says that the disk is full.
void set_disk_full(bool full);
/// Lets all calls through again.
void resume_writes();

/// Runs a function in a process of its own, in which something happens at call number `number`, counted from 0.
/// @return whether it did: false when the function ended by itself
template <class Run>
bool interrupted(At what, int number, const Run& run) {
  constexpr int done = 0, failed = 1, surprised = 2;
  const pid_t child = ::fork();
  if (child == 0) {
    int code = done;
    stop_writes(what, number);
    try {
      run();
    } catch (const Error&) {
      code = failed;
    } catch (...) {
      code = surprised;
    }
    ::_exit(code);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == done) return false;
  const bool as_told = what == At::Kill ? WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL
                                        : WIFEXITED(status) && WEXITSTATUS(status) == failed;
  EXPECT_TRUE(as_told) << "the process ended with status " << status;
  return as_told;
}

}  // namespace physgen::truthcube::testing
