// The fields that the solver on the CPU reads and writes.
#include "probe_solver.h"

#include <fem/solver/linear/performed_steps.h>

namespace physgen::fem::test {
namespace {

class ProbesOfTheSolver : public testing::Test {
 protected:
  ProbesOfTheSolver() {
    ProbeExecutor<Host> on;
    solver_program<ProbeExecutor<Host>, float, StoredInHalf>(on);
  }
};

// By hand: what EquilibriumOver, LevelOver and their parts are given when they are made.
TEST_F(ProbesOfTheSolver, read_without_writing_what_the_solver_is_given_and_nothing_else) {
  const std::set<std::string> given{"body.tets.nodes",
                                    "body.rest.x",
                                    "body.loads.f",
                                    "body.motion.dx",
                                    "inertia.masses.mass",

                                    "level.constraints.fixed",
                                    "level.edges.nodes",
                                    "level.parents.nodes",
                                    "level.grid_parents.nodes",
                                    "level.grid_parents.weights",
                                    "patches.nodes.nodes",
                                    "patches.tet_patches.patch",
                                    "planes.areas.area",
                                    "planes.planes.normal",
                                    "planes.planes.offset",
                                    "planes.planes.travel",
                                    "schwarz.nodes.slot",
                                    "schwarz.slots.source",
                                    "schwarz.slots.parent",
                                    "surface.faces.nodes",
                                    "surface.faces.pressure"};
  EXPECT_EQ(fields_read_only(), given);
}

TEST_F(ProbesOfTheSolver, find_nothing_that_is_written_and_never_read) {
  for (const probe::FieldAccess& row : probe::registered()) EXPECT_TRUE(row.read) << row.array << "." << row.field;
  EXPECT_GE(probe::registered().size(), 135U) << "else a part of the solver is not looked at";
}

// The chain of Schwarz blocks is followed on CUDA alone; SVDs and stresses are no arrays of this solver.
TEST_F(ProbesOfTheSolver, leave_out_what_only_other_programs_read) {
  std::set<std::string> of_blocks;
  for (const probe::FieldAccess& row : probe::registered()) {
    if (row.array == "schwarz.blocks") of_blocks.insert(row.field);
  }
  EXPECT_EQ(of_blocks, std::set<std::string>{"scale"});
  EXPECT_EQ(probe::unseen(), std::vector<std::string>());
}

}  // namespace
}  // namespace physgen::fem::test
