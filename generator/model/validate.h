// The rules that every model keeps, whatever is written from it: sizes, options and nesting. Rules about C++ constructs
// that a model cannot hold are the frontend's; rules about names and sizes of what is written are the emitter's.
#pragma once

#include <vector>

#include "model/issue.h"
#include "model/model.h"

namespace physgen::model {

/// Largest vector, matrix side, array extent and record of one object (in elements); they keep all offsets far inside
/// int.
inline constexpr int max_side = 1024;
inline constexpr int max_extent = 65536;
inline constexpr int max_elements = 1 << 20;
inline constexpr int max_tile = 1024;
inline constexpr int max_alignment = 256;

/// All broken rules, by object in order of declaration (imported ones first); empty: the model is sound.
[[nodiscard]] std::vector<Issue> validate(const Schema& schema);

/// "256" is a power of two from 1 to `limit`; the rule of tiles and alignments.
[[nodiscard]] bool is_power_of_two_up_to(int value, int limit);

}  // namespace physgen::model
