// That a scene's needs are true of what its program computes: NaN in some objects of one field, in arrays that keep all
// fields, changes no output where the field is said to be unread, and of the others those of the same objects alone.
#include <iostream>

#include "planted_nan.h"
#include "run_case.h"

namespace physgen::test {
namespace {

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

/// The tets whose outputs are other bits.
Objects changed(const std::vector<std::uint32_t>& found, const std::vector<std::uint32_t>& expected) {
  Objects result;
  const std::size_t each = expected.size() / static_cast<std::size_t>(tets);
  for (std::size_t k = 0; k < expected.size(); ++k)
    if (found[k] != expected[k]) result.insert(static_cast<index_t>(k / each));
  return result;
}

TEST(Digest, is_true_of_each_field_and_object_that_nan_is_planted_in) {
  HostExecutor plain;
  const auto expected = results<everything::Body<>, everything::State<>>(plain);
  const auto fields = reads_of(PHYSGEN_DIGEST);
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

TEST(Digest, is_tried_with_objects_that_are_neither_all_nor_the_same) {
  std::set<Objects> tried;
  for (unsigned seed = 20100607; seed < 20100607 + 16; ++seed) {
    const Objects objects = some_of(tets, seed);
    EXPECT_LT(objects.size(), static_cast<std::size_t>(tets));
    EXPECT_TRUE(tried.insert(objects).second) << seed;
  }
}

}  // namespace
}  // namespace physgen::test
