// What tests of steps have in common: a table of kernels, sets and arrays, in one process.
#pragma once

#include <gtest/gtest.h>
#include <physgen/distributed/executor.h>

#include "springs.h"

namespace physgen {

inline constexpr HaloUse table[] = {
    {"Gathers", 0, "nodes", {.reads_own = true}},
    {"Gathers", 1, "x", {.reads_others = true}, "b.edges.nodes"},
    {"Adds", 0, "nodes", {.reads_own = true}},
    {"Adds", 1, "x", {.writes_others = true}, "b.edges.nodes"},
    {"Renumbers", 0, "nodes", {.writes_own = true}},
    {"Far", 0, "begin", {.reads_own = true}},
    {"Far", 1, "x", {.reads_others = true}, "b.ends.element, b.edges.nodes"},
    {"Beside", 0, "begin", {.reads_own = true}},
    {"Beside", 1, "x", {.reads_others = true}},
    {"OfTwo", 0, "x", {.reads_own = true}},
    {"OfTwo", 1, "nodes", {.reads_own = true}},
    {"OfTwoNames", 0, "x", {.reads_own = true}},
    {"OfTwoNames", 1, "f", {.reads_own = true, .writes_own = true}},
    {"OfOne", 0, "f", {.reads_own = true}},
    {"OfOne", 1, "x", {.reads_others = true}},
    {"Known", 0, "x", {.reads_own = true}},
    {"OfEntries", 0, "element", {.reads_own = true}},
    {"Sets", 0, "x", {.writes_own = true}},
    {"Degree", 0, "end", {.reads_own = true}},
    {"Degree", 1, "x", {.writes_own = true}},
    {"RowsOfOthers", 0, "nodes", {.reads_own = true}},
    {"RowsOfOthers", 1, "begin", {.reads_others = true}, "b.edges.nodes"},
    {"NamesOfEnds", 0, "nodes", {.reads_own = true}},
    {"NamesOfEnds", 1, "nodes", {.reads_others = true}, "b.edges.nodes"},
    {"Totals", 0, "begin", {.reads_own = true}},
    {"Totals", 0, "end", {.reads_own = true}},
    {"Totals", 1, "element", {.reads_others = true}, "b.group_ranges.begin, b.group_ranges.end"},
    {"Totals", 2, "x", {.reads_others = true}, "b.members.element"},
    {"Totals", 3, "f", {.writes_own = true}},
    {"Lengths", 0, "end", {.reads_own = true}},
    {"Lengths", 1, "f", {.writes_own = true}},
    {"Settles", 0, "f", {.reads_own = true, .writes_own = true}},
    {"AddsTotals", 0, "end", {.reads_own = true}},
    {"AddsTotals", 1, "f", {.writes_others = true}},
    {"Asks", 0, "nodes", {.reads_own = true}},
    {"Asks", 1, "end", {.reads_others = true}, "b.homes.nodes"},
    {"Pulls", 0, "nodes", {.reads_own = true}},
    {"Pulls", 1, "x", {.reads_others = true}, "b.edges.nodes"},
    {"Pulls", 2, "f", {.writes_own = true}},
    {"SumsPulls", 0, "begin", {.reads_own = true}},
    {"SumsPulls", 0, "end", {.reads_own = true}},
    {"SumsPulls", 1, "element", {.reads_others = true}, "b.ranges.begin, b.ranges.end"},
    {"SumsPulls", 2, "f", {.reads_others = true}, "b.ends.element"},
    {"SumsPulls", 3, "x", {.writes_own = true}},
    {"Beside groups", 0, "f", {.writes_own = true}},
    {"Beside groups", 1, "x", {.reads_others = true}, "b.members.element"},
    {"Beside groups", 2, "x", {.reads_own = true}},
    {"Beside both", 0, "f", {.writes_own = true}},
    {"Beside both", 1, "f", {.reads_own = true}},
    {"Beside both", 2, "x", {.reads_others = true}, "b.members.element"},
};

/// Nodes, edges that name them, rows of edges, and a state that all ranks have.
class Steps : public testing::Test {
 protected:
  void make_sets(bool follows) {
    arrays.add_set("node", 100);
    arrays.add_set("edge", 60);
    arrays.add_replicated_set("one", 1);
    if (follows) arrays.follow("edge", "node");
    arrays.add("b.positions", "node", positions);
    arrays.add("b.ranges", "node", ranges);
    arrays.add("b.edges", "edge", edges);
    arrays.add("b.state", "one", state);
    arrays.connect(edges, "nodes", "node", [](index_t e) { return std::array{e, e + 1}; });
    arrays.connect_rows(ranges, "b.ends", ends, "element", "edge", [](index_t node) {
      std::vector<elasticity::Incidence<float>> row(node < 60 ? 1 : 0);
      if (node < 60) row[0].element = static_cast<std::int32_t>(node);
      return row;
    });
  }
  void cut(bool follows) {
    make_sets(follows);
    arrays.cut();
  }
  template <class View>
  static KernelView of(const View& view) {
    const UntypedArray memory = view.untyped();
    return {memory.base, memory.size, !std::is_const_v<typename View::Byte>, memory.object};
  }
  /// The message of a step of a kernel, or the range over which it runs.
  std::string step(const std::string& kernel, std::vector<KernelView> views, index_t size,
                   HaloSteps::Way way = HaloSteps::Way::run) {
    HaloSteps steps(arrays, true);
    const HaloSteps::Kernel one{&kernel, std::move(views)};
    try {
      const HaloSteps::Objects objects = steps.begin(std::span(&one, 1), size, way);
      return std::to_string(objects.begin) + " to " + std::to_string(objects.end);
    } catch (const Error& error) {
      return error.what();
    }
  }
  /// Whether ghosts of an array's first field are fresh behind a step.
  bool is_fresh_behind(const std::string& kernel, std::vector<KernelView> views, const auto& array) {
    HaloSteps steps(arrays, true);
    const HaloSteps::Kernel one{&kernel, std::move(views)};
    (void)steps.begin(std::span(&one, 1), array.size(), HaloSteps::Way::run);
    steps.end();
    return is_fresh(array);
  }
  bool is_fresh(const auto& array) const {
    return arrays.arrays()[static_cast<std::size_t>(arrays.find(array.untyped().base))].fresh[0] == all_ghosts;
  }
  static std::string message_of(const auto& body) {
    try {
      body();
    } catch (const Error& error) {
      return error.what();
    }
    return "accepted";
  }

  int argc = 0;
  char** argv = nullptr;
  Ranks ranks{argc, argv};
  DistributedArrays arrays{ranks, table};
  elasticity::NodePositionArray<float> positions;
  elasticity::IncidenceRangeArray<float> ranges;
  elasticity::EdgeArray<float> edges;
  elasticity::IncidenceArray<float> ends;
  elasticity::NodeForceArray<double> state;
};

}  // namespace physgen
