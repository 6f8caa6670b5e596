// A scene and the uses of its program, written by hand: x -> Svd -> svd (U, s) -> Force -> f, and an array that no step
// knows.
#pragma once

#include "scenes/scene.h"
#include "usage/usage.h"

namespace physgen::test {

inline scenes::Array array(const std::string& name, const std::string& object, const std::string& set,
                           std::vector<scenes::Field> fields) {
  scenes::Array array;
  array.name = name;
  array.object = object;
  array.header = "m.physgen.h";
  array.real = "float";
  array.own_real = true;
  array.set = set;
  array.fields = std::move(fields);
  array.location = {"chain.h", 10, 3};
  return array;
}

inline scenes::Scene chain() {
  scenes::Scene scene;
  scene.name = "chain";
  scene.scope = "scenes";
  scene.file = "chain.h";
  scene.include = "scenes/chain.h";
  scene.doc = "Forces from positions.";
  scene.real = "float";
  scenes::Group body{"Body", "body", "The body.", {}, {}};
  body.arrays.push_back(array("x", "m::Position", "node", {{"x", "float32", 3, 12, false}}));
  body.arrays.back().input = scenes::Selection{true, {}, {"chain.h", 4, 5}};
  body.arrays.push_back(
      array("svd", "m::Svd", "tet", {{"U", "float32", 9, 36, false}, {"s", "float32", 3, 12, false}}));
  body.arrays.push_back(array("f", "m::Force", "node", {{"f", "float32", 3, 12, false}}));
  body.arrays.back().own_real = false;
  body.arrays.back().output = scenes::Selection{false, {"f"}, {"chain.h", 8, 5}};
  body.arrays.push_back(
      array("extra", "m::Extra", "tet", {{"a", "float32", 1, 4, false}, {"b", "int32", 1, 4, false}}));
  scene.groups.push_back(std::move(body));
  return scene;
}

inline usage::FieldUse use(const std::string& array, const std::string& field, bool read,
                           std::vector<usage::Place> places) {
  usage::FieldUse use;
  use.array = array;
  use.field = field;
  use.read = read;
  use.written = !read;
  (read ? use.read_places : use.written_places) = places;
  use.places = std::move(places);
  return use;
}
inline usage::FieldUse reads(const std::string& array, const std::string& field) {
  return use(array, field, true, {{"force.h", 7, 3}});
}
inline usage::FieldUse writes(const std::string& array, const std::string& field) {
  return use(array, field, false, {{"force.h", 8, 3}});
}

inline usage::StepUse step(const std::string& kernel, std::vector<usage::FieldUse> fields) {
  usage::StepUse step;
  step.kernel = kernel;
  step.place = {"steps.h", 1, 1};
  step.arrays = {fields.front().array};
  step.fields = std::move(fields);
  return step;
}

inline usage::Usage chain_usage() {
  usage::Usage usage;
  usage.steps.push_back(
      step("Svd", {use("body.x", "x", true, {{"svd.h", 3, 9}}), use("body.svd", "U", false, {{"svd.h", 4, 9}}),
                   use("body.svd", "s", false, {{"svd.h", 5, 9}})}));
  usage.steps.back().arrays = {"body.x", "body.svd"};
  usage.steps.push_back(
      step("Force", {use("body.svd", "s", true, {{"force.h", 6, 1}}), use("body.f", "f", false, {{"force.h", 9, 1}})}));
  usage.steps.back().arrays = {"body.svd", "body.f"};
  return usage;
}

}  // namespace physgen::test
