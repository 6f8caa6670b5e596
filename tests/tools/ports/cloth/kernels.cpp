// The program as a user of the library writes it.
#include "kernels.h"

#include <physgen/parallel_for.h>
#include <physgen/parallel_reduce.h>
#include <physgen/row_arrays.h>

#include "../report.h"
#include "runs.h"

namespace sheet {

namespace {

using Touches = RowArrays<RangeArray<double>, TouchArray<double>>;

Touches rows_of(const Setting& setting) {
  std::vector<Touch<double>> entries;
  for (const std::int32_t spring : setting.touches) {
    Touch<double> touch{};
    touch.spring = spring;
    entries.push_back(touch);
  }
  return Touches::from_offsets({"spring", static_cast<index_t>(setting.springs.size())}, setting.first, entries);
}

template <int kLanes>
Result run(const Setting& setting, int steps) {
  const auto n = static_cast<index_t>(setting.positions.size());
  NodeArray<double> node_array(n);
  SearchArray<double> search_array(n);
  SpringArray<double> spring_array(static_cast<index_t>(setting.springs.size()));
  const Touches rows = rows_of(setting);
  const auto nodes = node_array.view();
  const auto search = search_array.view();
  const auto springs = spring_array.view();
  const auto touches = rows.view();
  for (index_t i = 0; i < n; ++i) {
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
  const double h = setting.step;
  Result result;
  for (int step = 0; step < steps; ++step) {
    result.spring_seconds += ports::seconds_of(
        [&] { parallel_for(Host{}, springs.size(), lanes<kLanes>(ComputeSprings{springs, node_array.const_view()})); });
    result.search_seconds += ports::seconds_of([&] {
      const auto pulls = spring_array.const_view();
      const auto all = node_array.const_view();
      double square = parallel_reduce(
          Host{}, n, lanes<kLanes>(BeginSearch{touches, pulls, all, search, h, setting.gravity}), Sum{});
      const double enough = setting.tolerance * setting.tolerance * square;
      for (int k = 0; k < setting.most_iterations && square > enough; ++k) {
        const double product =
            parallel_reduce(Host{}, n, lanes<kLanes>(Multiply{touches, pulls, all, search, h}), Sum{});
        const double next = parallel_reduce(Host{}, n, lanes<kLanes>(Step{search, square / product}), Sum{});
        parallel_for(Host{}, n, lanes<kLanes>(Turn{search, next / square}));
        square = next;
        ++result.iterations;
      }
      parallel_for(Host{}, n, lanes<kLanes>(Move{nodes, search_array.const_view(), h}));
    });
  }
  for (index_t i = 0; i < n; ++i) {
    const Eigen::Vector3d x = nodes[i].x();
    result.positions.push_back({x[0], x[1], x[2]});
  }
  return result;
}

}  // namespace

Result run_kernels(const Setting& setting, int steps, bool one_lane) {
  return one_lane ? run<1>(setting, steps) : run<0>(setting, steps);
}

}  // namespace sheet
