// df = K dx of the assembled stiffness from its symmetric half alone: the diagonal blocks K_v of the nodes and one
// block E of each edge (m, n), which serves df(m) += E dx(n) and df(n) += E^T dx(m). Every block is read once, in the
// order in which it lies: about half the bytes of a general sparse product.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <elasticity.physgen.h>
#include <fem/kernels/edge_groups.h>
#include <fem/mesh/mesh.h>
#include <fem/numerics/scalar.h>
#include <physgen/kernels/pack.h>
#include <physgen/memory/buffer.h>
#include <physgen/memory/space.h>

namespace physgen::fem {

/// A way to form sums over edges where edges in different places meet at a node.
enum class SumOrder {
  any,    ///< the fastest: on CUDA vector atomics, whose order differs from run to run
  fixed,  ///< the same bits on every run: on the CPU contributions are stored, then added in the order of the edges; on
          ///< CUDA sums of the edges of groups of nodes are (edge_groups.h)
};

/// The term that an edge adds to a node: a whole number of 16-byte words, so that it is read and written at once.
template <class S>
struct alignas(16) Contribution {
  S x, y, z, unused;

  Contribution() = default;
  PHYSGEN_FUNCTION explicit Contribution(const Vector3<S>& value) : x(value[0]), y(value[1]), z(value[2]), unused(0) {}
  [[nodiscard]] PHYSGEN_FUNCTION Vector3<S> value() const { return {x, y, z}; }
};

/// The lists that the product needs of a mesh beside its blocks, and room for contributions: one product at a time.
/// Made once per topology.
class EdgeSums {
 public:
  /// For no mesh.
  EdgeSums() = default;
  /// @param mesh its edges (m, n) are ascending, as make_tet_mesh() makes them
  /// @param space where the product will run
  /// @param real_bytes of one scalar: sizeof(float) or sizeof(double)
  /// @param order of the products; SumOrder::any on CUDA needs no lists, and no room for contributions
  /// @throw Error when edges are not ascending or the memory cannot be had
  EdgeSums(const TetMesh& mesh, SpaceKind space, int real_bytes, SumOrder order = SumOrder::fixed)
      : EdgeSums(mesh.nodes, mesh.edges, space, real_bytes, order) {}
  /// The same of nodes and edges alone.
  /// @param first_edge edges below it stand for none, as those of a rank's part may: they play no part
  /// @param groups of nodes, as groups_of_part() makes them, where this is a part of a mesh; only CUDA goes by them
  EdgeSums(Index nodes, std::span<const std::array<Index, 2>> edges, SpaceKind space, int real_bytes, SumOrder order,
           index_t first_edge = 0, std::span<const Index> groups = {});

  /// @throw Error when a product of these sizes, in this space, precision and order, was not what this was made for
  void require(index_t nodes, index_t edges, SpaceKind space, int real_bytes, SumOrder order) const;

  [[nodiscard]] index_t nodes() const { return nodes_; }
  [[nodiscard]] index_t edges() const { return edges_; }
  [[nodiscard]] index_t bytes() const { return indices_.bytes() + groups_.bytes() + contributions_.bytes(); }
  /// The future bytes() of products on the host, or on CUDA in SumOrder::any.
  template <class Real>
  [[nodiscard]] static index_t bytes_for(index_t nodes, index_t edges, SpaceKind space) {
    if (space != SpaceKind::host) return 0;
    return (2 * (nodes + 1) + edges) * index_t{sizeof(Index)} + edges * index_t{sizeof(Contribution<Real>)};
  }
  /// By which products on CUDA go in SumOrder::fixed.
  [[nodiscard]] const EdgeGroups& groups() const { return groups_; }
  /// By which those on the host go. Per node: the first of its edges as m (and one past the last node).
  [[nodiscard]] const Index* first() const { return indices(0); }
  /// Per node: where the contributions of its edges as n begin (and one past the last node).
  [[nodiscard]] const Index* contributions_begin() const { return indices(nodes_ + 1); }
  /// Per edge: the place of its contribution to n.
  [[nodiscard]] const Index* place() const { return indices(2 * (nodes_ + 1)); }
  /// Room for the contributions of all edges, or the sums of all groups.
  template <class Real>
  [[nodiscard]] Contribution<Real>* contributions() const {
    return reinterpret_cast<Contribution<Real>*>(contributions_.data());
  }

 private:
  [[nodiscard]] const Index* indices(index_t from) const {
    return reinterpret_cast<const Index*>(indices_.data()) + from;
  }

  index_t nodes_ = 0, edges_ = 0;
  SpaceKind space_ = SpaceKind::host;
  int real_bytes_ = 0;
  SumOrder order_ = SumOrder::fixed;
  Buffer indices_, contributions_;
  EdgeGroups groups_;
};

/// The arrays of a product in one space; views of any layout and format.
/// @tparam DifferentialView for SumOrder::any on CUDA: AosPadded, so that the three sums of a node are one atomic
template <class NodeStiffnessView, class EdgeStiffnessView, class EdgeView, class DisplacementView,
          class DifferentialView>
struct SymmetricProduct {
  using Scalar = typename DifferentialView::Precision;
  NodeStiffnessView node_stiffness;  ///< elasticity::NodeStiffness
  EdgeStiffnessView edge_stiffness;  ///< elasticity::EdgeStiffness
  EdgeView edges;                    ///< elasticity::Edge, ascending
  DisplacementView displacements;    ///< elasticity::NodeDisplacement
  DifferentialView differentials;    ///< elasticity::NodeForceDifferential, written
};

namespace detail {

/// @throw Error naming the array when it does not have the size of the others
void require_size(const char* array, index_t size, index_t expected);

/// @throw Error when arrays of the product differ in size, or `sums` is not for it
template <class Product>
void require_sizes(const Product& product, const EdgeSums& sums, SpaceKind space, SumOrder order) {
  const index_t nodes = product.differentials.size(), edges = product.edges.size();
  require_size("node stiffness", product.node_stiffness.size(), nodes);
  require_size("displacements", product.displacements.size(), nodes);
  require_size("edge stiffness", product.edge_stiffness.size(), edges);
  sums.require(nodes, edges, space, sizeof(typename Product::Scalar), order);
}

/// The two contributions of an edge, or of a pack of edges.
template <class S>
struct EdgeContributions {
  Vector3<S> to_m, to_n;
};

template <class Product, class I>
[[gnu::always_inline]] PHYSGEN_FUNCTION inline auto edge_contributions(const Product& product, I i) {
  using Scalar = typename Product::Scalar;
  using S = lanes_t<Scalar, I>;
  const auto ends = product.edges[i].nodes();
  const lanes_t<std::int32_t, I> m = ends[0], n = ends[1];
  const Matrix3<S> E = product.edge_stiffness[i].E();
  const Vector3<S> dx_m = product.displacements[m].dx(), dx_n = product.displacements[n].dx();
  const Vector3<S> zero = Vector3<S>::Constant(S(Scalar(0)));
  return EdgeContributions<S>{multiply_add<S>(E, dx_n, zero), transpose_multiply_add<S>(E, dx_m, zero)};
}

/// K_v dx(v)
template <class Product>
PHYSGEN_FUNCTION inline Vector3<typename Product::Scalar> node_contribution(const Product& product,
                                                                            SingleObject auto node) {
  using S = typename Product::Scalar;
  const Matrix3<S> K = product.node_stiffness[node].K();
  const Vector3<S> dx = product.displacements[node].dx();
  return multiply_add<S>(K, dx, Vector3<S>::Zero());
}

/// df(v), which holds the sum over the edges of v as m, plus its contributions as n, in their order.
template <class Product>
PHYSGEN_FUNCTION inline void add_contributions(const Product& product, index_t node, const Index* begin,
                                               const Contribution<typename Product::Scalar>* contributions) {
  Vector3<typename Product::Scalar> sum = product.differentials[node].df();
  const Index last = begin[node + 1];
  for (Index k = begin[node]; k < last; ++k) {
    const Contribution from = contributions[k];
    sum += from.value();
  }
  product.differentials[node].df() = sum;
}

}  // namespace detail
}  // namespace physgen::fem

#pragma pop_macro("I")
