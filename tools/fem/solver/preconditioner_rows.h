// The catalogue of preconditioners. Settings, the solvers, the forecast of bytes and the command line read its rows: a
// new one is a folder in preconditioners/, its #include in preconditioners/all.h, and a row here.
#pragma once

#include <string>

namespace physgen::fem {

/// What a preconditioner asks of the levels of a solver, beside blocks of nodes.
namespace asks {
inline constexpr unsigned nothing = 0;
inline constexpr unsigned inverses = 1;  ///< inverses of the nodes' blocks, in matrix-free products, too
inline constexpr unsigned edges = 2;     ///< blocks of edges, which matrix-free products do without
inline constexpr unsigned coarser = 4;   ///< levels behind the first
inline constexpr unsigned arrays = 8;    ///< arrays of its own, which few scenes have
}  // namespace asks

/// A row: its enumerator, its type, its folder, the name by which users choose it, how messages call it, and what it
/// asks for. CMake reads these lines, too (physgen_read_rows).
#define PHYSGEN_PRECONDITIONERS(ROW, ...)                                                                 \
  ROW(multigrid, Multigrid, multigrid, "multigrid", "multigrid", inverses | edges | coarser, __VA_ARGS__) \
  ROW(schwarz, Schwarz, schwarz, "schwarz", "Schwarz", inverses | edges | arrays, __VA_ARGS__)            \
  ROW(block_jacobi, BlockJacobi, jacobi, "block-jacobi", "block Jacobi", inverses, __VA_ARGS__)           \
  ROW(none, NoPreconditioner, none, "none", "no", nothing, __VA_ARGS__)

#define PHYSGEN_PRECONDITIONER_KIND(kind, ...) kind,
enum class Preconditioner { PHYSGEN_PRECONDITIONERS(PHYSGEN_PRECONDITIONER_KIND) };
#undef PHYSGEN_PRECONDITIONER_KIND

/// A row as plain values.
struct PreconditionerRow {
  Preconditioner kind;
  const char *name, *title;
  unsigned asked;
};
#define PHYSGEN_PRECONDITIONER_ROW(kind, Type, folder, name, title, asked, ...) \
  PreconditionerRow{Preconditioner::kind, name, title, [] {                     \
                      using namespace asks;                                     \
                      return asked;                                             \
                    }()},
inline constexpr PreconditionerRow preconditioner_rows[] = {PHYSGEN_PRECONDITIONERS(PHYSGEN_PRECONDITIONER_ROW)};
#undef PHYSGEN_PRECONDITIONER_ROW

[[nodiscard]] constexpr const PreconditionerRow& row_of(Preconditioner kind) {
  return preconditioner_rows[static_cast<int>(kind)];
}
/// "a, b", the names of those that do not ask for it. @param what one of `asks`
[[nodiscard]] inline std::string preconditioners_without(unsigned what) {
  std::string names, last;
  for (const PreconditionerRow& row : preconditioner_rows) {
    if ((row.asked & what) != 0) continue;
    names += (names.empty() || last.empty() ? "" : ", ") + last;
    last = row.name;
  }
  return names.empty() ? last : names + " or " + last;
}
/// @param what one of `asks`
[[nodiscard]] constexpr bool asks_for(Preconditioner kind, unsigned what) { return (row_of(kind).asked & what) != 0; }

}  // namespace physgen::fem
