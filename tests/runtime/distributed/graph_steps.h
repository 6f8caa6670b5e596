// Kernels of graphs that write some objects alone, that ask own rows for no more than their lengths, and that follow
// another one in a fused kernel.
#pragma once

#include <physgen/fuse.h>

#include "graphs.h"

namespace graphs {

template <class PositionView, class ForceView>
struct Clear {
  using Scalar = typename ForceView::Precision;
  PositionView positions;
  ForceView forces;
  void operator()(index_t i) const {
    using Vector = Eigen::Matrix<typename ForceView::Precision, 3, 1>;
    if (positions[i].x()[0] < 0) forces[i].f() = Vector(Vector::Zero());
  }
};
template <class... V>
Clear(V...) -> Clear<V...>;

template <class Rows, class MeanView>
struct Degree {
  using Scalar = typename MeanView::Precision;
  Rows ends;
  MeanView means;
  void operator()(index_t i) const {
    using Vector = Eigen::Matrix<typename MeanView::Precision, 3, 1>;
    means[i].dx() = Vector(Vector::Constant(static_cast<typename MeanView::Precision>(ends.size(i))));
  }
};
template <class... V>
Degree(V...) -> Degree<V...>;

/// The first step of a fused kernel. @tparam PullView a local, which has a number among the views, and no memory
template <class ForceView, class PullView>
struct Square {
  using Scalar = typename ForceView::Precision;
  ForceView forces;
  PullView pulls;
  template <class I>
  void operator()(const I& i) const {
    const auto f = forces[i].f().get();
    pulls[i].f() = f.cwiseProduct(f).eval();
  }
};
template <class... V>
Square(V...) -> Square<V...>;

/// The second.
template <class PullView, class MeanView>
struct Halve {
  using Scalar = typename MeanView::Precision;
  PullView pulls;
  MeanView means;
  template <class I>
  void operator()(const I& i) const {
    means[i].dx() = (pulls[i].f().get() * Scalar(0.5F)).eval();
  }
};
template <class... V>
Halve(V...) -> Halve<V...>;

}  // namespace graphs
