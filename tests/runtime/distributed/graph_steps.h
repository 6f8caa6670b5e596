// Kernels of graphs that write some objects alone, that ask own rows for no more than their lengths, and that follow
// another one in a fused kernel; and kernels over groups, which all ranks have.
#pragma once

#include <physgen/fuse.h>

#include "graphs.h"

namespace graphs {

template <class PositionView, class ForceView>
struct Clear {
  using Scalar = typename ForceView::Precision;
  PositionView positions;
  ForceView forces;
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    using Vector = Eigen::Matrix<typename ForceView::Precision, 3, 1>;
    if (positions[i].x()[0] < 0) forces[i].f() = Vector(Vector::Zero());
  }
};
template <class... V>
Clear(V...) -> Clear<V...>;

template <class Rows, class PositionView>
struct Degree {
  using Scalar = typename PositionView::Precision;
  Rows ends;
  PositionView positions;
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    const Scalar degree = static_cast<Scalar>(ends.size(i));
    positions[i].x() = (positions[i].x().get() * degree * Scalar(0.0625F)).eval();
  }
};
template <class... V>
Degree(V...) -> Degree<V...>;

/// The first step of a fused kernel. @tparam PullView a local, which has a number among the views, and no memory
template <class ForceView, class PullView>
struct Quarter {
  using Scalar = typename ForceView::Precision;
  ForceView forces;
  PullView pulls;
  template <class I>
  PHYSGEN_FUNCTION void operator()(const I& i) const {
    pulls[i].f() = (forces[i].f().get() * Scalar(0.25F)).eval();
  }
};
template <class... V>
Quarter(V...) -> Quarter<V...>;

/// The second.
template <class PullView, class PositionView>
struct Push {
  using Scalar = typename PositionView::Precision;
  PullView pulls;
  PositionView positions;
  template <class I>
  PHYSGEN_FUNCTION void operator()(const I& i) const {
    positions[i].x() = (positions[i].x().get() * Scalar(0.5F) + pulls[i].f().get()).eval();
  }
};
template <class... V>
Push(V...) -> Push<V...>;

/// Over groups, from nodes and edges of which ranks have parts, and from other groups.
template <class Rows, class PositionView, class SpringView, class LinkView, class CalmView, class TotalView>
struct Collect {
  using Scalar = typename TotalView::Precision;
  Rows members;
  PositionView positions;
  SpringView springs;
  LinkView links;
  CalmView calms;
  TotalView totals;
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    using Vector = Eigen::Matrix<Scalar, 3, 1>;
    const Vector calm = calms[links[i].nodes()[0]].dx();
    Vector sum = totals[i].f().get() * Scalar(0.5F) + calm * Scalar(0.25F);
    members.for_each(i, [&](const auto& member, bool) {
      const index_t other = member.element();
      Vector value;
      if (member.local() == 1)
        value = positions[other].x();
      else
        value = springs[other].f();
      sum += value * Scalar(0.125F);
    });
    totals[i].f() = sum;
  }
};
template <class... V>
Collect(V...) -> Collect<V...>;

/// Over nodes, from groups.
template <class HomeView, class TotalView, class MeanView>
struct Spread {
  using Scalar = typename MeanView::Precision;
  HomeView homes;
  TotalView totals;
  MeanView means;
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    const auto names = homes[i].nodes().get();
    means[i].dx() =
        (means[i].dx().get() * 0.5F + totals[names[0]].f().get() * 0.25F + totals[names[1]].f().get() * 0.125F).eval();
  }
};
template <class... V>
Spread(V...) -> Spread<V...>;

/// Over groups, from groups: all ranks do the same.
template <class LinkView, class TotalView, class CalmView>
struct Settle {
  using Scalar = typename CalmView::Precision;
  LinkView links;
  TotalView totals;
  CalmView calms;
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    const auto names = links[i].nodes().get();
    calms[i].dx() = (calms[i].dx().get() * 0.5F + totals[names[1]].f().get() * 0.25F).eval();
  }
};
template <class... V>
Settle(V...) -> Settle<V...>;

/// Over groups: asks rows for their lengths alone, of which a rank has those of the groups that it computes.
template <class Rows, class TotalView>
struct Members {
  using Scalar = typename TotalView::Precision;
  Rows members;
  TotalView totals;
  PHYSGEN_FUNCTION void operator()(index_t i) const {
    totals[i].f() = (totals[i].f().get() * (static_cast<Scalar>(members.size(i)) * Scalar(0.125F))).eval();
  }
};
template <class... V>
Members(V...) -> Members<V...>;

/// Does what a kernel would, with a loop of its own: for what is here.
template <class Space, class Kernel>
struct AtOnce {
  Kernel kernel;
  index_t count;
  void operator()(Stream stream) const {
    if constexpr (std::is_same_v<Space, Host>) {
      for (index_t i = count - 1; i >= 0; --i) kernel(i);
    } else {
      parallel_for(Space{}, count, kernel, stream);
    }
  }
};
template <class On, class Kernel>
void sum_at_once(On& on, index_t nodes, const Kernel& kernel) {
  const AtOnce<typename On::Space, Kernel> work{kernel, nodes};
  if constexpr (requires { on.perform(work, kernel, nodes); }) {
    on.perform(work, kernel, nodes);
  } else {
    on.perform(work);
  }
}
/// With what all ranks have.
template <class On, class Kernel>
void do_on_each(On& on, index_t count, const Kernel& kernel) {
  const AtOnce<typename On::Space, Kernel> work{kernel, count};
  if constexpr (requires { on.perform_on_each(work, kernel); }) {
    on.perform_on_each(work, kernel);
  } else {
    on.perform(work);
  }
}

}  // namespace graphs
