// All preconditioners, by the kind that settings choose at run time. Programs over an executor, so that they run on the
// CPU and on CUDA alike.
#pragma once

#include <fem/solver/preconditioners/jacobi/preconditioner.h>
#include <fem/solver/preconditioners/multigrid/preconditioner.h>
#include <fem/solver/preconditioners/none/preconditioner.h>
#include <fem/solver/preconditioners/schwarz/preconditioner.h>

namespace physgen::fem {

#define PHYSGEN_REQUIRE_OF_ROW(kind, Type, Concept, what)                                             \
  static_assert(Concept<Type>, "the row " #kind " of PHYSGEN_PRECONDITIONERS: " #Type " has no " what \
                               ", as levels/preconditioner.h says");
#define PHYSGEN_CHECK_ROW(kind, Type, ...)                                                        \
  PHYSGEN_REQUIRE_OF_ROW(kind, Type, MakesArrays, "make_arrays(level, graph, rest)")              \
  PHYSGEN_REQUIRE_OF_ROW(kind, Type, ForecastsBytes, "bytes<Extra>(nodes, edges)")                \
  PHYSGEN_REQUIRE_OF_ROW(kind, Type, PreparesLevels, "prepare(on, levels, top, settings, fresh)") \
  PHYSGEN_REQUIRE_OF_ROW(kind, Type, AppliesToLevels, "apply(on, levels, top, settings)")
PHYSGEN_PRECONDITIONERS(PHYSGEN_CHECK_ROW)
#undef PHYSGEN_CHECK_ROW
#undef PHYSGEN_REQUIRE_OF_ROW

/// Calls body.operator()<Type>() of a kind's type.
template <class Body>
auto with_preconditioner(Preconditioner kind, const Body& body) {
#define PHYSGEN_CALL_ROW(kind, Type, ...) \
  case Preconditioner::kind:              \
    return body.template operator()<Type>();
  switch (kind) { PHYSGEN_PRECONDITIONERS(PHYSGEN_CALL_ROW) }
#undef PHYSGEN_CALL_ROW
  return body.template operator()<NoPreconditioner>();
}

/// Everything that depends on the stiffness of level `top`, which is given. @param levels finest first
template <class On, class Levels>
void prepare(On& on, Levels& levels, std::size_t top, const PreconditionerSettings& settings, bool fresh) {
  with_preconditioner(settings.kind, [&]<class Type>() { Type::prepare(on, levels, top, settings, fresh); });
}

/// z = M r of level `top`, both scaled. r is used up.
template <class On, class Levels>
void precondition(On& on, Levels& levels, std::size_t top, const PreconditionerSettings& settings) {
  with_preconditioner(settings.kind, [&]<class Type>() { Type::apply(on, levels, top, settings); });
}

}  // namespace physgen::fem
