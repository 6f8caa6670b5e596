// What a step of a case came to: reactions and loads of groups, extremes of displacement, and probes.
#pragma once

#include <fem/mesh/mesh.h>

#include <string>
#include <vector>

namespace physgen::truthcube {

/// A direction along which a support prescribes a component, and the reaction along it.
struct AxisReaction {
  fem::Point axis{};
  double force = 0;  ///< [N]
  bool operator==(const AxisReaction&) const = default;
};

struct GroupState {
  std::string group;
  fem::Point reaction{};             ///< the sum of the forces that hold its prescribed components [N]
  fem::Point load{};                 ///< the sum of the external forces on its nodes, gravity among them [N]
  double largest_displacement = 0;   ///< of its nodes [m]
  std::vector<AxisReaction> axes{};  ///< of supports that have one
  bool operator==(const GroupState&) const = default;
};

/// The lowest or the highest value of one measure of the displacement, and where.
struct Extreme {
  double value = 0;  ///< [m]
  fem::Point at{};   ///< the node's place at rest [m]
  bool operator==(const Extreme&) const = default;
};

struct ProbeState {
  std::string probe;
  fem::Point at{}, displacement{};  ///< [m]
  bool operator==(const ProbeState&) const = default;
};

struct CaseState {
  double load = 0;  ///< the step: the factor of all that follows no curve
  GroupState all;   ///< all nodes: reaction and load sum to what the solve has left of a residual
  std::vector<GroupState> groups;
  struct Range {
    std::string of;  ///< "x", "y", "z", "length"
    Extreme low, high;
    bool operator==(const Range&) const = default;
  };
  std::vector<Range> displacement;
  std::vector<ProbeState> probes;
  bool operator==(const CaseState&) const = default;
};

}  // namespace physgen::truthcube
