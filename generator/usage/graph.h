// Instantiated functions and what they call, as numbers: what is left of a program for finding which step makes which
// access. walk.h fills it from Clang's syntax tree; attribute() knows nothing of Clang.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "usage/usage.h"

namespace physgen::usage {

enum class Access { none, read, write, address };

struct Call {
  int to = 0;  ///< index of a function
  Place place;
  bool is_certain = false;  ///< called here under no condition, not by whoever gets an address or ends an object's life
  int order = 0;            ///< among those of a function, which stand in the order in which they are evaluated
};

/// Something that code consists of, or the value of something constant in it.
struct Fact {
  Place place;
  std::string what;
  auto operator<=>(const Fact&) const = default;
};

struct Function {
  Place place;                 ///< where it is defined
  bool of_library = false;     ///< of the runtime, generated, or the system's
  bool whole_object = false;   ///< get() or put() of a generated reference
  bool adds = false;           ///< add() of a reference to a field
  bool fused = false;          ///< the call operator of a fused kernel
  bool single_object = false;  ///< calls a kernel for one object, whose index types do not tell from others
  bool makes_index = false;    ///< of the program, makes or changes an index of packs or of a fused kernel
  Access access = Access::none;
  int field = -1;                    ///< that it accesses: index into Graph::fields
  std::set<std::string> calculated;  ///< arrays of which it finds objects by numbers that it calculates
  std::vector<Call> calls;
  std::set<Fact> facts;  ///< of a function of the program, once there are variants
};

/// A field, at the kernel's own index or at others.
struct ReachedField {
  FieldUse use;          ///< array and field, and whether at the kernel's own index
  bool of_part = false;  ///< at the index of an object of the part that the kernel is called for
};

struct Step {
  int function = 0;
  StepUse use;                       ///< without its fields
  std::set<std::string> own_files;   ///< where its kernel and what the kernel is made of are defined
  std::string kernel;                ///< a class of the program's, without template arguments; empty: there is none
  std::optional<KernelViews> views;  ///< of the kernel; none: it is no kernel of one object after the other
};

/// A kernel in a fused one.
struct Part {
  int call_operator = 0;  ///< index of a function
  std::string kernel;
  int behind = 0;          ///< how many kernels of the group come after it
  std::string class_name;  ///< as Step::kernel
  KernelViews views;
};

struct Graph {
  std::vector<Function> functions;
  std::vector<ReachedField> fields;
  std::vector<Step> steps;
  std::vector<Part> parts;
  std::vector<int> entries;  ///< functions of the program, for places of accesses that no step leads to
  std::vector<UnknownUse> unknown;
  int program = -1;           ///< the function that runs a scene's program over probes; -1: there is none
  std::vector<int> variants;  ///< functions that run the program over probes, and then over other arrays; or none
};

/// Gives every access to the steps that lead to it. Its places are those calls in the step's own files that lead to it
/// through functions of other files alone.
[[nodiscard]] Usage attribute(const Graph& graph);

/// What a scene's program reads before it writes it: calls are followed in the order of evaluation, each function once,
/// and statements in the order of the text. Writes count whatever their conditions, reads only without conditions.
[[nodiscard]] std::vector<EarlyRead> early_reads(const Graph& graph);

/// Where the program's code is another over other arrays than over probes. Functions are compared with those that the
/// same calls lead to, so that what a kernel does to one array is not taken for what it does to another.
[[nodiscard]] std::vector<Dependence> dependences(const Graph& graph);

}  // namespace physgen::usage
