// The scene force_chain on the CPU: see force_chain_case.h.
#include <physgen/executor.h>

#include "force_chain_case.h"

namespace physgen::test::force_chain {
namespace {

/// One object at a time.
struct Singles : HostExecutor {
  template <class Kernel>
  void run(index_t n, const Kernel& kernel) {
    parallel_for(Host{}, n, lanes<1>(kernel));
  }
};

TEST(ForceChain, gives_as_one_step_the_forces_that_its_kernels_give_one_by_one_over_ordinary_arrays) {
  HostExecutor packs;
  expect_the_same_forces<float>(packs);
  expect_the_same_forces<double>(packs);
  Singles singles;
  expect_the_same_forces<float>(singles);
  expect_the_same_forces<double>(singles);
}

TEST(ForceChain, keeps_nothing_of_what_its_tets_kernels_hand_to_each_other) {
  scenes::force_chain_scene::Body<> body;
  body.allocate({.node = nodes, .tet = tets, .corner = 4 * tets});
  EXPECT_EQ(body.gradients.bytes() + body.svds.bytes() + body.stresses.bytes(), 0);
  EXPECT_EQ(body.svds.size(), tets);
  EXPECT_EQ(body.bytes(), body.positions.bytes() + body.tets.bytes() + body.rest.bytes() + body.node_ranges.bytes() +
                              body.node_tets.bytes() + body.corner_forces.bytes() + body.forces.bytes());
  EXPECT_THROW(body.svds.resize(-1), Error);
}

}  // namespace
}  // namespace physgen::test::force_chain
