// The kernels of tools/fem over probes. Compiled into usage_analysis_test, where the compiler registers what it finds,
// and read by the analysis, for the host and for CUDA.
#include "kernels/probe_kernels.h"

#ifdef __CUDACC__
#include <fem/solver/linear/product_cuda.h>
#else
#include <fem/solver/linear/product_host.h>
#endif

namespace kernels {

using namespace physgen;

#ifdef __CUDACC__
using Space = Cuda;
#else
using Space = Host;
#endif

#define PHYSGEN_TEST_ARRAY(Tag, Type)                    \
  struct Tag##_tag {                                     \
    static constexpr const char* name = "product." #Tag; \
  };                                                     \
  ProbeOf<elasticity::Type##Array<float, Space>, Tag##_tag> Tag

struct Arrays {
  PHYSGEN_TEST_ARRAY(nodes, NodeStiffness);
  PHYSGEN_TEST_ARRAY(blocks, EdgeStiffness);
  PHYSGEN_TEST_ARRAY(edges, Edge);
  PHYSGEN_TEST_ARRAY(x, NodeDisplacement);
  PHYSGEN_TEST_ARRAY(y, NodeForceDifferential);
};

/// A step of a program's own: on CUDA, code that only a compiler for devices reads.
template <class On>
void multiply(On& on, Arrays& a, const fem::EdgeSums& sums) {
  fem::multiply(on,
                fem::SymmetricProduct{a.nodes.const_view(), a.blocks.const_view(), a.edges.const_view(),
                                      a.x.const_view(), a.y.view()},
                sums);
}

template void multiply(ProbeExecutor<Space>& on, Arrays& a, const fem::EdgeSums& sums);

}  // namespace kernels

template void physgen::fem::test::run_all_kernels(physgen::ProbeExecutor<kernels::Space>& on);
