// Kernels: sums at nodes of what tets do at their corners, by tets: the last steps of a fused kernel, whose corner
// forces are a local. Either each tet adds to its nodes, fast, in an order that is open; or it stores what it does at
// each corner where the node's row has a place for it, and the rows are summed: the same bits on every run, and those
// of the gather from corner forces.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/numerics/scalar.h>
#include <physgen/kernels/add.h>
#include <physgen/rows.h>

namespace physgen::fem {

namespace detail {

/// The term of a tet at its corner c, given G: column c - 1, and at corner 0 minus all of them.
template <class S>
PHYSGEN_FUNCTION inline Vector3<S> at_corner(const Matrix3<S>& G, int c) {
  if (c > 0) return G.col(c - 1);
  return -(G.col(0) + G.col(1) + G.col(2));
}

}  // namespace detail

/// Adds each tet's corner forces to the forces of its nodes, which are set to zero before.
template <class TetView, class CornerView, class NodeView>
struct AddCornerForces {
  using Scalar = typename NodeView::Precision;
  TetView tets;       ///< elasticity::Tet
  CornerView forces;  ///< elasticity::CornerForces
  NodeView nodes;     ///< elasticity::NodeForce, added to

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const Matrix3<S> G = forces[i].G();
    const auto corners = tets[i].nodes();
    PHYSGEN_UNROLL
    for (int c = 0; c < 4; ++c) {
      const lanes_t<std::int32_t, I> node = corners[c];
      add(i, nodes[node].f(), detail::at_corner<S>(G, c));
    }
  }
};

/// The same of force differentials.
template <class TetView, class CornerView, class NodeView>
struct AddCornerForceDifferentials {
  using Scalar = typename NodeView::Precision;
  TetView tets;              ///< elasticity::Tet
  CornerView differentials;  ///< elasticity::CornerForces: their change
  NodeView nodes;            ///< elasticity::NodeForceDifferential, added to

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const Matrix3<S> G = differentials[i].G();
    const auto corners = tets[i].nodes();
    PHYSGEN_UNROLL
    for (int c = 0; c < 4; ++c) {
      const lanes_t<std::int32_t, I> node = corners[c];
      add(i, nodes[node].df(), detail::at_corner<S>(G, c));
    }
  }
};

/// Sets the force, or the force differential, of each node to zero.
template <class NodeView>
struct ClearNodes {
  using Scalar = typename NodeView::Precision;
  NodeView nodes;  ///< an object of one vector, such as elasticity::NodeForce, written

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    nodes.put(i, {Vector3<lanes_t<Scalar, I>>::Constant(lanes_t<Scalar, I>(Scalar(0)))});
  }
};

/// Where the corners of tets stand among the incidences of nodes; once per mesh, over the incidences.
template <class EntryView, class PlaceView>
struct FindPlaces {
  EntryView entries;  ///< elasticity::Incidence: tet, corner
  PlaceView places;   ///< elasticity::TetPlaces, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto entry) const {
    const auto incidence = entries[entry];
    places[index_t{incidence.element()}].places()[incidence.local()] = static_cast<std::int32_t>(object_number(entry));
  }
};
template <class... Views>
FindPlaces(Views...) -> FindPlaces<Views...>;  // for clang before 17, where no template makes one

/// Stores each tet's force on each of its corners at that corner's place.
template <class PlaceView, class CornerView, class PlacedView>
struct ScatterCornerForces {
  using Scalar = typename PlacedView::Precision;
  PlaceView places;   ///< elasticity::TetPlaces
  CornerView forces;  ///< elasticity::CornerForces
  PlacedView placed;  ///< elasticity::PlacedForce, as many as incidences; written

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const Matrix3<S> G = forces[i].G();
    const auto corners = places[i].places();
    PHYSGEN_UNROLL
    for (int c = 0; c < 4; ++c) {
      const lanes_t<std::int32_t, I> place = corners[c];
      placed[place].f() = detail::at_corner<S>(G, c);
    }
  }
};

/// f(node) = sum over its row of placed forces, in its order. Called with the objects 0 .. size() - 1: four for each
/// node, of which three sum a component each. (On a GPU, neighbours in a warp then read what lies side by side; a
/// thread for each node takes a sixth more time.)
template <class RangeView, class PlacedView, class NodeView>
struct SumRowForces {
  using Scalar = typename NodeView::Precision;
  Rows<RangeView, PlacedView> rows;  ///< elasticity::IncidenceRange of each node, elasticity::PlacedForce
  NodeView nodes;                    ///< elasticity::NodeForce, written

  /// @throw Error when there is not a row for each node
  SumRowForces(const RangeView& ranges, const PlacedView& placed, const NodeView& sums)
      : rows(ranges, placed, 0), nodes(sums) {
    rows.require("SumRowForces: ranges", nodes.size(), 0);
  }

  [[nodiscard]] index_t size() const { return 4 * nodes.size(); }
  PHYSGEN_FUNCTION void operator()(SingleObject auto i) const {
    const index_t at = object_number(i), node = at / 4;
    const int component = static_cast<int>(at % 4);
    if (component == 3) return;
    nodes[node].f()[component] =
        rows.sum(node, Scalar(0), [component](const auto& placed) -> Scalar { return placed.f()[component]; });
  }
};

}  // namespace physgen::fem

#pragma pop_macro("I")
