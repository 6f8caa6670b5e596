// A program over probes of kernels of tools/fem, in the order in which a simulation runs them. Compiled into
// usage_analysis_test, where the compiler registers what it finds, and read by the analysis, for the host and for CUDA.
#include <elasticity.physgen.h>
#include <fem/kernels/compute_svd.h>
#include <fem/kernels/deformation_gradient.h>
#include <fem/kernels/dp_from_df.h>
#include <fem/kernels/elastic_force.h>
#include <fem/kernels/force_differential.h>
#include <fem/kernels/stiffness.h>
#include <fem/kernels/stress.h>
#include <fem/kernels/stress_derivative.h>
#include <fem/materials/neo_hookean.h>
#include <physgen/probe.h>
#ifdef __CUDACC__
#include <fem/solver/product_cuda.h>
#else
#include <fem/solver/product_host.h>
#endif

namespace kernels {

#ifdef __CUDACC__
using Space = physgen::Cuda;
#else
using Space = physgen::Host;
#endif

#define PHYSGEN_TEST_ARRAY(Tag, Type)                    \
  struct Tag##_tag {                                     \
    static constexpr const char* name = "kernels." #Tag; \
  };                                                     \
  physgen::ProbeOf<elasticity::Type##Array<float, Space>, Tag##_tag> Tag

struct Arrays {
  PHYSGEN_TEST_ARRAY(tets, Tet);
  PHYSGEN_TEST_ARRAY(positions, NodePosition);
  PHYSGEN_TEST_ARRAY(rest, RestShape);
  PHYSGEN_TEST_ARRAY(gradients, DeformationGradient);
  PHYSGEN_TEST_ARRAY(svds, DeformationSvd);
  PHYSGEN_TEST_ARRAY(stretches, PrincipalStretches);
  PHYSGEN_TEST_ARRAY(stresses, Stress);
  PHYSGEN_TEST_ARRAY(derivatives, StressDerivative);
  PHYSGEN_TEST_ARRAY(corner_forces, CornerForces);
  PHYSGEN_TEST_ARRAY(forces, NodeForce);
  PHYSGEN_TEST_ARRAY(gradient_changes, DeformationGradientDifferential);
  PHYSGEN_TEST_ARRAY(stress_changes, StressDifferential);
  PHYSGEN_TEST_ARRAY(displacements, NodeDisplacement);
  PHYSGEN_TEST_ARRAY(corner_changes, CornerForces);
  PHYSGEN_TEST_ARRAY(force_changes, NodeForceDifferential);
  PHYSGEN_TEST_ARRAY(tet_stiffness, TetStiffness);
  PHYSGEN_TEST_ARRAY(node_stiffness, NodeStiffness);
  PHYSGEN_TEST_ARRAY(edge_stiffness, EdgeStiffness);
  PHYSGEN_TEST_ARRAY(edges, Edge);
  PHYSGEN_TEST_ARRAY(node_ranges, IncidenceRange);
  PHYSGEN_TEST_ARRAY(node_entries, Incidence);
  PHYSGEN_TEST_ARRAY(product, NodeForceDifferential);
};

template <class On>
void program(On& on, Arrays& a) {
  using namespace physgen;
  using namespace physgen::fem;
  const index_t n = a.tets.size();
  const Rows rows(a.node_ranges.const_view(), a.node_entries.const_view(), n);
  on.run(n, ComputeDeformationGradient{a.tets.const_view(), a.positions.const_view(), a.rest.const_view(),
                                       a.gradients.view()});
  on.run(n, ComputeSvd{a.gradients.const_view(), a.svds.view()});
  on.run(n, ComputeSvdParts{a.gradients.const_view(), skip, a.stretches.view(), skip});
  on.run(n, ComputeStress{NeoHookean<float>(1.0F, 2.0F), a.svds.const_view(), a.stresses.view()});
  on.run(n, ComputeStressDerivative{NeoHookean<float>(1.0F, 2.0F), a.svds.const_view(), a.derivatives.view()});
  on.run(n, DpFromDf{a.svds.const_view(), a.derivatives.const_view(), a.gradient_changes.const_view(),
                     a.stress_changes.view()});
  on.run(n, ComputeCornerForces{a.rest.const_view(), a.stresses.const_view(), a.corner_forces.view()});
  on.run(n, GatherForces{rows, a.corner_forces.const_view(), a.forces.view()});
  on.run(n, ForceDifferential{a.node_stiffness.const_view(), a.edge_stiffness.const_view(), a.edges.const_view(), rows,
                              a.displacements.const_view(), a.force_changes.view()});
  on.run(n, ComputeCornerForceDifferentials{a.tets.const_view(), a.displacements.const_view(), a.rest.const_view(),
                                            a.svds.const_view(), a.derivatives.const_view(), a.corner_changes.view()});
  on.run(n, GatherForceDifferentials{rows, a.corner_changes.const_view(), a.force_changes.view()});
  on.run(n, ComputeTetStiffness{a.rest.const_view(), a.svds.const_view(), a.derivatives.const_view(),
                                a.tet_stiffness.view()});
  const EdgeSums sums;
  multiply(on,
           SymmetricProduct{a.node_stiffness.const_view(), a.edge_stiffness.const_view(), a.edges.const_view(),
                            a.displacements.const_view(), a.product.view()},
           sums);
}

template void program(physgen::ProbeExecutor<Space>& on, Arrays& a);

}  // namespace kernels
