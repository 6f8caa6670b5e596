#include "terminal.h"

#include <unistd.h>

#include <cstdlib>

namespace physgen::truthcube {

namespace {

/// Whether a person looks on. mpirun gives what it starts a terminal, whoever reads what it prints.
bool is_watched() { return ::isatty(STDOUT_FILENO) == 1 && std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr; }

}  // namespace

Terminal::Terminal(bool quiet, bool is_first)
    : quiet_(quiet || !is_first), is_first_(is_first), watched_(!quiet_ && is_watched()) {}

void Terminal::clear_bar() const {
  if (!watched_) return;
  std::printf("\r\033[K");
  std::fflush(stdout);
}

void Terminal::set_up(int part, int parts, const std::string& what) const {
  if (!watched_) return;
  const std::string done(static_cast<std::size_t>(4 * (part - 1)), '#');
  const std::string left(static_cast<std::size_t>(4 * (parts - part + 1)), '.');
  clear_bar();
  std::printf("[%s%s] set-up, %d of %d: %s", done.c_str(), left.c_str(), part, parts, what.c_str());
  std::fflush(stdout);
}

void Terminal::newton_step(std::size_t level, const fem::NewtonStep& s) const {
  const std::string where = level == 0 ? "" : "  coarser by " + std::to_string(level);
  line("  %4d  %9.2e  %5d  %14.8e  %8.4f  %8.3f s%s%s%s", s.number, s.residual, s.iterations, s.energy, s.smallest_J,
       s.seconds, s.halvings > 0 ? "  shortened" : "", s.filtered ? "  filtered" : "", where.c_str());
}

}  // namespace physgen::truthcube
