// The kernels that are measured, one struct each: what it reads and writes, how many bytes it must move, and how to
// make it from views. (Their references stand in naive.h.)
#pragma once

#include <fem/compute_svd.h>
#include <fem/deformation_gradient.h>
#include <fem/dp_from_df.h>
#include <fem/elastic_force.h>
#include <fem/force_differential.h>
#include <fem/materials/neo_hookean.h>
#include <fem/stiffness.h>
#include <fem/stress.h>
#include <fem/stress_derivative.h>

#include "kernel_list.h"
#include "operands.h"

namespace physgen::bench {

/// The material of all rows: silicone.
inline constexpr double youngs_modulus = 15e3;  ///< [Pa]
inline constexpr double poissons_ratio = 0.45;

template <class Real>
fem::NeoHookean<Real> material() {
  return fem::NeoHookean<Real>::from(youngs_modulus, poissons_ratio);
}

namespace source {

// Streamed per tet.
struct Tets : Streamed<elasticity::TetObject, Domain::tets> {
  static const auto& of(Dataset& data) { return data.tets(); }
};
struct RestShapes : Streamed<elasticity::RestShapeObject, Domain::tets> {
  static const auto& of(Dataset& data) { return data.rest_shapes(); }
};
struct DeformationGradients : Streamed<elasticity::DeformationGradientObject, Domain::tets> {
  static const auto& of(Dataset& data) { return data.deformation_gradients(); }
};
struct Differentials : Streamed<elasticity::DeformationGradientDifferentialObject, Domain::tets> {
  static const auto& of(Dataset& data) { return data.differentials(); }
};
struct Svds : Streamed<elasticity::DeformationSvdObject, Domain::tets> {
  static const auto& of(Dataset& data) { return data.svds(); }
};
struct StressDerivatives : Streamed<elasticity::StressDerivativeObject, Domain::tets> {
  static const auto& of(Dataset& data) { return data.stress_derivatives(); }
};
struct Stresses : Streamed<elasticity::StressObject, Domain::tets> {
  static const auto& of(Dataset& data) { return data.stresses(); }
};
struct CornerForces : Streamed<elasticity::CornerForcesObject, Domain::tets> {
  static const auto& of(Dataset& data) { return data.corner_forces(); }
};
struct TetStiffness : Streamed<elasticity::TetStiffnessObject, Domain::tets> {
  static const auto& of(Dataset& data) { return data.tet_stiffness(); }
};

// Streamed per node or edge.
struct NodeStiffness : Streamed<elasticity::NodeStiffnessObject, Domain::nodes> {
  static const auto& of(Dataset& data) { return data.node_stiffness(); }
};
struct EdgeStiffness : Streamed<elasticity::EdgeStiffnessObject, Domain::edges> {
  static const auto& of(Dataset& data) { return data.edge_stiffness(); }
};
struct Edges : Streamed<elasticity::EdgeObject, Domain::edges> {
  static const auto& of(Dataset& data) { return data.edges(); }
};

// Gathered.
struct Positions : Fixed<elasticity::NodePositionObject, Domain::nodes> {
  static const auto& of(Dataset& data) { return data.positions(); }
};
struct Displacements : Fixed<elasticity::NodeDisplacementObject, Domain::nodes> {
  static const auto& of(Dataset& data) { return data.displacements(); }
};

// Which elements touch an object: the range of each, and what the ranges point into.
template <Domain kObjects, Domain kEntries>
struct Ranges : Fixed<elasticity::IncidenceRangeObject, kObjects, Aos> {
  static const auto& of(Dataset& data) { return data.incidences(kEntries).ranges; }
};
template <Domain kEntries>
struct Entries : Fixed<elasticity::IncidenceObject, kEntries, Aos> {
  static const auto& of(Dataset& data) { return data.incidences(kEntries).entries; }
};

}  // namespace source

/// Bytes of a gather over incidences into `objects`, beside the values gathered: ranges and entries.
inline double incidence_bytes(double objects, double entries) { return 8 * objects + 8 * entries; }

struct DeformationGradient {
  static constexpr const char* name = "deformation_gradient";
  using Reads = Inputs<source::Tets, source::Positions, source::RestShapes>;
  using Output = Streamed<elasticity::DeformationGradientObject, Domain::tets>;
  static double bytes(const MeshSizes& n, double real) { return n.tets * (16 + 18 * real) + n.nodes * 3 * real; }
  template <class Real, class... View>
  static auto make(const View&... view) {
    return fem::ComputeDeformationGradient{view...};
  }
};

struct Svd {
  static constexpr const char* name = "svd";
  using Reads = Inputs<source::DeformationGradients>;
  using Output = Streamed<elasticity::DeformationSvdObject, Domain::tets>;
  static double bytes(const MeshSizes& n, double real) { return n.tets * 30 * real; }
  template <class Real, class... View>
  static auto make(const View&... view) {
    return fem::ComputeSvd{view...};
  }
};

struct Stress {
  static constexpr const char* name = "stress";
  using Reads = Inputs<source::Svds>;
  using Output = Streamed<elasticity::StressObject, Domain::tets>;
  static double bytes(const MeshSizes& n, double real) { return n.tets * 30 * real; }
  template <class Real, class... View>
  static auto make(const View&... view) {
    return fem::ComputeStress{material<Real>(), view...};
  }
};

struct StressDerivative {
  static constexpr const char* name = "stress_derivative";
  using Reads = Inputs<source::Svds>;
  using Output = Streamed<elasticity::StressDerivativeObject, Domain::tets>;
  static double bytes(const MeshSizes& n, double real) { return n.tets * 15 * real; }
  template <class Real, class... View>
  static auto make(const View&... view) {
    return fem::ComputeStressDerivative{material<Real>(), view...};
  }
};

struct DpFromDf {
  static constexpr const char* name = "dp_from_df";
  using Reads = Inputs<source::Svds, source::StressDerivatives, source::Differentials>;
  using Output = Streamed<elasticity::StressDifferentialObject, Domain::tets>;
  static double bytes(const MeshSizes& n, double real) { return n.tets * 48 * real; }
  template <class Real, class... View>
  static auto make(const View&... view) {
    return fem::DpFromDf{view...};
  }
};

/// Per tet, before the sums at the nodes.
struct ElasticForce {
  static constexpr const char* name = "elastic_force";
  using Reads = Inputs<source::RestShapes, source::Stresses>;
  using Output = Streamed<elasticity::CornerForcesObject, Domain::tets>;
  static double bytes(const MeshSizes& n, double real) { return n.tets * 28 * real; }
  template <class Real, class... View>
  static auto make(const View&... view) {
    return fem::ComputeCornerForces{view...};
  }
};

struct GatherForces {
  static constexpr const char* name = "gather_forces";
  using Reads = Inputs<source::Ranges<Domain::nodes, Domain::node_tets>, source::Entries<Domain::node_tets>,
                       source::CornerForces>;
  using Output = Fixed<elasticity::NodeForceObject, Domain::nodes>;
  static double bytes(const MeshSizes& n, double real) {
    return incidence_bytes(n.nodes, 4 * n.tets) + n.tets * 9 * real + n.nodes * 3 * real;
  }
  template <class Real>
  static auto make(const auto& ranges, const auto& entries, const auto& forces, const auto& out) {
    return fem::GatherForces{Rows{ranges, entries, forces.size()}, forces, out};
  }
};

struct TetStiffness {
  static constexpr const char* name = "tet_stiffness";
  using Reads = Inputs<source::RestShapes, source::Svds, source::StressDerivatives>;
  using Output = Streamed<elasticity::TetStiffnessObject, Domain::tets>;
  static double bytes(const MeshSizes& n, double real) { return n.tets * 118 * real; }
  template <class Real, class... View>
  static auto make(const View&... view) {
    return fem::ComputeTetStiffness{view...};
  }
};

struct NodeStiffness {
  static constexpr const char* name = "node_stiffness";
  using Reads = Inputs<source::Ranges<Domain::nodes, Domain::node_tets>, source::Entries<Domain::node_tets>,
                       source::TetStiffness>;
  using Output = Streamed<elasticity::NodeStiffnessObject, Domain::nodes>;
  static double bytes(const MeshSizes& n, double real) {
    return incidence_bytes(n.nodes, 4 * n.tets) + n.tets * 24 * real + n.nodes * 6 * real;
  }
  template <class Real>
  static auto make(const auto& ranges, const auto& entries, const auto& tets, const auto& out) {
    return fem::GatherNodeStiffness{Rows{ranges, entries, tets.size()}, tets, out};
  }
};

struct EdgeStiffness {
  static constexpr const char* name = "edge_stiffness";
  using Reads = Inputs<source::Ranges<Domain::edges, Domain::edge_tets>, source::Entries<Domain::edge_tets>,
                       source::TetStiffness>;
  using Output = Streamed<elasticity::EdgeStiffnessObject, Domain::edges>;
  static double bytes(const MeshSizes& n, double real) {
    return incidence_bytes(n.edges, 6 * n.tets) + n.tets * 54 * real + n.edges * 9 * real;
  }
  template <class Real>
  static auto make(const auto& ranges, const auto& entries, const auto& tets, const auto& out) {
    return fem::GatherEdgeStiffness{Rows{ranges, entries, tets.size()}, tets, out};
  }
};

struct AddForceDifferential {
  static constexpr const char* name = "add_force_differential";
  using Reads = Inputs<source::NodeStiffness, source::EdgeStiffness, source::Edges,
                       source::Ranges<Domain::nodes, Domain::node_edges>, source::Entries<Domain::node_edges>,
                       source::Displacements>;
  using Output = Fixed<elasticity::NodeForceDifferentialObject, Domain::nodes>;
  static double bytes(const MeshSizes& n, double real) {
    return incidence_bytes(n.nodes, 2 * n.edges) + n.edges * (8 + 9 * real) + n.nodes * 12 * real;
  }
  template <class Real>
  static auto make(const auto& nodes, const auto& blocks, const auto& edges, const auto& ranges, const auto& entries,
                   const auto& displacements, const auto& out) {
    return fem::ForceDifferential{nodes, blocks, edges, Rows{ranges, entries, edges.size()}, displacements, out};
  }
};

/// Matrix-free, per tet, before the sums at the nodes.
struct ElementForceDifferential {
  static constexpr const char* name = "element_force_differential";
  using Reads =
      Inputs<source::Tets, source::Displacements, source::RestShapes, source::Svds, source::StressDerivatives>;
  using Output = Streamed<elasticity::CornerForcesObject, Domain::tets>;
  static double bytes(const MeshSizes& n, double real) { return n.tets * (16 + 49 * real) + n.nodes * 3 * real; }
  template <class Real, class... View>
  static auto make(const View&... view) {
    return fem::ComputeCornerForceDifferentials{view...};
  }
};

}  // namespace physgen::bench
