// Blocks of the Schwarz preconditioner on the CPU: a thread takes a block.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <fem/solver/performs_in.h>
#include <fem/solver/preconditioners/schwarz/schwarz.h>
#include <physgen/executor.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <vector>

namespace physgen::fem {

namespace detail {

/// Makes the factor of one block. Where a pivot is not positive beyond rounding, that of its nodes' own 3x3 blocks
/// alone (block Jacobi), from which a component with such a pivot is left out.
template <class Stiffness, class Edges, class SlotView, class BlockView, class FactorView>
struct FactorBlock {
  using Scalar = typename Stiffness::Scalar;
  using Dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  using Roots = std::array<Scalar, schwarz_size>;
  index_t first;  ///< block
  Stiffness stiffness;
  Edges edges;         ///< Rows of quasistatic::SchwarzPair
  SlotView slots;      ///< quasistatic::SchwarzSlot
  BlockView blocks;    ///< quasistatic::SchwarzBlock
  FactorView factors;  ///< quasistatic::SchwarzFactor, written

  void operator()(index_t i) const {
    const index_t block = first + i;
    Dense A(schwarz_size, schwarz_size);
    Roots roots;
    if (!eliminate(block, true, A, roots)) eliminate(block, false, A, roots);
    const Scalar scale = factor_scale(*std::ranges::max_element(roots));
    blocks[block].scale() = scale;
    const auto at = [&](int r, int c) { return A(r, c); };
    for (int k = 0; k < schwarz_factors; ++k) {
      factors[schwarz_factors * block + k].W() =
          factor_block<Scalar>(k / schwarz_slots, k % schwarz_slots, roots.data(), scale, at);
    }
  }

 private:
  /// Leaves L^-1 below the diagonal of A, and 1 / sqrt(pivot), or 0 where a component is left out.
  /// @return whether all pivots of a block with its edges are positive
  bool eliminate(index_t block, bool with_edges, Dense& A, Roots& roots) const {
    Roots least;
    least.fill(Scalar(-1));
    A.setZero();
    for (int k = 0; k < schwarz_slots; ++k) {
      const index_t source = slots[schwarz_slots * block + k].source();
      if (source < 0) continue;
      A.template block<3, 3>(3 * k, 3 * k) = -stiffness.node(source);
      const Vector3<Scalar> magnitude = stiffness.magnitude(source);
      for (int c = 0; c < 3; ++c) least[std::size_t(3 * k + c)] = least_pivot<Scalar>(magnitude[c]);
    }
    if (with_edges) {
      edges.for_each(block, [&](const auto& pair, bool /*active*/) {
        const int places = pair.places(), m = 3 * (places % schwarz_slots), n = 3 * (places / schwarz_slots);
        const Matrix3<Scalar> E = -stiffness.edge(pair.edge());
        A.template block<3, 3>(m, n) = E;
        A.template block<3, 3>(n, m) = E.transpose();
      });
    }
    for (int p = 0; p < schwarz_size; ++p) {
      const Scalar pivot = A(p, p), bound = least[std::size_t(p)];
      const bool kept = bound >= 0 && pivot > bound;
      if (!kept && bound >= 0 && with_edges) return false;
      roots[std::size_t(p)] = kept ? 1 / std::sqrt(pivot) : Scalar(0);
      for (int r = p + 1; r < schwarz_size; ++r) {
        const Scalar factor = kept ? A(r, p) / pivot : Scalar(0);
        if (factor != 0) A.row(r).noalias() -= factor * A.row(p);
        A(r, p) = -factor;
      }
    }
    return true;
  }
};

/// z = W^T W r of one block, and the sums of r over its supernodes.
template <class Product>
struct ApplyBlock {
  using Scalar = typename Product::Scalar;
  Product product;
  index_t first;  ///< block

  void operator()(index_t i) const {
    const index_t block = first + i;
    const bool of_nodes = block < product.node_blocks;
    std::array<Vector, 3> r{}, y{}, z{};
    gather(block, of_nodes, r);
    const Scalar scale = product.blocks[block].scale();
    for (auto& row : r) {
      for (Scalar& number : row) number *= scale;
    }
    std::array<std::array<Vector, 9>, 17> W;
    for (int k = 0; k < schwarz_factors; ++k) {
      const Matrix3<Scalar> part = product.factors[schwarz_factors * block + k].W();
      for (int n = 0; n < 9; ++n) W[std::size_t(k / slots)][std::size_t(n)][std::size_t(k % slots)] = part.data()[n];
    }
    // Row minus column of diagonal d's first 32 - d blocks is d, of the others d - 32.
    for (int d = 0; d <= slots / 2; ++d) {
      multiply(W[std::size_t(d)], 0, slots - d, r, 0, y, d);
      if (d > 0 && 2 * d < slots) multiply(W[std::size_t(d)], slots - d, slots, r, d - slots, y, 0);
    }
    for (int d = 0; d <= slots / 2; ++d) {
      multiply_transpose(W[std::size_t(d)], 0, slots - d, y, d, z, 0);
      if (d > 0 && 2 * d < slots) multiply_transpose(W[std::size_t(d)], slots - d, slots, y, 0, z, d - slots);
    }
    for (int k = 0; k < slots; ++k) {
      const index_t source = product.slots[slots * block + k].source();
      if (source < 0) continue;
      const auto s = std::size_t(k);
      const Vector3<Scalar> dx(z[0][s] * scale, z[1][s] * scale, z[2][s] * scale);
      if (of_nodes) {
        product.corrections[source].dx() = dx;
      } else {
        product.supernode_corrections[source].dx() = dx;
      }
    }
  }

 private:
  static constexpr int slots = schwarz_slots;
  using Vector = std::array<Scalar, slots>;

  void gather(index_t block, bool of_nodes, std::array<Vector, 3>& r) const {
    Vector3<Scalar> sum = Vector3<Scalar>::Zero();
    for (int k = 0; k < slots; ++k) {  // slots of a supernode lie side by side
      const auto slot = product.slots[slots * block + k];
      const index_t source = slot.source(), parent = slot.parent();
      if (source < 0) break;
      Vector3<Scalar> own;
      if (of_nodes) {
        own = product.residual[source].df();
      } else {
        own = product.supernode_residual[source].df();
      }
      for (int c = 0; c < 3; ++c) r[std::size_t(c)][std::size_t(k)] = own[c];
      if (parent < 0) continue;
      const bool begins = k == 0 || index_t{product.slots[slots * block + k - 1].parent()} != parent;
      sum = begins ? own : Vector3<Scalar>(sum + own);
      product.supernode_residual[parent].df() = sum;
    }
  }
  /// y[i + to] += W[i] r[i + from], i = begin .. end - 1
  static void multiply(const std::array<Vector, 9>& W, int begin, int end, const std::array<Vector, 3>& r, int from,
                       std::array<Vector, 3>& y, int to) {
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t row = 0; row < 3; ++row) {
        const Scalar *w = W[3 * c + row].data(), *x = r[c].data() + from;
        Scalar* out = y[row].data() + to;
        for (int i = begin; i < end; ++i) out[i] += w[i] * x[i];
      }
    }
  }
  /// z[i + to] += W[i]^T y[i + from], i = begin .. end - 1
  static void multiply_transpose(const std::array<Vector, 9>& W, int begin, int end, const std::array<Vector, 3>& y,
                                 int from, std::array<Vector, 3>& z, int to) {
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t row = 0; row < 3; ++row) {
        const Scalar *w = W[3 * c + row].data(), *x = y[row].data() + from;
        Scalar* out = z[c].data() + to;
        for (int i = begin; i < end; ++i) out[i] += w[i] * x[i];
      }
    }
  }
};

}  // namespace detail

/// Makes the factors of the blocks begin .. end-1, from the stiffness of what stands in them.
template <PerformsIn<Host> On, class Stiffness, class Arrays>
void factor_blocks(On& on, index_t begin, index_t end, const Stiffness& stiffness, Arrays& arrays) {
  on.run(end - begin, detail::FactorBlock{begin, stiffness, arrays.block_edges.const_view(), arrays.slots.const_view(),
                                          arrays.blocks.view(), arrays.factors.view()});
}

/// z of all blocks, level after level.
template <PerformsIn<Host> On, class... Views>
void apply_blocks(On& on, const SchwarzProduct<Views...>& product, const std::vector<Index>& first_block) {
  for (std::size_t l = 0; l + 1 < first_block.size(); ++l) {
    on.run(first_block[l + 1] - first_block[l],
           detail::ApplyBlock<SchwarzProduct<Views...>>{product, index_t{first_block[l]}});
  }
}

}  // namespace physgen::fem

#pragma pop_macro("I")
