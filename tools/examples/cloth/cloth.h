// The sheet as arrays, and an implicit step of it.
#pragma once

#include <physgen/parallel_for.h>
#include <physgen/parallel_reduce.h>
#include <physgen/row_arrays.h>

#include <vector>

#include "kernels.h"
#include "setting.h"

namespace sheet {

using Touches = RowArrays<RangeArray<double>, TouchArray<double>>;

inline Touches rows_of(const Setting& setting) {
  std::vector<Touch<double>> entries;
  for (const std::int32_t spring : setting.touches) {
    Touch<double> touch{};
    touch.spring = spring;
    entries.push_back(touch);
  }
  return Touches::from_offsets({"spring", static_cast<index_t>(setting.springs.size())}, setting.first, entries);
}

/// The sheet that a setting describes, as arrays.
struct Sheet {
  NodeArray<double> nodes;
  SearchArray<double> search;
  SpringArray<double> springs;
  Touches touches;
  double h, gravity, tolerance;
  int most_iterations;

  explicit Sheet(const Setting& setting)
      : nodes(static_cast<index_t>(setting.positions.size())),
        search(nodes.size()),
        springs(static_cast<index_t>(setting.springs.size())),
        touches(rows_of(setting)),
        h(setting.step),
        gravity(setting.gravity),
        tolerance(setting.tolerance),
        most_iterations(setting.most_iterations) {
    for (index_t i = 0; i < nodes.size(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      nodes[i].x() = Eigen::Vector3d(setting.positions[at].data());
      nodes[i].m() = setting.masses[at];
      nodes[i].free() = setting.free[at];
    }
    for (index_t k = 0; k < springs.size(); ++k) {
      const Link& link = setting.springs[static_cast<std::size_t>(k)];
      springs[k].ends() = Eigen::Vector2i(link.ends.data());
      springs[k].length() = link.length;
      springs[k].stiffness() = link.stiffness;
    }
  }

  /// Forces of all springs and their derivatives. @tparam kLanes as of lanes(); 0: the library's choice
  template <int kLanes = 0>
  void compute_springs() {
    parallel_for(Host{}, springs.size(), lanes<kLanes>(ComputeSprings{springs.view(), nodes.const_view()}));
  }

  /// Conjugate gradients for the change of velocities, and the step. @return iterations
  template <int kLanes = 0>
  int solve_and_move() {
    const index_t n = nodes.size();
    const auto rows = touches.const_view();
    const auto pulls = springs.const_view();
    const auto all = nodes.const_view();
    const auto s = search.view();
    double square = parallel_reduce(Host{}, n, lanes<kLanes>(BeginSearch{rows, pulls, all, s, h, gravity}), Sum{});
    const double enough = tolerance * tolerance * square;
    int iterations = 0;
    for (; iterations < most_iterations && square > enough; ++iterations) {
      const double product = parallel_reduce(Host{}, n, lanes<kLanes>(Multiply{rows, pulls, all, s, h}), Sum{});
      const double next = parallel_reduce(Host{}, n, lanes<kLanes>(Step{s, square / product}), Sum{});
      parallel_for(Host{}, n, lanes<kLanes>(Turn{s, next / square}));
      square = next;
    }
    parallel_for(Host{}, n, lanes<kLanes>(Move{nodes.view(), search.const_view(), h}));
    return iterations;
  }
};

}  // namespace sheet
