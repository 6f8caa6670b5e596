// Declarations that say which sets index fields name, and which sets follow others: what is read, and what is refused.
#include <gtest/gtest.h>

#include "read_case.h"

namespace physgen::test {
namespace {

TEST(SceneDeclaration, says_which_sets_index_fields_name_and_which_set_another_follows) {
  const auto declaration = read(scene_of(R"(
    PHYSGEN_ARRAY(per("node")) Array<SvdObject, float> nodes;
    PHYSGEN_ARRAY(per("tet"), names("n", "node", shifted(2)), names("n", "tet"), follows("node"))
    Array<SvdObject, float> tets;)"));
  ASSERT_TRUE(declaration.scene) << declaration.diagnostics;
  const auto& arrays = declaration.scene->groups[0].arrays;
  EXPECT_TRUE(scenes::states_names(*declaration.scene));
  EXPECT_TRUE(arrays[0].names.empty() && arrays[0].follows.empty());
  EXPECT_EQ(arrays[1].follows, "node");
  ASSERT_EQ(arrays[1].names.size(), 2U);
  EXPECT_TRUE(arrays[1].names[0].field == "n" && arrays[1].names[0].set == "node" && arrays[1].names[0].shift == 2);
  EXPECT_TRUE(arrays[1].names[1].set == "tet" && arrays[1].names[1].shift == 0);
  const auto without = read(scene_of("PHYSGEN_ARRAY(per(1)) Array<SvdObject, float> one;"));
  ASSERT_TRUE(without.scene) << without.diagnostics;
  EXPECT_FALSE(scenes::states_names(*without.scene));
}

const std::vector<Wrong> wrong_names = {
    {"names_of_a_field_that_is_not_there",
     scene_of("PHYSGEN_ARRAY(per(\"tet\"), names(\"m\", \"tet\")) Array<SvdObject, float> svds;"),
     {"3:27: error: array 'svds' holds Svd; there is no field 'm'; there are U, n and points.x"}},
    {"names_of_a_field_that_is_no_index",
     scene_of("PHYSGEN_ARRAY(per(\"tet\"), names(\"U\", \"tet\")) Array<SvdObject, float> svds;"),
     {"3:27: error: array 'svds' names objects by its field 'U', which is no index but float32; name a field of type "
      "Index"}},
    {"names_of_a_set_that_is_not_there",
     scene_of(
         "PHYSGEN_ARRAY(per(\"tet\"), names(\"n\", \"tet\"), names(\"n\", \"tets\")) Array<SvdObject, float> svds;"),
     {"3:46: error: array 'svds' names objects of a set of which the scene has no array; there is no set 'tets'; did "
      "you mean 'tet'?"}},
    {"names_twice",
     scene_of(
         "PHYSGEN_ARRAY(per(\"tet\"), names(\"n\", \"tet\"), names(\"n\", \"tet\")) Array<SvdObject, float> svds;"),
     {"3:46: error: array 'svds' has this option twice; remove one of them"}},
    {"a_shift_by_more_than_an_index_has",
     scene_of("PHYSGEN_ARRAY(per(\"tet\"), names(\"n\", \"tet\", shifted(31))) Array<SvdObject, float> svds;"),
     {"3:27: error: array 'svds' has shifted(31); an index has 31 bits, so shift by 0 to 30"}},
    {"names_of_no_index",
     scene_of("PHYSGEN_ARRAY(per(\"tet\"), no_index(\"n\"), names(\"n\", \"tet\")) Array<SvdObject, float> svds;"),
     {"3:42: error: array 'svds' has names(...) and no_index(...) of one field; remove one of them"}},
    {"a_shift_beside_names",
     scene_of("PHYSGEN_ARRAY(per(\"tet\"), shifted(2)) Array<SvdObject, float> svds;"),
     {"3:27: error: array 'svds' has shifted(...) beside its options; write it in names(\"code\", \"tet\", "
      "shifted(2))"}},
    {"a_set_that_follows_one_that_is_not_there",
     scene_of("PHYSGEN_ARRAY(per(\"tet\"), follows(\"node\")) Array<SvdObject, float> svds;"),
     {"3:27: error: array 'svds' follows a set of which the scene has no array; there is no set 'node'; there are "
      "tet"}},
    {"sets_that_follow_each_other",
     scene_of("PHYSGEN_ARRAY(per(\"tet\"), follows(\"node\")) Array<SvdObject, float> svds;\n"
              "PHYSGEN_ARRAY(per(\"node\"), follows(\"tet\")) Array<SvdObject, float> nodes;"),
     {"3:27: error: array 'svds' is per('tet'), and tet and node follow each other, so that no rank would know where "
      "to "
      "begin; remove one follows(...)",
      "4:28: error: array 'nodes' is per('node'), and node and tet follow each other, so that no rank would know where "
      "to begin; remove one follows(...)"}},
    {"a_set_that_follows_itself",
     scene_of("PHYSGEN_ARRAY(per(\"tet\"), follows(\"tet\")) Array<SvdObject, float> svds;"),
     {"3:27: error: array 'svds' is per('tet'), and tet follows itself, so that no rank would know where to begin; "
      "remove one follows(...)"}},
    {"one_object_that_follows",
     scene_of("PHYSGEN_ARRAY(per(1), follows(\"tet\")) Array<SvdObject, float> one;\n" + svds),
     {"3:23: error: array 'one' follows a set, and has the same objects on every rank; remove follows(...)"}},
};

class WrongNames : public testing::TestWithParam<Wrong> {};
TEST_P(WrongNames, are_reported) {
  const auto declaration = read(GetParam().text);
  EXPECT_FALSE(declaration.scene);
  EXPECT_EQ(errors_of(declaration.diagnostics), GetParam().expected) << declaration.diagnostics;
}
INSTANTIATE_TEST_SUITE_P(With, WrongNames, testing::ValuesIn(wrong_names),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace physgen::test
