// Ctrl-C, as an end of a run and not of the process.
#pragma once

#include <csignal>

namespace physgen::truthcube {

inline volatile std::sig_atomic_t interrupted = 0;

/// While it lives, the first Ctrl-C ends the run after the step under way, and the second at once.
class Interrupts {
 public:
  Interrupts() {
    interrupted = 0;
    struct sigaction action = {};
    action.sa_handler = [](int) { interrupted = 1; };
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);  // writing goes on
    ::sigaction(SIGINT, &action, &old_);
  }
  ~Interrupts() { ::sigaction(SIGINT, &old_, nullptr); }
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;

 private:
  struct sigaction old_ = {};
};

}  // namespace physgen::truthcube
