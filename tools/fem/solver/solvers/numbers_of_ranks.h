// What solvers on several ranks hand out and take: numbers of all objects on the first rank, and those of objects that
// are here; and what they tell of their parts.
#pragma once

#include <elasticity.physgen.h>
#include <fem/solver/loads/loading_arrays.h>
#include <fem/solver/solvers/solver_on_ranks.h>
#include <physgen/distributed/arrays.h>
#include <physgen/distributed/transport.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace physgen::fem {

/// Numbers of all objects, by blocks of them, on the first rank; none on others. @pre no step is under way
/// @param element element(object, k) is number k of an object
template <std::size_t kCount, class Array, class Element>
[[nodiscard]] std::vector<std::array<double, kCount>> of_all_ranks(DistributedArrays& arrays, const Array& array,
                                                                   const Element& element) {
  std::vector<std::array<double, kCount>> all;
  arrays.each_block(array, [&](index_t first, const auto& view) {
    if (first == 0) all.reserve(static_cast<std::size_t>(arrays.objects_of(array).runs().size()));
    for (index_t i = 0; i < view.size(); ++i) {
      std::array<double, kCount>& numbers = all.emplace_back();
      for (std::size_t k = 0; k < kCount; ++k) numbers[k] = element(view[i], static_cast<int>(k));
    }
  });
  return all;
}

/// Gives each rank the vectors of its objects, by local numbers. @param all of all objects, on the first rank alone
[[nodiscard]] inline std::vector<Point> of_first_rank(const DistributedArrays& arrays, const LocalSet& objects,
                                                      std::span<const Point> all) {
  constexpr index_t most = (index_t{64} << 20) / index_t{sizeof(Point)};
  Transport& transport = arrays.transport();
  std::vector<Point> here(static_cast<std::size_t>(objects.size())), window;
  index_t local = objects.first();
  for (index_t first = 0; first < objects.runs().size(); first += most) {
    const index_t last = std::min(first + most, objects.runs().size());
    window.resize(static_cast<std::size_t>(last - first));
    std::vector<index_t> sizes(static_cast<std::size_t>(transport.count()), 0);
    sizes.front() = static_cast<index_t>(std::as_bytes(std::span(window)).size());
    const auto given = all.empty() ? all : all.subspan(static_cast<std::size_t>(first), window.size());
    transport.gather(std::as_bytes(given), sizes, std::as_writable_bytes(std::span(window)));
    for (; local < objects.last() && objects.global(local) < last; ++local) {
      here[static_cast<std::size_t>(local)] = window[static_cast<std::size_t>(objects.global(local) - first)];
    }
  }
  return here;
}

/// Fills an array of vectors of nodes with those of all nodes that the first rank has.
/// @param all on other ranks it counts for nothing @param component component(value, k) is number k of a node's vector
template <class Array, class Component>
void fill_from_first_rank(DistributedArrays& arrays, Array& array, std::span<const Point> all,
                          const Component& component) {
  const LocalSet& objects = arrays.objects_of(array);
  const std::vector<Point> here =
      of_first_rank(arrays, objects, arrays.ranks().is_first() ? all : std::span<const Point>());
  arrays.fill(array, [&](index_t node) {
    typename Array::Value value{};
    const Point& vector = here[static_cast<std::size_t>(objects.local(node))];
    for (int k = 0; k < 3; ++k) {
      auto& number = component(value, k);
      number = static_cast<std::remove_cvref_t<decltype(number)>>(vector[static_cast<std::size_t>(k)]);
    }
    return value;
  });
}

/// Fills the motion and the forces of nodes, as store_loading() does. @param fixed, moved, forces of all nodes
template <class Motion, class Loads>
void fill_loading(DistributedArrays& arrays, Motion& motion, Loads& loads, std::span<const std::uint8_t> fixed,
                  const std::vector<Point>& moved, const std::vector<Point>& forces) {
  struct {
    elasticity::NodeDisplacementArray<double> motion;
    elasticity::NodeForceArray<double> loads;
  } all{elasticity::NodeDisplacementArray<double>(static_cast<index_t>(fixed.size())),
        elasticity::NodeForceArray<double>(static_cast<index_t>(fixed.size()))};
  store_loading(all, fixed, moved, forces);
  arrays.fill(motion.contents(), all.motion);
  arrays.fill(loads.contents(), all.loads);
}

/// Counts what this rank has of a mesh. @param nodes, tets the sets of the mesh
[[nodiscard]] inline PartOfMesh part_of(const LocalSet& nodes, const LocalSet& tets) {
  const auto ghosts = [](const LocalSet& set) { return static_cast<index_t>(set.ghosts().size()); };
  std::set<int> neighbours;
  for (const index_t ghost : nodes.ghosts()) neighbours.insert(nodes.runs().owner(ghost));
  return {nodes.owned(), ghosts(nodes), tets.owned(), ghosts(tets), static_cast<int>(neighbours.size())};
}

/// What an iteration of a linear solver sends.
/// @param forces of nodes, which are filled with others @param solve solve(count) solves for them, by so many
/// iterations
template <class On, class Forces, class Solve>
[[nodiscard]] Traffic traffic_of_iteration(On& on, DistributedArrays& arrays, Forces& forces, const Solve& solve) {
  const auto of_iterations = [&](int count) {
    arrays.fill(forces, [](index_t node) {  // any that are not 0
      typename std::remove_cvref_t<Forces>::Value value{};
      for (int k = 0; k < 3; ++k) value.f[k] = 1 + static_cast<double>((3 * node + k) % 7);
      return value;
    });
    const Traffic before = on.traffic();
    solve(count);
    on.wait();
    return on.traffic() - before;
  };
  (void)of_iterations(2);  // fields cross more than once before ranks know what all steps read
  const Traffic two = of_iterations(2);
  return of_iterations(3) - two;
}

template <class On>
[[nodiscard]] std::vector<std::string> unknown_kernels_of(const On& on) {
  return {on.unknown_kernels().begin(), on.unknown_kernels().end()};
}
/// The name of what messages go by.
template <class On>
[[nodiscard]] std::string transport_of(const On& on) {
  if constexpr (requires { on.transport_name(); }) return on.transport_name();
  return "MPI";
}

}  // namespace physgen::fem
