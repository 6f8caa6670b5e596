// The generated arrays of scenes, run: what is pruned changes no bit of what is wanted, in packs and one by one; and
// what these arrays are made of.
#include <map>

#include "run_case.h"

namespace physgen::test {
namespace {

TEST(GeneratedScene, gives_the_bits_of_the_same_arrays_with_every_field) {
  HostExecutor packs;
  Singles singles;
  const auto full = results<everything::Body<>, everything::State<>>(packs);
  EXPECT_EQ(full, (results<scene::Body<>, scene::State<>>(packs)));
  EXPECT_EQ((results<everything::Body<>, everything::State<>>(singles)),
            (results<scene::Body<>, scene::State<>>(singles)));
  std::map<std::uint32_t, int> different;
  for (const std::uint32_t bits : full) ++different[bits];
  EXPECT_GT(different.size(), 4 * tets) << "the outputs must differ from object to object to show anything";
}

TEST(GeneratedScene, holds_only_what_its_program_needs) {
  using State = scene::State<>;
  EXPECT_EQ(decltype(State::svds)::record_bytes, 12);
  EXPECT_EQ(decltype(State::derivatives)::record_bytes, 8);
  EXPECT_EQ(decltype(State::rotations)::record_bytes, 0);
  EXPECT_EQ(decltype(everything::State<>::svds)::record_bytes, 84);
  State state;
  state.allocate({.tet = tets});
  EXPECT_EQ(state.rotations.size(), tets);
  EXPECT_EQ(state.rotations.bytes(), 0);
  EXPECT_EQ(state.bytes(),
            state.gradients.bytes() + state.svds.bytes() + state.stretches.bytes() + state.derivatives.bytes());
  EXPECT_EQ(state.svds.bytes(), 128 * 12);
}

TEST(GeneratedScene, hands_out_views_that_are_read_only_of_what_its_program_does_not_write) {
  scene::Body<> body;
  static_assert(std::is_same_v<decltype(body.tets.view()), decltype(body.tets.const_view())>);
  static_assert(!std::is_same_v<decltype(body.tets.contents().view()), decltype(body.tets.const_view())>);
  scene::State<> state;
  static_assert(!std::is_same_v<decltype(state.svds.view()), decltype(state.svds.const_view())>);
  EXPECT_THROW(body.allocate({.node = -1, .tet = 3}), Error);
}

TEST(GeneratedScene, takes_copies_of_whole_objects_and_leaves_out_what_it_prunes) {
  elasticity::DeformationSvdArray<float> whole(tets);
  for (index_t i = 0; i < tets; ++i) whole.view()[i].s() = Eigen::Vector3f(3, 2, static_cast<float>(i));
  scene::State<> state;
  state.allocate({.tet = tets});
  copy(state.svds, whole);
  for (index_t i = 0; i < tets; ++i) EXPECT_EQ(state.svds.view()[i].s().get()[2], static_cast<float>(i));
}

// ---- One record for all objects -------------------------------------------------------------------------------------

template <class On>
std::vector<std::uint32_t> gradients(On& on, auto rest) {
  everything::Body<> body;
  set_up(body);
  elasticity::DeformationGradientArray<float> F(tets);
  on.run(tets, fem::ComputeDeformationGradient{body.tets.view(), body.positions.view(), rest, F.view()});
  std::vector<std::uint32_t> bits;
  for (index_t i = 0; i < tets; ++i)
    for (int k = 0; k < 9; ++k) bits.push_back(std::bit_cast<std::uint32_t>(F.view()[i].F().get()(k)));
  return bits;
}

TEST(UniformArray, reads_as_an_array_of_equal_objects_does) {
  everything::Body<> body;
  set_up(body);
  elasticity::RestShapeArray<float> rest(tets);
  for (index_t i = 0; i < tets; ++i)
    rest.view()[i].dm_inverse() = body.rest.contents().view()[index_t{0}].dm_inverse().get();
  HostExecutor packs;
  Singles singles;
  EXPECT_EQ(gradients(packs, body.rest.view()), gradients(packs, rest.view()));
  EXPECT_EQ(gradients(singles, body.rest.view()), gradients(singles, rest.view()));
  EXPECT_EQ(body.rest.size(), tets);
  EXPECT_EQ(body.rest.contents().size(), 1);
  EXPECT_LT(body.rest.bytes(), rest.bytes());
}

TEST(UniformArray, refuses_a_negative_size_and_keeps_its_record_otherwise) {
  UniformArray<elasticity::RestShapeArray<float>> rest(5);
  rest.contents().view()[index_t{0}].volume() = 3;
  rest.resize(1000);
  EXPECT_EQ(rest.size(), 1000);
  EXPECT_EQ(rest.view()[index_t{999}].volume(), 3.F);
  EXPECT_THROW(rest.resize(-1), Error);
  rest.resize(0);
  rest.resize(2);
  EXPECT_EQ(rest.view()[index_t{1}].volume(), 3.F);
}

// ---- Fields that begin without values -------------------------------------------------------------------------------

template <class Layout>
void expect_values_gone() {
  Array<elasticity::DeformationSvdObject, double, Host, Layout> svds(37);
  const auto view = svds.view();
  for (index_t i = 0; i < 37; ++i) view[i].s() = Eigen::Vector3d(1, 2, static_cast<double>(i));
  start_without_values(svds.untyped(), {"U", "V"});
  for (index_t i = 0; i < 37; ++i) {
    const Eigen::Matrix3d U = view[i].U().get(), V = view[i].V().get();
    EXPECT_TRUE(U.array().isNaN().all() && V.array().isNaN().all()) << Layout::name << " " << i;
    EXPECT_EQ(view[i].s().get(), Eigen::Vector3d(1, 2, static_cast<double>(i))) << Layout::name;
    constexpr std::uint64_t quiet = 0x0008000000000000;
    for (int k = 0; k < 9; ++k) EXPECT_EQ(std::bit_cast<std::uint64_t>(U(k)) & quiet, 0U) << "it must signal";
  }
}

TEST(StartWithoutValues, gives_all_elements_of_the_fields_signalling_nan_in_every_layout) {
  expect_values_gone<Aos>();
  expect_values_gone<AosPadded>();
  expect_values_gone<Soa>();
  expect_values_gone<Aosoa<16>>();
}

TEST(StartWithoutValues, is_what_allocate_does_in_checked_builds_with_fields_that_are_no_inputs) {
  scene::Body<> body;
  scene::State<> state;
  body.allocate({.node = nodes, .tet = tets});
  state.allocate({.tet = tets});
  EXPECT_EQ(std::isnan(state.svds.view()[index_t{tets - 1}].s().get()[2]), checked_build);
  EXPECT_EQ(body.positions.view()[index_t{3}].x().get(), Eigen::Vector3f(0, 0, 0)) << "an input keeps initial values";
}

TEST(StartWithoutValues, gives_integers_the_lowest_and_reaches_the_record_of_a_uniform_array) {
  elasticity::TetArray<float> tets_of_nodes(3);
  start_without_values(tets_of_nodes.untyped(), {"nodes"});
  for (int k = 0; k < 4; ++k) EXPECT_EQ(tets_of_nodes.getdata(2, k), -2147483648.0);
  UniformArray<elasticity::RestShapeArray<float>> rest;
  allocate(rest, 7, {"volume"});
  EXPECT_EQ(std::isnan(rest.view()[index_t{6}].volume()), checked_build);
}

TEST(StartWithoutValues, means_all_entries_of_a_fixed_array_of_nested_objects_by_one_name) {
  EXPECT_TRUE(detail::is_named("points[0].x", "points.x") && detail::is_named("points[12].x", "points.x"));
  EXPECT_TRUE(detail::is_named("x", "x") && detail::is_named("svd.U", "svd.U"));
  EXPECT_FALSE(detail::is_named("points[0].xy", "points.x") || detail::is_named("points[0].x", "points.xy"));
  EXPECT_FALSE(detail::is_named("point[0].x", "points.x") || detail::is_named("", "x"));
}

TEST(StartWithoutValues, names_a_field_that_there_is_not) {
  elasticity::StressArray<float> stresses(3);
  try {
    start_without_values(stresses.untyped(), {"Q"});
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "physgen: elasticity::Stress: there is no field Q that could start without a value");
  }
}

}  // namespace
}  // namespace physgen::test
