// What a preconditioner is: a struct of static functions, over an executor and levels by name.
//
//   struct Example {
//     template <class Level>
//     static void make_arrays(Level& level, const LevelGraph& graph, const std::vector<Point>& rest);
//     template <class Extra>
//     static PreconditionerBytes bytes(std::int64_t nodes, std::int64_t edges);
//     template <class On, class Levels>
//     static void prepare(On& on, Levels& levels, std::size_t top, const PreconditionerSettings& settings, bool fresh);
//     template <class On, class Levels>
//     static void apply(On& on, Levels& levels, std::size_t top, const PreconditionerSettings& settings);
//   };
//
// make_arrays() makes what it has beside a level's arrays, level.extra, on each level on which equilibrium is solved;
// `rest` are the positions of the nodes. bytes() forecasts that; Extra is the type of *level.extra, or NoArrays.
//
// prepare() makes all that depends on the stiffness of level `top`, which is given, and leaves the scales in
// levels[top]->scales; `fresh` says whether power iterations and their like begin anew. apply() is z = M r:
// levels[top]->correction from levels[top]->residual, both scaled. It may overwrite r.
#pragma once

#include <fem/solver/hierarchy/hierarchy.h>
#include <fem/solver/settings.h>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace physgen::fem {

/// A forecast from the numbers of a level's nodes and edges; from above where the lists of a mesh decide.
struct PreconditionerBytes {
  std::int64_t device = 0;  ///< of its arrays, in the memory of the device
  std::int64_t lists = 0;   ///< in the host's memory while they are made
};

/// A base of preconditioners that have no arrays beside those of levels.
struct WithoutArrays {
  template <class Level>
  static void make_arrays(Level& /*level*/, const LevelGraph& /*graph*/, const std::vector<Point>& /*rest*/) {}
  template <class Extra>
  static PreconditionerBytes bytes(std::int64_t /*nodes*/, std::int64_t /*edges*/) {
    return {};
  }
};

namespace detail {
struct AnyExecutor {};
struct AnyLevel {};
using AnyLevels = std::vector<std::unique_ptr<AnyLevel>>;
}  // namespace detail

template <class Type>
concept MakesArrays = requires(detail::AnyLevel& level, const LevelGraph& graph, const std::vector<Point>& rest) {
  { Type::make_arrays(level, graph, rest) } -> std::same_as<void>;
};
template <class Type>
concept ForecastsBytes = requires {
  { Type::template bytes<detail::AnyLevel>(std::int64_t{}, std::int64_t{}) } -> std::same_as<PreconditionerBytes>;
};
template <class Type>
concept PreparesLevels =
    requires(detail::AnyExecutor& on, detail::AnyLevels& levels, const PreconditionerSettings& settings) {
      { Type::prepare(on, levels, std::size_t{}, settings, true) } -> std::same_as<void>;
    };
template <class Type>
concept AppliesToLevels =
    requires(detail::AnyExecutor& on, detail::AnyLevels& levels, const PreconditionerSettings& settings) {
      { Type::apply(on, levels, std::size_t{}, settings) } -> std::same_as<void>;
    };

}  // namespace physgen::fem
