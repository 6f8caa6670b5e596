// Kernels and programs: K dx from the tangents of tets and patches as they are, without blocks of edges: matrix-free.
// It includes prescribed components, as the assembled product does.
//
// For a tet in float the product moves its tangent (120 bytes), its corners (16) and their dx, which neighbours share;
// then the change of its forces. On CUDA that is added to the nodes by vector atomics: 48 bytes in the L2 cache, and no
// memory of its own. Written for a gather it would be 36 bytes written and read from other places, with 16 to 32 bytes
// of lists. On the CPU sums must have the same bits on every run, so there it is a gather in a fixed order, over the
// corner forces of the evaluation, which nobody reads while a system is solved.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/kernels/stiffness.h>
#include <fem/kernels/stress_differential.h>
#include <fem/solver/elastic/corner_sums.h>
#include <fem/solver/elastic/evaluate_tets.h>
#include <fem/solver/levels/linear_level.h>
#include <fem/solver/levels/scaled_blocks.h>
#include <fem/solver/settings.h>
#include <physgen/kernel.h>
#include <physgen/kernels/add.h>

namespace physgen::fem {

namespace detail {

/// Change of the forces of a tet on its corners j, k, l along dx, by columns: -volume dP Dm^-T [N].
template <class Real, class I, class TetView, class TangentView, class DisplacementView>
PHYSGEN_FUNCTION inline Matrix3<lanes_t<Real, I>> tet_differential(const TetView& tets, const TangentView& tangent,
                                                                   const DisplacementView& displacements, I i) {
  using S = lanes_t<Real, I>;
  const Matrix3<S> ds = edge_matrix<Real>(tets, i, [&](auto node) { return displacements[node].dx().get(); });
  const auto tet = tangent[i];
  const Matrix3<S> U = tet.U(), g = tet.g();
  const Matrix3<S> dF = multiply_transpose<S>(transpose_multiply<S>(U, ds), g);  // U^T dF V
  const Matrix3<S> dP = principal_differential<S>(tet, dF);                      // times the volume
  return -multiply<S>(multiply<S>(U, dP), g);
}

/// Change of a patch's volume with the node of a slot. That of the first is minus the sum of the others, so that a
/// translation changes nothing.
template <class Scalar, class Patch>
PHYSGEN_FUNCTION inline Vector3<Scalar> patch_gradient(const Patch& patch, int slot) {
  const auto g = patch.g();
  if (slot != 0) return {Scalar(g[3 * slot]), Scalar(g[3 * slot + 1]), Scalar(g[3 * slot + 2])};
  Vector3<Scalar> sum = Vector3<Scalar>::Zero();
  for (int k = 3; k < 24; ++k) sum[k % 3] -= Scalar(g[k]);
  return sum;
}

/// k g . dx [N/m^2]
template <class Scalar, class Names, class Patch, class DisplacementView>
PHYSGEN_FUNCTION inline Scalar patch_change(const Names& names, const Patch& patch,
                                            const DisplacementView& displacements) {
  const index_t first = names[0];
  const Vector3<Scalar> origin = displacements[first].dx();
  Scalar change = 0;
  for (int slot = 1; slot < 8; ++slot) {
    const index_t node = names[slot];
    const Vector3<Scalar> dx = displacements[node].dx();
    change += dot3<Scalar>(patch_gradient<Scalar>(patch, slot), dx - origin);
  }
  return Scalar(patch.k()) * change;
}

}  // namespace detail

/// The change of the forces of a chunk of tets on their corners. Called with the objects 0 .. chunk.tets() - 1 of
/// `corners`.
template <class TetView, class TangentView, class DisplacementView, class CornerView>
struct ComputeTetDifferentials {
  using Scalar = typename CornerView::Precision;
  TetChunk chunk;
  TetView tets;                    ///< elasticity::Tet
  TangentView tangent;             ///< quasistatic::TetTangent
  DisplacementView displacements;  ///< elasticity::NodeDisplacement
  CornerView corners;              ///< elasticity::CornerForces, written: their change

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using Real = typename TangentView::Precision;
    const auto t = object_of_part(chunk.first_tet, i);
    corners[i].G() = detail::cast_matrix<Scalar>(detail::tet_differential<Real>(tets, tangent, displacements, t));
  }
};

/// The same, added to the nodes: df += K dx of the tets.
template <class TetView, class TangentView, class DisplacementView, class DifferentialView>
struct AddTetDifferentials {
  using Scalar = typename DifferentialView::Precision;
  TetView tets;                    ///< elasticity::Tet
  TangentView tangent;             ///< quasistatic::TetTangent
  DisplacementView displacements;  ///< elasticity::NodeDisplacement
  DifferentialView differentials;  ///< elasticity::NodeForceDifferential

  PHYSGEN_FUNCTION void operator()(SingleObject auto i) const {
    const Matrix3<Scalar> dG = detail::tet_differential<Scalar>(tets, tangent, displacements, i);
    const auto names = tets[i].nodes();
    const index_t first = names[0];
    add(i, differentials[first].df(), Vector3<Scalar>(-(dG.col(0) + dG.col(1) + dG.col(2))));
    for (int c = 0; c < 3; ++c) {
      const index_t node = names[c + 1];
      add(i, differentials[node].df(), Vector3<Scalar>(dG.col(c)));
    }
  }
};

/// k g . dx of each patch.
template <class NodesView, class TangentView, class DisplacementView, class ChangeView>
struct ComputePatchChanges {
  using Scalar = typename ChangeView::Precision;
  NodesView nodes;                 ///< quasistatic::PatchNodes
  TangentView tangent;             ///< quasistatic::PatchTangent
  DisplacementView displacements;  ///< elasticity::NodeDisplacement
  ChangeView changes;              ///< quasistatic::PatchChange, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto p) const {
    changes[p].change() = detail::patch_change<Scalar>(nodes[p].nodes(), tangent[p], displacements);
  }
};

/// df -= k g (g . dx) at the nodes of each patch.
template <class NodesView, class TangentView, class DisplacementView, class DifferentialView>
struct AddPatchDifferentials {
  using Scalar = typename DifferentialView::Precision;
  NodesView nodes;                 ///< quasistatic::PatchNodes
  TangentView tangent;             ///< quasistatic::PatchTangent
  DisplacementView displacements;  ///< elasticity::NodeDisplacement
  DifferentialView differentials;  ///< elasticity::NodeForceDifferential

  PHYSGEN_FUNCTION void operator()(SingleObject auto p) const {
    const auto names = nodes[p].nodes();
    const auto patch = tangent[p];
    const Scalar change = detail::patch_change<Scalar>(names, patch, displacements);
    const index_t first = names[0];
    for (int slot = 0; slot < 8; ++slot) {
      const index_t node = names[slot];
      if (slot != 0 && node == first) continue;  // not used
      const Vector3<Scalar> g = detail::patch_gradient<Scalar>(patch, slot);
      add(p, differentials[node].df(), Vector3<Scalar>(g * -change));
    }
  }
};

/// No patches average the volume.
struct NoNodePatches {
  static constexpr bool averages = false;
};

/// The patches of a node.
template <class NodePatches, class TangentView>
struct NodePatchTangents {
  static constexpr bool averages = true;
  NodePatches node_patches;  ///< Rows of NodePatchEntry
  TangentView tangent;       ///< quasistatic::PatchTangent
};

/// The same with what each patch's volume changes by.
template <class NodePatches, class TangentView, class ChangeView>
struct NodePatchChanges {
  static constexpr bool averages = true;
  NodePatches node_patches;  ///< Rows of NodePatchEntry
  TangentView tangent;       ///< quasistatic::PatchTangent
  ChangeView changes;        ///< quasistatic::PatchChange
};

/// df += the changes of the forces of its patches, and of its tets, those of one chunk, in this order: the bits do not
/// depend on how many chunks there are.
template <class NodeTets, class CornerView, class Patches, class DifferentialView>
struct SumDifferentials {
  using Scalar = typename DifferentialView::Precision;
  TetChunk chunk;                  ///< before the first, patches are added. Called with 0 .. chunk.nodes() - 1
  NodeTets node_tets;              ///< Rows of NodeTetEntry
  CornerView corners;              ///< elasticity::CornerForces: their change
  Patches patches;                 ///< NoNodePatches or NodePatchChanges
  DifferentialView differentials;  ///< elasticity::NodeForceDifferential

  PHYSGEN_FUNCTION void operator()(SingleObject auto i) const {
    using Vector = Vector3<Scalar>;
    const auto node = object_of_part(chunk.first_node, i);
    Vector sum = differentials[node].df();
    if constexpr (Patches::averages) {
      if (chunk.is_first()) {
        sum = patches.node_patches.sum(node, sum, [&](const auto& entry) -> Vector {
          const index_t p = NodePatchEntry::element(entry);
          const Scalar change = patches.changes[p].change();
          return detail::patch_gradient<Scalar>(patches.tangent[p], NodePatchEntry::local(entry)) * -change;
        });
      }
    }
    differentials[node].df() = detail::add_corners<Scalar>(chunk, node_tets, corners, node, sum);
  }
};

/// The diagonal block of each node, from its tets and its patches.
template <class NodeTets, class TangentView, class Patches, class NodeStiffnessView>
struct SumNodeTangents {
  using Scalar = typename NodeStiffnessView::Precision;
  NodeTets node_tets;       ///< Rows of NodeTetEntry
  TangentView tangent;      ///< quasistatic::TetTangent
  Patches patches;          ///< NoNodePatches or NodePatchTangents
  NodeStiffnessView nodes;  ///< elasticity::NodeStiffness, written

  PHYSGEN_FUNCTION void operator()(SingleObject auto node) const {
    using Matrix = Matrix3<Scalar>;
    using Vector = Vector3<Scalar>;
    Matrix sum = node_tets.sum(node, Matrix(Matrix::Zero()), [&](const auto& entry) -> Matrix {
      const int corner = NodeTetEntry::local(entry);
      const auto tet = tangent[NodeTetEntry::element(entry)];
      const Matrix U = tet.U(), g = tet.g();
      const detail::DerivativeTables<Scalar> tables(tet);
      Vector own = g.col(0) + g.col(1) + g.col(2);  // its sign plays no part
      if (corner != 0) own = corner == 1 ? g.col(0) : (corner == 2 ? g.col(1) : g.col(2));
      return multiply_transpose<Scalar>(multiply<Scalar>(U, tables.block(-own, own)), U);
    });
    if constexpr (Patches::averages) {
      sum = patches.node_patches.sum(node, sum, [&](const auto& entry) -> Matrix {
        const auto patch = patches.tangent[NodePatchEntry::element(entry)];
        const Vector g = detail::patch_gradient<Scalar>(patch, NodePatchEntry::local(entry));
        const Scalar k = -Scalar(patch.k());
        Matrix block;
        for (int c = 0; c < 3; ++c) block.col(c) = g * (k * g[c]);
        return block;
      });
    }
    nodes[node].K() = Matrix((sum + sum.transpose()) * Scalar(0.5));
  }
};

/// df += K dx from the arrays' tangents, which are those of all tets.
template <class On, class Arrays, class DisplacementView, class DifferentialView>
void add_tangents(On& on, Arrays& a, const DisplacementView& dx, const DifferentialView& df) {
  const auto tets = a.tets.const_view();
  const auto tangent = a.chunk_arrays->tangent.const_view();
  if constexpr (On::Space::kind == SpaceKind::cuda) {
    on.run(a.tet_count(), AddTetDifferentials{tets, tangent, dx, df});
    where(a.patches, [&](auto& p) {
      on.run(a.volumes.size(), AddPatchDifferentials{p.nodes.const_view(), p.tangent.const_view(), dx, df});
    });
  } else {
    const auto sum = [&](const auto& patches) {
      for (const TetChunk& chunk : a.chunks) {
        on.run(chunk.tets(), ComputeTetDifferentials{chunk, tets, tangent, dx, a.chunk_arrays->corners.view()});
        on.run(chunk.nodes(),
               SumDifferentials{chunk, a.node_tets.const_view(), a.chunk_arrays->corners.const_view(), patches, df});
      }
    };
    const auto sum_with = [&](auto& p) {
      const auto tangents = p.tangent.const_view();
      on.run(a.volumes.size(), ComputePatchChanges{p.nodes.const_view(), tangents, dx, p.changes.view()});
      sum(NodePatchChanges{p.node_patches.const_view(), tangents, p.changes.const_view()});
    };
    if (!where(a.patches, sum_with)) sum(NoNodePatches{});
  }
}

/// Does prepare() where nothing is assembled: makes the inverses of nodes' blocks, which are formed and scaled in one
/// array.
template <class On, class Arrays, class Level>
void prepare_nodes(On& on, Arrays& a, Level& level, const PreconditionerSettings& settings) {
  if (!asks_for(settings.kind, asks::inverses)) return;
  const auto node_tets = a.node_tets.const_view();
  const auto tangent = a.chunk_arrays->tangent.const_view();
  const auto blocks = level.node_stiffness.view();
  const auto sum = [&](const auto& patches) {
    on.run(a.nodes(), SumNodeTangents{node_tets, tangent, patches, blocks});
  };
  const auto sum_with = [&](auto& p) { sum(NodePatchTangents{p.node_patches.const_view(), p.tangent.const_view()}); };
  if (!where(a.patches, sum_with)) sum(NoNodePatches{});
  const auto scales = level.scales.view();
  on.run(a.nodes(), ComputeNodeScale{false, level.node_stiffness.const_view(), scales});
  on.run(a.nodes(), ScaleNodes{level.node_stiffness.const_view(), level.constraints.const_view(),
                               level.scales.const_view(), blocks, level.inverse.view()});
}

}  // namespace physgen::fem

#pragma pop_macro("I")
