// The text that a run prints: on standard output, nothing where it is quiet; warnings on standard error, always.
#pragma once

#include <fem/solver/settings.h>

#include <cstddef>
#include <cstdio>
#include <string>

namespace physgen::truthcube {

class Terminal {
 public:
  /// @param is_first whether this is the rank that prints
  explicit Terminal(bool quiet, bool is_first = true);
  ~Terminal() { clear_bar(); }  // errors are printed behind it
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// A line, formatted as printf does.
  template <class... Arguments>
  void line(const char* format, const Arguments&... arguments) const {
    if (quiet_) return;
    clear_bar();
    std::printf(format, arguments...);
    std::printf("\n");
    std::fflush(stdout);
  }
  void text(const std::string& words) const { line("%s", words.c_str()); }

  /// A line on standard error for a result that a user should not take as it is, also of a quiet run.
  template <class... Arguments>
  void warning(const char* format, const Arguments&... arguments) const {
    error((std::string("truthcube: warning: ") + format).c_str(), arguments...);
  }
  /// A line on standard error, also of a quiet run.
  template <class... Arguments>
  void error(const char* format, const Arguments&... arguments) const {
    if (!is_first_) return;
    clear_bar();
    std::fprintf(stderr, format, arguments...);
    std::fputs("\n", stderr);
  }

  /// A bar in the last line, where a person looks on: which part of the set-up is under way. The next line replaces it.
  void set_up(int part, int parts, const std::string& what) const;

  void newton_header() const { text("  step   residual    PCG          energy  smallest J      time"); }
  /// @param level on which the step was done, from 0, the finest
  void newton_step(std::size_t level, const fem::NewtonStep& step) const;

 private:
  void clear_bar() const;

  bool quiet_, is_first_, watched_;
};

}  // namespace physgen::truthcube
