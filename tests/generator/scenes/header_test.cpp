// The text that is written of a scene: the header against a golden one, which is compared letter by letter.
#include "scenes/header.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "by_hand.h"
#include "scenes/probe_unit.h"

namespace physgen::test {
namespace {

std::string text_of(const std::string& name) {
  std::ifstream in(std::string(PHYSGEN_GOLDEN_DIR) + "/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(SceneHeader, is_the_golden_one) {
  const auto scene = chain();
  EXPECT_EQ(scenes::header(scene, scenes::find_needs(scene, chain_usage())), text_of("chain.scene.h"));
}

TEST(SceneHeader, of_everything_stores_every_field_under_another_name) {
  const auto scene = chain();
  const auto text = scenes::header(scene, scenes::everything(scenes::find_needs(scene, chain_usage())), "_everything");
  EXPECT_EQ(text.find("Pruned"), std::string::npos);
  EXPECT_NE(text.find("namespace scenes::chain_everything {"), std::string::npos);
}

TEST(SceneHeader, prunes_fields_of_nested_objects_and_counts_single_ones) {
  auto scene = chain();
  scene.groups[0].arrays.push_back(
      array("state", "m::State", "", {{"n", "int32", 1, 4, false}, {"svd.U", "float32", 9, 36, false}}));
  scene.groups[0].arrays.back().count = 1;
  auto usage = chain_usage();
  usage.steps[1].fields.push_back(reads("body.state", "n"));
  usage.steps[1].fields.push_back(writes("body.state", "n"));
  const auto text = scenes::header(scene, scenes::find_needs(scene, usage));
  for (const char* lines :
       {"struct BodyStateFormats : Stored {\n"
        "  struct SvdFormats : Stored::svd {\n"
        "    using U = physgen::format::Pruned<chain, tags::body::state, tags::body::state::svd_U>;\n"
        "  };\n"
        "  using svd = SvdFormats;\n"
        "};\n",
        "    physgen::allocate(state, 1, {\"n\"});\n", "physgen::bytes_of_array<decltype(state)>(1)"})
    EXPECT_NE(text.find(lines), std::string::npos) << lines << "in\n" << text;
}

TEST(SceneHeader, tells_a_field_from_an_array_of_its_name) {
  auto scene = chain();
  scene.groups[0].arrays.push_back(array("n", "m::Number", "", {{"n", "int32", 1, 4, false}}));
  const auto text = scenes::header(scene, scenes::find_needs(scene, chain_usage()));
  EXPECT_NE(text.find("Pruned<chain, tags::body::n, tags::body::n::n_>"), std::string::npos) << text;
}

TEST(SceneHeader, has_no_precision_to_choose_where_the_scene_declares_none) {
  auto scene = chain();
  scene.real.clear();
  const auto text = scenes::header(scene, scenes::find_needs(scene, chain_usage()));
  EXPECT_NE(text.find("template <class Space_ = physgen::Host, class Stored_ = physgen::StoredAsDeclared>\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("::m::SvdArray<float, Space>"), std::string::npos) << text;
  EXPECT_EQ(text.find("Real"), std::string::npos) << text;
}

TEST(SceneHeader, tells_the_field_name_from_the_arrays_name) {
  auto scene = chain();
  scene.groups[0].arrays.push_back(array("label", "m::Label", "", {{"name", "int32", 1, 4, false}}));
  const auto text = scenes::header(scene, scenes::find_needs(scene, chain_usage()));
  EXPECT_NE(text.find("using name = physgen::format::Pruned<chain, tags::body::label, tags::body::label::name_>"),
            std::string::npos)
      << text;
}

TEST(SceneHeader, means_the_objects_of_a_namespace_that_has_the_scenes_own_name) {
  auto scene = chain();
  scene.name = "m";
  const auto text = scenes::header(scene, scenes::find_needs(scene, chain_usage()));
  EXPECT_NE(text.find(" ::m::SvdArray<Real, Space>"), std::string::npos) << text;
  EXPECT_EQ(text.find(" m::SvdArray"), std::string::npos) << text;
}

TEST(ProbeUnit, gives_the_program_a_probe_for_every_array_and_something_for_every_parameter) {
  auto scene = chain();
  scene.parameters = {"double"};
  const auto text = scenes::probe_unit(scene, "Host", "/x/chain.h");
  for (const char* line :
       {"#include \"/x/chain.h\"\n", "physgen::ProbeOf<m::SvdArray<float, Space>, tags_of_Body::svd> svd;\n",
        "struct svd { static constexpr const char* name = \"body.svd\"; };\n",
        "::scenes::chain::program(on, the_body, some<double>());\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << "in\n" << text;
}

}  // namespace
}  // namespace physgen::test
