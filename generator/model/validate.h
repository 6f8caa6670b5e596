// The rules that every model keeps, whether it came from a schema or from JSON: names, sizes, options and nesting.
// Rules about C++ constructs that a model cannot hold are the frontend's.
#pragma once

#include <string>
#include <vector>

#include "model/model.h"

namespace physgen::model {

/// What a rule was broken by; the frontend points its caret there.
enum class Aspect {
  name,
  scope,
  fields,
  type,
  unit,
  range,
  initial,
  host_format,
  cuda_format,
  host_layout,
  cuda_layout,
  alignment
};

/// An object of a schema, or one of its fields.
struct Place {
  bool imported = false;  ///< in Schema::imported, else in Schema::objects
  int object = -1;        ///< -1: the schema as a whole
  int field = -1;         ///< -1: the object itself
  bool operator==(const Place&) const = default;
};

struct Issue {
  Place place;
  Aspect aspect = Aspect::name;
  std::string message;  ///< what is wrong and what to write instead, one line without a full stop
  Place other;          ///< what it clashes with, if other.object >= 0
};

/// Largest vector, matrix side, array extent and record of one object (in elements); they keep all offsets far inside
/// int.
inline constexpr int max_side = 1024;
/// Bytes of the largest value of one field's entry, with double: what Eigen keeps on the stack,
/// EIGEN_STACK_ALLOCATION_LIMIT.
inline constexpr int max_value_bytes = 128 * 1024;
inline constexpr int max_extent = 65536;
inline constexpr int max_elements = 1 << 20;
inline constexpr int max_tile = 1024;
inline constexpr int max_alignment = 256;

/// All broken rules, by object in order of declaration (imported ones first); empty: the model is sound.
[[nodiscard]] std::vector<Issue> validate(const Schema& schema);

/// "256" is a power of two from 1 to `limit`; the rule of tiles and alignments.
[[nodiscard]] bool is_power_of_two_up_to(int value, int limit);

}  // namespace physgen::model
