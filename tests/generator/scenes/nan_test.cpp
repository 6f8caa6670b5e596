// That a scene's needs are true of what its program computes: NaN in some objects of one field, in arrays that keep all
// fields, changes no output where the field is said to be unread, and of the others those of the same objects alone.
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "run_case.h"

namespace physgen::test {
namespace {

using Objects = std::set<index_t>;

/// The need report's word on every field of an array of numbers: whether something reads it.
std::map<std::pair<std::string, std::string>, bool> reads() {
  std::ifstream in(PHYSGEN_NEEDS);
  const auto json = nlohmann::json::parse(in);
  std::map<std::pair<std::string, std::string>, bool> reads;
  for (const auto& array : json.at("arrays"))
    for (const auto& field : array.at("fields"))
      if (field.at("type") == "float32")
        reads[{array.at("array"), field.at("field")}] = !field.at("read_by").empty() || field.at("output");
  return reads;
}

/// A body and its state with every field.
struct Arrays {
  everything::Body<> body;
  everything::State<> state;

  Arrays() {
    set_up(body);
    state.allocate({.tet = tets});
  }
  UntypedArray named(const std::string& name) {
    const std::map<std::string, UntypedArray> arrays = {
        {"body.positions", body.positions.untyped()},      {"body.rest", body.rest.contents().untyped()},
        {"state.gradients", state.gradients.untyped()},    {"state.svds", state.svds.untyped()},
        {"state.rotations", state.rotations.untyped()},    {"state.stretches", state.stretches.untyped()},
        {"state.derivatives", state.derivatives.untyped()}};
    return arrays.at(name);
  }
  /// The tets whose outputs may depend on these objects of an array.
  Objects tets_of(const std::string& array, const Objects& objects) {
    if (array.starts_with("state.")) return objects;
    Objects result;
    for (index_t t = 0; t < tets; ++t)
      for (int corner = 0; corner < 4; ++corner)
        if (array == "body.rest" || objects.contains(body.tets.view()[t].nodes()[corner])) result.insert(t);
    return result;
  }
};

void plant_nan(const UntypedArray& array, const std::string& name, const Objects& objects) {
  for (const FieldInfo& field : array.fields) {
    if (field.name != name) continue;
    const std::uint64_t bits = bits_of_no_value(field.type);
    const int size = element_bytes(field.type);
    for (const index_t i : objects)
      for (int k = 0; k < field.count; ++k)
        std::memcpy(array.address(i, field.offset + k * size, size), &bits, static_cast<std::size_t>(size));
  }
}

/// Some of `size` objects, one at least: a half of them, some, or few.
Objects some_of(index_t size, unsigned seed) {
  std::mt19937 random(seed);
  Objects objects = {static_cast<index_t>(random() % static_cast<unsigned>(size))};
  const unsigned one_of = 2U << (seed % 4 * 2);
  for (index_t i = 0; i < size; ++i)
    if (random() % one_of == 0) objects.insert(i);
  return objects;
}

/// The tets whose outputs are other bits.
Objects changed(const std::vector<std::uint32_t>& found, const std::vector<std::uint32_t>& expected) {
  Objects result;
  const std::size_t each = expected.size() / static_cast<std::size_t>(tets);
  for (std::size_t k = 0; k < expected.size(); ++k)
    if (found[k] != expected[k]) result.insert(static_cast<index_t>(k / each));
  return result;
}

std::string listed(const Objects& objects) {
  std::string text;
  for (const index_t i : objects) text += std::to_string(i) + " ";
  return text;
}

TEST(NeedReport, is_true_of_each_field_and_object_that_nan_is_planted_in) {
  HostExecutor plain;
  const auto expected = results<everything::Body<>, everything::State<>>(plain);
  const auto fields = reads();
  EXPECT_EQ(fields.size(), 21U);
  constexpr unsigned first_seed = 20100607, seeds = 16;
  std::cout << "seeds " << first_seed << " to " << first_seed + seeds - 1 << '\n';
  std::vector<std::string> read_in_vain;
  for (const auto& [name, is_read] : fields) {
    const auto& [array, field] = name;
    int reached = 0;
    for (unsigned seed = first_seed; seed < first_seed + seeds; ++seed) {
      Arrays arrays;
      const UntypedArray planted = arrays.named(array);
      ASSERT_GT(planted.size, 0) << array;
      const Objects objects = some_of(planted.size, seed);
      Interrupted on;
      on.after = [&, field_name = field] { plant_nan(planted, field_name, objects); };
      on.after();
      scenes::derivative_chain::program(on, arrays.body, arrays.state, material);
      const Objects other = changed(outputs(arrays.state), expected);
      reached += other.empty() ? 0 : 1;
      const Objects may = is_read ? arrays.tets_of(array, objects) : Objects();
      EXPECT_EQ(listed(other), listed(may))
          << array << "." << field << (is_read ? " is read" : " is said to be unread") << ", seed " << seed;
    }
    if (is_read && reached == 0) read_in_vain.push_back(array + "." + field);
  }
  EXPECT_EQ(read_in_vain, std::vector<std::string>()) << "fields that are read and never change an output";
}

TEST(NeedReport, is_tried_with_objects_that_are_neither_all_nor_the_same) {
  std::set<Objects> tried;
  for (unsigned seed = 20100607; seed < 20100607 + 16; ++seed) {
    const Objects objects = some_of(tets, seed);
    EXPECT_LT(objects.size(), static_cast<std::size_t>(tets));
    EXPECT_TRUE(tried.insert(objects).second) << seed;
  }
}

}  // namespace
}  // namespace physgen::test
