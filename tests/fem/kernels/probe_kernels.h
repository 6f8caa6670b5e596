// Each kernel of tools/fem under probes, and by hand, from the kernels' comments, what it reads and writes. For host
// and CUDA translation units.
#pragma once

#include <elasticity.physgen.h>
#include <fem/kernels/compute_svd.h>
#include <fem/kernels/deformation_gradient.h>
#include <fem/kernels/elastic_force.h>
#include <fem/kernels/force_differential.h>
#include <fem/kernels/stiffness.h>
#include <fem/kernels/stress.h>
#include <fem/kernels/stress_derivative.h>
#include <fem/kernels/stress_differential.h>
#include <fem/materials/materials.h>
#include <gtest/gtest.h>
#include <physgen/probe.h>

#include <set>
#include <string>

namespace physgen::fem::test {

/// A tag type that results call "kernel.array".
#define PHYSGEN_TEST_TAG(kernel, array)                                      \
  struct kernel##_##array {                                                  \
    [[maybe_unused]] static constexpr const char* name = #kernel "." #array; \
  };
PHYSGEN_TEST_TAG(ComputeSvd, gradient)
PHYSGEN_TEST_TAG(ComputeSvd, decomposition)
PHYSGEN_TEST_TAG(ComputeSvdParts, gradients)
PHYSGEN_TEST_TAG(ComputeSvdParts, left)
PHYSGEN_TEST_TAG(ComputeSvdParts, stretches)
PHYSGEN_TEST_TAG(ComputeStress, decomposition)
PHYSGEN_TEST_TAG(ComputeStress, stress)
PHYSGEN_TEST_TAG(ComputeStressDerivative, decomposition)
PHYSGEN_TEST_TAG(ComputeStressDerivative, derivative)
PHYSGEN_TEST_TAG(ComputeStressDifferential, decomposition)
PHYSGEN_TEST_TAG(ComputeStressDifferential, derivative)
PHYSGEN_TEST_TAG(ComputeStressDifferential, differential)
PHYSGEN_TEST_TAG(ComputeStressDifferential, stress)
PHYSGEN_TEST_TAG(ComputeRestShape, tets)
PHYSGEN_TEST_TAG(ComputeRestShape, positions)
PHYSGEN_TEST_TAG(ComputeRestShape, rest)
PHYSGEN_TEST_TAG(ComputeDeformationGradient, tets)
PHYSGEN_TEST_TAG(ComputeDeformationGradient, positions)
PHYSGEN_TEST_TAG(ComputeDeformationGradient, rest)
PHYSGEN_TEST_TAG(ComputeDeformationGradient, gradient)
PHYSGEN_TEST_TAG(ComputeCornerForces, rest)
PHYSGEN_TEST_TAG(ComputeCornerForces, stress)
PHYSGEN_TEST_TAG(ComputeCornerForces, forces)
PHYSGEN_TEST_TAG(GatherForces, node_tets_ranges)
PHYSGEN_TEST_TAG(GatherForces, node_tets_entries)
PHYSGEN_TEST_TAG(GatherForces, forces)
PHYSGEN_TEST_TAG(GatherForces, nodes)
PHYSGEN_TEST_TAG(GatherForceDifferentials, node_tets_ranges)
PHYSGEN_TEST_TAG(GatherForceDifferentials, node_tets_entries)
PHYSGEN_TEST_TAG(GatherForceDifferentials, differentials)
PHYSGEN_TEST_TAG(GatherForceDifferentials, nodes)
PHYSGEN_TEST_TAG(ComputeForceDifferentials, node_stiffness)
PHYSGEN_TEST_TAG(ComputeForceDifferentials, edge_stiffness)
PHYSGEN_TEST_TAG(ComputeForceDifferentials, edges)
PHYSGEN_TEST_TAG(ComputeForceDifferentials, node_edges_ranges)
PHYSGEN_TEST_TAG(ComputeForceDifferentials, node_edges_entries)
PHYSGEN_TEST_TAG(ComputeForceDifferentials, displacements)
PHYSGEN_TEST_TAG(ComputeForceDifferentials, differentials)
PHYSGEN_TEST_TAG(ComputeCornerForceDifferentials, tets)
PHYSGEN_TEST_TAG(ComputeCornerForceDifferentials, displacements)
PHYSGEN_TEST_TAG(ComputeCornerForceDifferentials, rest)
PHYSGEN_TEST_TAG(ComputeCornerForceDifferentials, decomposition)
PHYSGEN_TEST_TAG(ComputeCornerForceDifferentials, derivative)
PHYSGEN_TEST_TAG(ComputeCornerForceDifferentials, differentials)
PHYSGEN_TEST_TAG(ComputeTetStiffness, rest)
PHYSGEN_TEST_TAG(ComputeTetStiffness, decomposition)
PHYSGEN_TEST_TAG(ComputeTetStiffness, derivative)
PHYSGEN_TEST_TAG(ComputeTetStiffness, stiffness)
PHYSGEN_TEST_TAG(GatherNodeStiffness, node_tets_ranges)
PHYSGEN_TEST_TAG(GatherNodeStiffness, node_tets_entries)
PHYSGEN_TEST_TAG(GatherNodeStiffness, stiffness)
PHYSGEN_TEST_TAG(GatherNodeStiffness, nodes)
PHYSGEN_TEST_TAG(GatherEdgeStiffness, edge_tets_ranges)
PHYSGEN_TEST_TAG(GatherEdgeStiffness, edge_tets_entries)
PHYSGEN_TEST_TAG(GatherEdgeStiffness, stiffness)
PHYSGEN_TEST_TAG(GatherEdgeStiffness, edges)
#undef PHYSGEN_TEST_TAG

// Declares the array of a kernel. They are undefined below.
#define PHYSGEN_TEST_PROBE(kernel, array, Object) \
  ProbeOf<elasticity::Object##Array<float, typename On::Space>, kernel##_##array> array;
#define PHYSGEN_TEST_ROWS(kernel, rows)                                                                    \
  ProbeRows<ProbeOf<elasticity::IncidenceRangeArray<float, typename On::Space>, kernel##_##rows##_ranges>, \
            ProbeOf<elasticity::IncidenceArray<float, typename On::Space>, kernel##_##rows##_entries>>     \
      rows;

/// A program of all kernels, each over arrays of its own.
template <class On>
void run_all_kernels(On& on) {
  const auto neo_hookean = NeoHookean<float>::from(1e5, 0.4);
  {
    PHYSGEN_TEST_PROBE(ComputeSvd, gradient, DeformationGradient)
    PHYSGEN_TEST_PROBE(ComputeSvd, decomposition, DeformationSvd)
    on.run(1, ComputeSvd{gradient.const_view(), decomposition.view()});
  }
  {
    PHYSGEN_TEST_PROBE(ComputeSvdParts, gradients, DeformationGradient)
    PHYSGEN_TEST_PROBE(ComputeSvdParts, left, ElementRotation)
    PHYSGEN_TEST_PROBE(ComputeSvdParts, stretches, PrincipalStretches)
    on.run(1, ComputeSvdParts{gradients.const_view(), left.view(), stretches.view(), skip});
  }
  {
    PHYSGEN_TEST_PROBE(ComputeStress, decomposition, DeformationSvd)
    PHYSGEN_TEST_PROBE(ComputeStress, stress, Stress)
    on.run(1, ComputeStress{neo_hookean, decomposition.const_view(), stress.view()});
  }
  {
    PHYSGEN_TEST_PROBE(ComputeStressDerivative, decomposition, DeformationSvd)
    PHYSGEN_TEST_PROBE(ComputeStressDerivative, derivative, StressDerivative)
    on.run(1, ComputeStressDerivative{neo_hookean, decomposition.const_view(), derivative.view(), ClampEigenvalues{}});
  }
  {
    PHYSGEN_TEST_PROBE(ComputeStressDifferential, decomposition, DeformationSvd)
    PHYSGEN_TEST_PROBE(ComputeStressDifferential, derivative, StressDerivative)
    PHYSGEN_TEST_PROBE(ComputeStressDifferential, differential, DeformationGradientDifferential)
    PHYSGEN_TEST_PROBE(ComputeStressDifferential, stress, StressDifferential)
    on.run(1, ComputeStressDifferential{decomposition.const_view(), derivative.const_view(), differential.const_view(),
                                        stress.view()});
  }
  {
    PHYSGEN_TEST_PROBE(ComputeRestShape, tets, Tet)
    PHYSGEN_TEST_PROBE(ComputeRestShape, positions, NodePosition)
    PHYSGEN_TEST_PROBE(ComputeRestShape, rest, RestShape)
    on.run(1, ComputeRestShape{tets.const_view(), positions.const_view(), rest.view()});
  }
  {
    PHYSGEN_TEST_PROBE(ComputeDeformationGradient, tets, Tet)
    PHYSGEN_TEST_PROBE(ComputeDeformationGradient, positions, NodePosition)
    PHYSGEN_TEST_PROBE(ComputeDeformationGradient, rest, RestShape)
    PHYSGEN_TEST_PROBE(ComputeDeformationGradient, gradient, DeformationGradient)
    on.run(1,
           ComputeDeformationGradient{tets.const_view(), positions.const_view(), rest.const_view(), gradient.view()});
  }
  {
    PHYSGEN_TEST_PROBE(ComputeCornerForces, rest, RestShape)
    PHYSGEN_TEST_PROBE(ComputeCornerForces, stress, Stress)
    PHYSGEN_TEST_PROBE(ComputeCornerForces, forces, CornerForces)
    on.run(1, ComputeCornerForces{rest.const_view(), stress.const_view(), forces.view()});
  }
  {
    PHYSGEN_TEST_ROWS(GatherForces, node_tets)
    PHYSGEN_TEST_PROBE(GatherForces, forces, CornerForces)
    PHYSGEN_TEST_PROBE(GatherForces, nodes, NodeForce)
    on.run(1, GatherForces{node_tets.const_view(), forces.const_view(), nodes.view()});
  }
  {
    PHYSGEN_TEST_ROWS(GatherForceDifferentials, node_tets)
    PHYSGEN_TEST_PROBE(GatherForceDifferentials, differentials, CornerForces)
    PHYSGEN_TEST_PROBE(GatherForceDifferentials, nodes, NodeForceDifferential)
    on.run(1, GatherForceDifferentials{node_tets.const_view(), differentials.const_view(), nodes.view()});
  }
  {
    PHYSGEN_TEST_PROBE(ComputeForceDifferentials, node_stiffness, NodeStiffness)
    PHYSGEN_TEST_PROBE(ComputeForceDifferentials, edge_stiffness, EdgeStiffness)
    PHYSGEN_TEST_PROBE(ComputeForceDifferentials, edges, Edge)
    PHYSGEN_TEST_ROWS(ComputeForceDifferentials, node_edges)
    PHYSGEN_TEST_PROBE(ComputeForceDifferentials, displacements, NodeDisplacement)
    PHYSGEN_TEST_PROBE(ComputeForceDifferentials, differentials, NodeForceDifferential)
    on.run(1, ComputeForceDifferentials{node_stiffness.const_view(), edge_stiffness.const_view(), edges.const_view(),
                                        node_edges.const_view(), displacements.const_view(), differentials.view()});
  }
  {
    PHYSGEN_TEST_PROBE(ComputeCornerForceDifferentials, tets, Tet)
    PHYSGEN_TEST_PROBE(ComputeCornerForceDifferentials, displacements, NodeDisplacement)
    PHYSGEN_TEST_PROBE(ComputeCornerForceDifferentials, rest, RestShape)
    PHYSGEN_TEST_PROBE(ComputeCornerForceDifferentials, decomposition, DeformationSvd)
    PHYSGEN_TEST_PROBE(ComputeCornerForceDifferentials, derivative, StressDerivative)
    PHYSGEN_TEST_PROBE(ComputeCornerForceDifferentials, differentials, CornerForces)
    on.run(1,
           ComputeCornerForceDifferentials{tets.const_view(), displacements.const_view(), rest.const_view(),
                                           decomposition.const_view(), derivative.const_view(), differentials.view()});
  }
  {
    PHYSGEN_TEST_PROBE(ComputeTetStiffness, rest, RestShape)
    PHYSGEN_TEST_PROBE(ComputeTetStiffness, decomposition, DeformationSvd)
    PHYSGEN_TEST_PROBE(ComputeTetStiffness, derivative, StressDerivative)
    PHYSGEN_TEST_PROBE(ComputeTetStiffness, stiffness, TetStiffness)
    on.run(1, ComputeTetStiffness{rest.const_view(), decomposition.const_view(), derivative.const_view(),
                                  stiffness.view()});
  }
  {
    PHYSGEN_TEST_ROWS(GatherNodeStiffness, node_tets)
    PHYSGEN_TEST_PROBE(GatherNodeStiffness, stiffness, TetStiffness)
    PHYSGEN_TEST_PROBE(GatherNodeStiffness, nodes, NodeStiffness)
    on.run(1, GatherNodeStiffness{node_tets.const_view(), stiffness.const_view(), nodes.view()});
  }
  {
    PHYSGEN_TEST_ROWS(GatherEdgeStiffness, edge_tets)
    PHYSGEN_TEST_PROBE(GatherEdgeStiffness, stiffness, TetStiffness)
    PHYSGEN_TEST_PROBE(GatherEdgeStiffness, edges, EdgeStiffness)
    on.run(1, GatherEdgeStiffness{edge_tets.const_view(), stiffness.const_view(), edges.view()});
  }
}
#undef PHYSGEN_TEST_PROBE
#undef PHYSGEN_TEST_ROWS

/// "ComputeSvd.gradient.F R", ...
inline std::set<std::string> what_kernels_do() {
  // Each array has its fields, by reads and writes. * stands for all scalars of a stress derivative.
  struct Row {
    const char *array, *fields;
  };
  static constexpr Row table[] = {
      {"ComputeSvd.gradient", "F R,"},
      {"ComputeSvd.decomposition", "U W,V W,s W,"},
      {"ComputeSvdParts.gradients", "F R,"},
      {"ComputeSvdParts.left", "R W,"},
      {"ComputeSvdParts.stretches", "s W,"},
      {"ComputeStress.decomposition", "U R,V R,s R,"},
      {"ComputeStress.stress", "P W,"},
      {"ComputeStressDerivative.decomposition", "s R,"},
      {"ComputeStressDerivative.derivative", "* W,"},
      {"ComputeStressDifferential.decomposition", "U R,V R,"},
      {"ComputeStressDifferential.derivative", "* R,"},
      {"ComputeStressDifferential.differential", "dF R,"},
      {"ComputeStressDifferential.stress", "dP W,"},
      {"ComputeRestShape.tets", "nodes R,"},
      {"ComputeRestShape.positions", "x R,"},
      {"ComputeRestShape.rest", "dm_inverse W,volume W,"},
      {"ComputeDeformationGradient.tets", "nodes R,"},
      {"ComputeDeformationGradient.positions", "x R,"},
      {"ComputeDeformationGradient.rest", "dm_inverse R,"},
      {"ComputeDeformationGradient.gradient", "F W,"},
      {"ComputeCornerForces.rest", "dm_inverse R,volume R,"},
      {"ComputeCornerForces.stress", "P R,"},
      {"ComputeCornerForces.forces", "G W,"},
      {"GatherForces.node_tets_ranges", "begin R,end R,"},
      {"GatherForces.node_tets_entries", "element R,local R,"},
      {"GatherForces.forces", "G R,"},
      {"GatherForces.nodes", "f W,"},
      {"GatherForceDifferentials.node_tets_ranges", "begin R,end R,"},
      {"GatherForceDifferentials.node_tets_entries", "element R,local R,"},
      {"GatherForceDifferentials.differentials", "G R,"},
      {"GatherForceDifferentials.nodes", "df W,"},
      {"ComputeForceDifferentials.node_stiffness", "K R,"},
      {"ComputeForceDifferentials.edge_stiffness", "E R,"},
      {"ComputeForceDifferentials.edges", "nodes R,"},
      {"ComputeForceDifferentials.node_edges_ranges", "begin R,end R,"},
      {"ComputeForceDifferentials.node_edges_entries", "element R,local R,"},
      {"ComputeForceDifferentials.displacements", "dx R,"},
      {"ComputeForceDifferentials.differentials", "df W,"},
      {"ComputeCornerForceDifferentials.tets", "nodes R,"},
      {"ComputeCornerForceDifferentials.displacements", "dx R,"},
      {"ComputeCornerForceDifferentials.rest", "dm_inverse R,volume R,"},
      {"ComputeCornerForceDifferentials.decomposition", "U R,V R,"},
      {"ComputeCornerForceDifferentials.derivative", "* R,"},
      {"ComputeCornerForceDifferentials.differentials", "G W,"},
      {"ComputeTetStiffness.rest", "dm_inverse R,volume R,"},
      {"ComputeTetStiffness.decomposition", "U R,V R,"},
      {"ComputeTetStiffness.derivative", "* R,"},
      {"ComputeTetStiffness.stiffness", "k W,e W,"},
      {"GatherNodeStiffness.node_tets_ranges", "begin R,end R,"},
      {"GatherNodeStiffness.node_tets_entries", "element R,local R,"},
      {"GatherNodeStiffness.stiffness", "k R,"},
      {"GatherNodeStiffness.nodes", "K W,"},
      {"GatherEdgeStiffness.edge_tets_ranges", "begin R,end R,"},
      {"GatherEdgeStiffness.edge_tets_entries", "element R,local R,"},
      {"GatherEdgeStiffness.stiffness", "e R,"},
      {"GatherEdgeStiffness.edges", "E W,"},
  };
  std::set<std::string> all;
  for (const Row& row : table) {
    const std::string fields = row.fields, array = row.array;
    for (std::size_t from = 0; from < fields.size();) {
      const std::size_t end = fields.find(',', from);
      const std::string field = fields.substr(from, end - from);
      from = end + 1;
      if (field.front() != '*') {
        all.insert(array + "." + field);
        continue;
      }
      for (const char* x : {"x1111", "x2211", "x3311", "x2222", "x3322", "x3333", "x2121", "x2112", "x3131", "x3113",
                            "x3232", "x3223"}) {
        all.insert(array + "." + x + field.substr(1));
      }
    }
  }
  return all;
}

/// The same as found by this program.
inline std::set<std::string> what_is_found() {
  std::set<std::string> all;
  for (const probe::FieldAccess& row : probe::registered()) {
    all.insert(row.array + "." + row.field + (row.read ? " R" : " ") + (row.written ? "W" : "") +
               (row.address_taken ? "&" : ""));
  }
  return all;
}

}  // namespace physgen::fem::test
