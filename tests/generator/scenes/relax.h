// The scene relax: springs along edges pull nodes together. It states which objects its index fields name, so that what
// crosses between ranks is found.
#pragma once

#include <elasticity.physgen.h>
#include <physgen/kernel.h>
#include <physgen/rows.h>
#include <physgen/scene.h>

namespace springs {

/// The pull of each edge on its first node: the vector to its second one.
template <class EdgeView, class PositionView, class PullView>
struct Pull {
  using Scalar = typename PullView::Precision;
  EdgeView edges;          ///< elasticity::Edge
  PositionView positions;  ///< elasticity::NodePosition
  PullView pulls;          ///< elasticity::PlacedForce, written
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    const auto ends = edges[i].nodes();
    const physgen::lanes_t<std::int32_t, I> first = ends[0], second = ends[1];
    pulls[i].f() = positions[second].x().get() - positions[first].x().get();
  }
};

/// The sum of the pulls of a node's edges.
template <class NodeEnds, class PullView, class ForceView>
struct SumPulls {
  using Scalar = typename ForceView::Precision;
  NodeEnds ends;     ///< Rows of elasticity::Incidence: edge, and which of its ends the node is
  PullView pulls;    ///< elasticity::PlacedForce
  ForceView forces;  ///< elasticity::NodeForce, written
  PHYSGEN_FUNCTION void operator()(physgen::SingleObject auto node) const {
    using Vector = Eigen::Matrix<Scalar, 3, 1>;
    forces[node].f() = ends.sum(node, Vector(Vector::Zero()), [&](const auto& end) -> Vector {
      const Vector pull = pulls[physgen::index_t{end.element()}].f();
      return end.local() == 0 ? pull : Vector(-pull);
    });
  }
};

template <class ForceView, class PositionView>
struct Step {
  using Scalar = typename PositionView::Precision;
  Scalar length;
  ForceView forces;        ///< elasticity::NodeForce
  PositionView positions;  ///< elasticity::NodePosition
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = physgen::lanes_t<Scalar, I>;
    positions[i].x() = positions[i].x().get() + forces[i].f().get() * S(length);
  }
};

}  // namespace springs

namespace scenes {
using namespace physgen::scene;

/// Where springs pull nodes to in some steps.
struct PHYSGEN_SCENE() relax {
  using Real = float;
  struct Body {
    PHYSGEN_ARRAY(per("node"), input(), output()) Array<elasticity::NodePositionObject, Real> positions;
    PHYSGEN_ARRAY(per("node")) Array<elasticity::NodeForceObject, Real> forces;
    PHYSGEN_ARRAY(per("edge"), input(), names("nodes", "node"), follows("node"))
    Array<elasticity::EdgeObject, Real> edges;
    PHYSGEN_ARRAY(per("edge")) Array<elasticity::PlacedForceObject, Real> pulls;
    PHYSGEN_ARRAY(per("node"), input()) Array<elasticity::IncidenceRangeObject, Real> ranges;
    PHYSGEN_ARRAY(per("end"), input(), names("element", "edge")) Array<elasticity::IncidenceObject, Real> ends;
  };

  template <class On, class Body>
  static void program(On& on, Body& body, int steps) {
    const physgen::Rows ends(body.ranges.const_view(), body.ends.const_view(), body.edges.size());
    for (int k = 0; k < steps; ++k) {
      on.run(body.edges.size(), springs::Pull{body.edges.const_view(), body.positions.const_view(), body.pulls.view()});
      on.run(body.forces.size(), springs::SumPulls{ends, body.pulls.const_view(), body.forces.view()});
      on.run(body.positions.size(), springs::Step{Real(0.1), body.forces.const_view(), body.positions.view()});
    }
  }
};

}  // namespace scenes
