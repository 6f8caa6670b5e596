// The needs of a scene: which fields of its arrays some step reads or the caller wants, and which fields nothing
// misses. The rules do not look at the order of steps, since loops carry values round, and hold at a fixpoint:
//
//   - outputs are wanted, and what a predicate of a loop, the host, or code outside of all steps reads
//   - a step that writes a wanted field is live; what it reads is wanted
//   - a field that is not wanted is pruned: its stores vanish
//   - a wanted field that no live step writes must be an input, or have an initial value in its schema
//   - a step that is not live is an error: its kernel would read what is not there
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scenes/halos.h"
#include "scenes/issue.h"
#include "scenes/scene.h"
#include "usage/usage.h"

namespace physgen::scenes {

/// A step that reads or writes a field, and where in its source.
struct StepOfField {
  std::string step;  ///< "physgen::fem::ComputeSvd(body.gradients, body.svds)"
  std::vector<usage::Place> places;
  bool operator==(const StepOfField&) const = default;
};

struct FieldNeed {
  Field field;
  bool kept = false;
  std::vector<StepOfField> writers, readers;
  std::string why;  ///< "written by physgen::fem::ComputeSvd(...); nothing reads it"
  bool operator==(const FieldNeed&) const = default;
};

/// Fields of an array that a step reads before any step has written them: what is read there is no input, and the
/// schema gives it no value.
struct ReadTooEarly {
  std::string array;                ///< "body.velocities"
  std::vector<std::string> fields;  ///< one at least
  std::string step;                 ///< or "code outside of steps"
  usage::Place place;               ///< of the first of them
  bool operator==(const ReadTooEarly&) const = default;
};

/// The record of an array's objects in the memory of a space, with its padding.
struct Record {
  std::string space;   ///< "host" or "cuda"
  std::string layout;  ///< that the schema chooses there: "aos_padded"
  int bytes = 0;       ///< with the fields that are kept
  int all_bytes = 0;   ///< with all fields
  bool operator==(const Record&) const = default;
};

struct ArrayNeed {
  std::string array;  ///< "body.svds"
  std::vector<FieldNeed> fields;
  bool read_only = false;       ///< no step writes it
  std::vector<Record> records;  ///< in each space; none: nobody looked
  int group = -1;               ///< of steps that it is local to, as index of Needs::groups; -1: it is stored
  bool operator==(const ArrayNeed&) const = default;

  [[nodiscard]] bool local() const { return group >= 0; }

  /// Whether nothing of it is kept.
  [[nodiscard]] bool left_out() const;
};

/// Neighbouring steps that become one: those from `first` to `last` of ProgramText::lists[list].
struct StepGroup {
  std::size_t list = 0, first = 0, last = 0;
  std::vector<std::string> steps;
  std::vector<usage::Place> places;  ///< where each of them is run
  std::vector<std::string> locals;   ///< arrays that only they use
  bool operator==(const StepGroup&) const = default;
};

/// Neighbouring steps that are not joined.
struct StepsApart {
  std::string first, second;
  usage::Place place;                ///< where the second is run
  std::vector<std::string> why;      ///< one at least
  std::vector<std::string> between;  ///< fields that the first writes and the second uses: "body.corner_forces.G"
  bool operator==(const StepsApart&) const = default;
};

struct Needs {
  std::vector<ArrayNeed> arrays;  ///< in order of declaration, as are the fields of each
  std::vector<Issue> issues;      ///< errors first
  std::vector<ReadTooEarly> read_too_early;
  // Found by join_steps().
  std::vector<StepGroup> groups;
  std::vector<StepsApart> apart;
  std::vector<std::string> not_joined;  ///< why other steps are not looked at: "step() runs them, not the program"
  Halos halos;                          ///< found by find_halos()
  bool operator==(const Needs&) const = default;

  [[nodiscard]] bool sound() const;
  /// @pre there is an array of this full name
  [[nodiscard]] const ArrayNeed& of(const std::string& array) const;
};

/// The sentence that says so, with the remedy and without a full stop.
[[nodiscard]] std::string text_of(const ReadTooEarly& read);

/// Fields of an array that hold no value when it is made: the program writes them before it reads them.
[[nodiscard]] std::vector<std::string> fields_without_values(const Array& array, const ArrayNeed& need);

/// @param usage of the scene's program; its arrays have the scene's full names
[[nodiscard]] Needs find_needs(const Scene& scene, const usage::Usage& usage);

/// The same with every field kept, which is what needs are compared with.
[[nodiscard]] Needs everything(Needs needs);

}  // namespace physgen::scenes
