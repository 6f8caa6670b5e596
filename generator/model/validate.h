// The rules that every model keeps, whatever is written from it: sizes, options and nesting. Rules about C++ constructs
// that a model cannot hold are the frontend's; rules about names and sizes of what is written are the emitter's.
#pragma once

#include <vector>

#include "model/issue.h"
#include "model/model.h"

namespace physgen::model {

/// Finds the broken rules of a model: validate(), or the further rules of an emitter.
using Rules = std::vector<Issue> (*)(const Schema&);

/// All broken rules, by object in order of declaration (imported ones first); empty: the model is sound.
[[nodiscard]] std::vector<Issue> validate(const Schema& schema);

}  // namespace physgen::model
