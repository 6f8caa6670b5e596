// Leads from positions to the forces on nodes: by five separate kernels, each of which stores what the next one reads,
// by the program in which physgen has joined four of them, and by kernels that are fused by hand.
#pragma once

#include <fem/kernels/groups.h>
#include <force_chain.program.h>

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

/// By one kernel over the tets, which adds to the nodes. The order of sums is open.
/// Rows of nodes are read by the reference alone.
struct ForceChainFused : ForceChainSeparate {
  static constexpr const char* name = "force_chain_fused";
  static constexpr int place = 13;
  using Writes = Operands<Gathered<source::Of<Output, domain>>>;
  template <class Real>
  static auto run(const auto& tets, const auto& positions, const auto& rest, const auto& /*ranges*/,
                  const auto& /*entries*/, const auto& forces) {
    return chain(link(forces.size(), fem::ClearNodes{forces}),
                 link(tets.size(), fem::fuse_added_forces(material<Real>(), tets, positions, rest, forces)));
  }
};

/// A view in the place of an array of a scene's program.
template <class View>
struct ArrayOfView {
  View of;
  [[nodiscard]] const View& view() const { return of; }
  [[nodiscard]] const View& const_view() const { return of; }
  [[nodiscard]] index_t size() const { return of.size(); }
};

/// In the place of an executor: hands each step of a program to `call(objects, kernel)`.
template <class Call>
struct CallForEachStep {
  const Call& call;
  template <class Kernel>
  void run(index_t objects, const Kernel& kernel) const {
    call(objects, kernel);
  }
};

/// The program that physgen writes from the scene force_chain, over arrays of a row. Those that are local to its joined
/// step are the scene's.
template <class Tet, class Position, class Rest, class Range, class Entry, class Corner, class Force>
struct JoinedForceChain {
  using Real = typename Force::Precision;
  using Scene = scenes::force_chain_scene::Body<typename Force::Space, Real>;
  fem::LameParameters lame;
  ArrayOfView<Tet> tets;
  ArrayOfView<Position> positions;
  ArrayOfView<Rest> rest;
  ArrayOfView<Range> node_ranges;
  ArrayOfView<Entry> node_tets;
  ArrayOfView<Corner> corner_forces;
  ArrayOfView<Force> forces;
  decltype(Scene::gradients) gradients{};
  decltype(Scene::svds) svds{};
  decltype(Scene::stresses) stresses{};

  /// Calls run(objects, kernel) for each step.
  template <class Run>
  void launch(const Run& run) const {
    const CallForEachStep<Run> on{run};
    scenes::force_chain_scene::fused::program(on, *this, lame);
  }
};

/// By the scene force_chain: corner forces are stored, and gathered by another kernel, which is fastest on a CPU. The
/// order of sums is that of the separate kernels.
struct ForceChainFusedGathered : ForceChainSeparate {
  static constexpr const char* name = "force_chain_fused_gathered";
  static constexpr int place = 19;
  static constexpr bool is_program = true;
  using Writes =
      Operands<Streamed<source::Of<ElasticForce::Output, Domain::tets>>, Gathered<source::Of<Output, domain>>>;
  template <class Real, class... View>
  static auto run(const View&... view) {
    return JoinedForceChain<View...>{fem::lame_parameters(youngs_modulus, poissons_ratio, "Neo-Hookean"),
                                     ArrayOfView{view}...};
  }
};

/// In a fixed order: a kernel over the tets stores what they do at their corners in the rows of nodes, and one over the
/// nodes sums the rows.
/// Entries of rows are read by the reference alone.
struct ForceChainFusedFixedOrder : ForceChainSeparate {
  static constexpr const char* name = "force_chain_fused_fixed_order";
  static constexpr int place = 14;
  using Reads = Operands<Streamed<source::Tets>, Gathered<source::Positions>, Streamed<source::RestShapes>,
                         Gathered<source::Ranges<Domain::nodes, Domain::node_tets>, Aos>,
                         Gathered<source::Entries<Domain::node_tets>, Aos>, Streamed<source::TetPlaces>>;
  using Writes = Operands<Gathered<source::Of<elasticity::PlacedForceObject, Domain::node_tets>>,
                          Gathered<source::Of<Output, domain>>>;
  template <class Real>
  static auto run(const auto& tets, const auto& positions, const auto& rest, const auto& ranges,
                  const auto& /*entries*/, const auto& places, const auto& placed, const auto& forces) {
    const fem::SumRowForces sum{ranges, placed, forces};
    return chain(link(tets.size(), fem::fuse_placed_forces(material<Real>(), tets, positions, rest, places, placed)),
                 link(sum.size(), sum));
  }

  template <class T, class Real>
  static elasticity::NodeForce<T> naive(index_t i, const auto& tets, const auto& positions, const auto& rest,
                                        const auto& ranges, const auto& entries, const auto& /*places*/) {
    return ForceChainSeparate::naive<T, Real>(i, tets, positions, rest, ranges, entries);
  }
};

PHYSGEN_BENCH_ROWS(ForceChainSeparate, OnScene);
PHYSGEN_BENCH_ROWS(ForceChainFused, OnScene);
PHYSGEN_BENCH_ROWS(ForceChainFusedGathered, OnScene);
PHYSGEN_BENCH_ROWS(ForceChainFusedFixedOrder, OnScene);

}  // namespace physgen::bench
