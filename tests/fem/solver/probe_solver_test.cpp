// What the solver on the CPU reads and writes.
#include "probe_solver.h"

#include <fem/solver/product_host.h>
#include <fem/solver/schwarz_host.h>

namespace physgen::fem::test {
namespace {

TEST(ProbesOfTheSolver, go_through_all_of_it) {
  ProbeExecutor<Host> on;
  newton_program<ProbeExecutor<Host>, float, StoredInHalf>(on);
  for (const auto& r : probe::registered())
    printf("%s.%s %s%s%s\n", r.array.c_str(), r.field.c_str(), r.read ? "R" : "", r.written ? "W" : "",
           r.address_taken ? "&" : "");
}

}  // namespace
}  // namespace physgen::fem::test
