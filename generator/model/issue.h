// Broken rules of a model and their places; rules are the model's or an emitter's.
#pragma once

#include <string>

#include "model/model.h"

namespace physgen::model {

/// The part of a declaration that breaks a rule; the frontend points its caret there.
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

/// Calls check(object, place) for every object in order of declaration, imported ones first.
template <class Check>
void for_each_object(const Schema& schema, const Check& check) {
  for (const bool imported : {true, false}) {
    const auto& objects = imported ? schema.imported : schema.objects;
    for (std::size_t i = 0; i < objects.size(); ++i) check(objects[i], Place{imported, static_cast<int>(i), -1});
  }
}

struct Issue {
  Place place;
  Aspect aspect = Aspect::name;
  std::string message;  ///< what is wrong and what to write instead, one line without a full stop
  Place other;          ///< the other side of a clash, if other.object >= 0
};

}  // namespace physgen::model
