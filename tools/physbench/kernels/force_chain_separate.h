// Leads from positions to the forces on nodes by five separate kernels, each of which stores what the next one reads: a
// kernel that does it at once is compared with these.
#pragma once

#include <tuple>

#include "kernels/gather_forces.h"

namespace physgen::bench {

/// A kernel of a chain, and the objects that it runs over.
template <class Kernel>
struct Link {
  index_t objects;
  Kernel kernel;
};
template <class Kernel>
Link<Kernel> link(index_t objects, const Kernel& kernel) {
  return {objects, kernel};
}

/// Kernels that run one after another.
template <class... Kernel>
struct Chain {
  std::tuple<Link<Kernel>...> links;
  /// Calls run(objects, kernel) for each.
  template <class Run>
  void launch(const Run& run) const {
    std::apply([&run](const auto&... link) { (run(link.objects, link.kernel), ...); }, links);
  }
};
template <class... Kernel>
Chain<Kernel...> chain(const Link<Kernel>&... links) {
  return {std::tuple<Link<Kernel>...>(links...)};
}

struct ForceChainSeparate {
  static constexpr const char* name = "force_chain_separate";
  static constexpr int place = 12;
  static constexpr bool few_layouts = true;  ///< AoS and the schema's tiles: its kernels have rows of their own
  static constexpr Domain domain = Domain::nodes;
  using Output = elasticity::NodeForceObject;
  using Reads = Operands<Streamed<source::Tets>, Gathered<source::Positions>, Streamed<source::RestShapes>,
                         Gathered<source::Ranges<Domain::nodes, Domain::node_tets>, Aos>,
                         Gathered<source::Entries<Domain::node_tets>, Aos>>;
  using Writes =
      Operands<Streamed<source::Of<DeformationGradient::Output, Domain::tets>>,
               Streamed<source::Of<Svd::Output, Domain::tets>>, Streamed<source::Of<Stress::Output, Domain::tets>>,
               Streamed<source::Of<ElasticForce::Output, Domain::tets>>, Gathered<source::Of<Output, domain>>>;
  template <class Real, class Tet, class Position, class Rest, class Range, class Entry, class F, class S, class P,
            class G, class Force>
  static auto run(const Tet& tets, const Position& positions, const Rest& rest, const Range& ranges,
                  const Entry& entries, const F& gradients, const S& svds, const P& stresses, const G& corners,
                  const Force& forces) {
    const index_t n = gradients.size();
    return chain(link(n, fem::ComputeDeformationGradient{tets, positions, rest, gradients}),
                 link(n, fem::ComputeSvd{gradients, svds, fem::Sweeps<4>{}}),
                 link(n, fem::ComputeStress{material<Real>(), svds, stresses}),
                 link(n, fem::ComputeCornerForces{rest, stresses, corners}),
                 link(forces.size(), fem::GatherForces{Rows{ranges, entries, n}, corners, forces}));
  }

  template <class T, class Real>
  static elasticity::NodeForce<T> naive(index_t i, const auto& tets, const auto& positions, const auto& rest,
                                        const auto& ranges, const auto& entries) {
    Vector3<T> sum = Vector3<T>::Zero();
    for (index_t k = ranges[i].begin; k < ranges[i].end; ++k) {
      const index_t t = entries[k].element;
      const Matrix3<T> F = DeformationGradient::naive<T, Real>(t, tets, positions, rest).F;
      const Matrix3<T> P = formula::stress<T, Real>(formula::svd<T>(F));
      sum += formula::force_on<T>(elasticity::CornerForces<T>{formula::corner_forces<T>(rest[t], P)}, entries[k].local);
    }
    return {sum};
  }
  template <class T>
  static Vector3<T> observe(const auto& value) {
    return value.f.template cast<T>();
  }
};

PHYSGEN_BENCH_ROWS(ForceChainSeparate, OnScene);

}  // namespace physgen::bench
