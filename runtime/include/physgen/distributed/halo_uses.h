// The table of what kernels use of their own objects and of others. physgen writes one from a scene that states which
// set its index fields name, as NAME.halos.h; one may be written by hand. The executor of several ranks
// (distributed/executor.h) reads from it which fields must cross to other ranks before a step.
//
//   inline constexpr physgen::HaloUse relax_halos[] = {
//       {"springs::Pull", 0, "nodes", {.reads_own = true}},
//       {"springs::Pull", 1, "x", {.reads_others = true}, "body.edges.nodes"},
//       {"springs::Pull", 2, "f", {.writes_own = true}},
//   };
#pragma once

#include <span>
#include <string_view>

namespace physgen {

/// How a kernel that is called for object i uses a field. "Own" is object i of the set that the kernel runs over; the
/// others are found by an index that an index field, or an entry of a row, names.
struct HaloAccess {
  bool reads_own = false;
  bool reads_others = false;
  bool writes_own = false;     ///< of some objects at least, and some elements of the field
  bool writes_others = false;  ///< also by add()

  bool operator==(const HaloAccess&) const = default;
};

/// One row: a kernel's use of one field through one of its views. All uses of a field are one row, or several rows of
/// which each counts. A row with an empty field says that the kernel uses no field of the view.
///
/// A kernel without rows, a view without rows and a field whose use is not known count as read and written everywhere,
/// so an incomplete table costs exchanges, and a row that says too little is wrong.
struct HaloUse {
  /// The qualified name of the kernel's class or class template, without template arguments, as C++ names it:
  /// "physgen::fem::ComputeSvd", "(anonymous namespace)::Pull". (The steps of a fused kernel have rows of their own; a
  /// lambda cannot have any.)
  std::string_view kernel;
  /// The number of the view among the kernel's views. Members count in the order of their declaration: a View is one,
  /// also one of a local of a fused kernel, Rows are two (the ranges, then the entries), a member that is an aggregate
  /// counts with its own members at its place, and all other members (numbers) do not count.
  int view;
  std::string_view field;  ///< "x"; "svd.U" of a nested object, "points.x" of a fixed array of them
  HaloAccess access;
  /// The index fields that name the others, by array and field, "body.edges.nodes"; all of them, separated by ", ". To
  /// the ghosts to which these, and those that the kernel's other rows name, lead from its own objects fields cross.
  /// "level.edges.nodes" also means level[0].edges.nodes and level[1].edges.nodes, of arrays that are added with
  /// numbers. Empty where no others are used, or where it is not known: several ranks refuse a kernel that reads others
  /// so.
  std::string_view through = {};

  bool operator==(const HaloUse&) const = default;
};

/// All rows of a program. It refers to rows of static storage.
using HaloUses = std::span<const HaloUse>;

}  // namespace physgen
