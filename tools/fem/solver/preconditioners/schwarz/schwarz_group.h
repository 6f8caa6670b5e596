// The group of arrays of the multilevel Schwarz preconditioner, as scenes declare it.
#pragma once

#include <fem/solver/arrays/solver_groups.h>

namespace physgen::fem::groups {

/// The multilevel Schwarz preconditioner of one level.
struct OfSchwarz {
  struct Schwarz {
    PHYSGEN_ARRAY(per("node"), input(), names("slot", "slot")) Array<quasistatic::SchwarzNodeObject, Real> nodes;
    PHYSGEN_ARRAY(per("slot"), input(), names("source", "node"), names("source", "supernode"),
                  names("parent", "supernode"), names("parent", "slot"))
    Array<quasistatic::SchwarzSlotObject, Real> slots;
    PHYSGEN_ARRAY(per("block"), input("parent", "children", "arrived"), names("parent", "block"), no_index("children"),
                  no_index("arrived"))
    Array<quasistatic::SchwarzBlockObject, Real> blocks;
    PHYSGEN_ARRAY(per("supernode"), input()) Array<elasticity::IncidenceRangeObject, float> supernode_term_ranges;
    PHYSGEN_ARRAY(per("supernode_term"), input(), names("source", "edge_node"), names("source", "edge"),
                  names("source", "supernode"), names("source", "pair"), no_index("kind"))
    Array<quasistatic::SchwarzTermObject, float> supernode_term_entries;
    PHYSGEN_ARRAY(per("pair"), input()) Array<elasticity::IncidenceRangeObject, float> pair_term_ranges;
    PHYSGEN_ARRAY(per("pair_term"), input(), names("source", "edge"), names("source", "pair"), no_index("kind"))
    Array<quasistatic::SchwarzTermObject, float> pair_term_entries;
    PHYSGEN_ARRAY(per("block"), input()) Array<elasticity::IncidenceRangeObject, float> block_edge_ranges;
    PHYSGEN_ARRAY(per("block_edge"), input(), names("edge", "edge"), names("edge", "pair"), no_index("places"))
    Array<quasistatic::SchwarzPairObject, float> block_edge_entries;

    // Supernodes of all levels but the first.
    PHYSGEN_ARRAY(per("supernode")) Array<quasistatic::SupernodeObject, Real> supernodes;
    PHYSGEN_ARRAY(per("pair")) Array<elasticity::EdgeStiffnessObject, Real> pair_stiffness;
    /// r, summed over the nodes of each supernode.
    PHYSGEN_ARRAY(per("supernode")) Array<elasticity::NodeForceDifferentialObject, Real> residual;
    /// z
    PHYSGEN_ARRAY(per("supernode")) Array<elasticity::NodeDisplacementObject, Real> correction;
    PHYSGEN_ARRAY(per("factor")) Array<quasistatic::SchwarzFactorObject, Real> factors;
  };
};

}  // namespace physgen::fem::groups
