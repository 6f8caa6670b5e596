// The scene relax: springs pull nodes until they are at rest, in one process and on several ranks.
#pragma once

#include <physgen/launch/reduce.h>
#include <physgen/scene.h>

#include "springs.h"

namespace scenes {
using namespace physgen::scene;

/// Where springs of equal length pull nodes to.
struct PHYSGEN_SCENE() relax {
  using Real = float;
  struct Body {
    PHYSGEN_ARRAY(per("node"), input(), output()) Array<elasticity::NodePositionObject, Real> positions;
    PHYSGEN_ARRAY(per("node")) Array<elasticity::NodeForceObject, Real> forces;
    PHYSGEN_ARRAY(per("edge"), input(), names("nodes", "node"), follows("node"))
    Array<elasticity::EdgeObject, Real> edges;
    PHYSGEN_ARRAY(per("edge")) Array<elasticity::NodeForceObject, Real> springs;
    PHYSGEN_ARRAY(per("node"), input()) Array<elasticity::IncidenceRangeObject, Real> ranges;
    PHYSGEN_ARRAY(per("end"), input(), names("element", "edge"), no_index("local"))
    Array<elasticity::IncidenceObject, Real> ends;
    /// f = (squared force of all, the node with the largest, steps)
    PHYSGEN_ARRAY(per(1), input(), output()) Array<elasticity::NodeForceObject, double> state;
  };

  /// @param refused the local number of a node that may not move, or -1
  template <class On, class Body>
  static void program(On& on, Body& body, int steps, double most, physgen::index_t refused) {
    typename On::Loop loop;
    on.repeat(
        loop, steps,
        [&] {
          on.run(body.edges.size(),
                 springs::Pull{body.edges.const_view(), body.positions.const_view(), body.springs.view(), 0.7F});
          on.run(body.forces.size(),
                 springs::SumPulls{physgen::Rows(body.ranges.const_view(), body.ends.const_view(), body.edges.size()),
                                   body.springs.const_view(), body.forces.view()});
          on.run(body.positions.size(), springs::Move{body.forces.const_view(), body.positions.view(), 0.1F, refused});
          on.reduce(body.forces.size(), springs::SquaredForce{body.forces.const_view()}, physgen::Sum{},
                    springs::StoreSquare{body.state.view()});
        },
        springs::IsAtRest{body.state.const_view(), most});
    on.reduce(body.forces.size(), springs::SquaredForce{body.forces.const_view()}, physgen::Argmax{},
              springs::StoreNode{body.state.view()});
  }
};

}  // namespace scenes
