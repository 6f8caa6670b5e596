// The block of each edge: the sum over its tets.
#pragma once

#include "kernels/gather_forces.h"
#include "kernels/tet_stiffness.h"

namespace physgen::bench {

struct EdgeStiffness {
  static constexpr const char* name = "edge_stiffness";
  static constexpr int place = 10;
  static constexpr Domain domain = Domain::edges;
  using Output = elasticity::EdgeStiffnessObject;
  using Reads = Operands<Gathered<source::Ranges<Domain::edges, Domain::edge_tets>, Aos>,
                         Gathered<source::Entries<Domain::edge_tets>, Aos>, Streamed<OutputOf<TetStiffness>>>;
  using Writes = Operands<Streamed<source::Of<Output, domain>>>;
  template <class Real>
  static auto run(const auto& ranges, const auto& entries, const auto& tets, const auto& out) {
    return fem::GatherEdgeStiffness{Rows{ranges, entries, tets.size()}, tets, out};
  }

  template <class T, class Real>
  static elasticity::EdgeStiffness<T> naive(index_t i, const auto& ranges, const auto& entries, const auto& stiffness) {
    Matrix3<T> sum = Matrix3<T>::Zero();
    for (index_t k = ranges[i].begin; k < ranges[i].end; ++k) {
      const auto local = static_cast<std::size_t>(entries[k].local);
      const Matrix3<T> block = stiffness[entries[k].element].e[local % 6].template cast<T>();
      sum += local < 6 ? block : Matrix3<T>(block.transpose());
    }
    return {sum};
  }
  template <class T>
  static Matrix3<T> observe(const auto& value) {
    return value.E.template cast<T>();
  }
};

PHYSGEN_BENCH_ROWS(EdgeStiffness, OnScene);

}  // namespace physgen::bench
