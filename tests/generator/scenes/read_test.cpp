// Declarations of scenes: what is read from a sound one, and what is said of others. The objects stand for generated
// ones, so that nothing else is parsed.
#include <gtest/gtest.h>

#include <algorithm>

#include "read_case.h"

namespace physgen::test {
namespace {

TEST(SceneDeclaration, is_read_with_its_groups_arrays_options_and_comments) {
  const auto declaration = read(R"(namespace a::b {
/// The problem that is solved.
struct PHYSGEN_SCENE() scene {
  using Real = double;
  /// The body.
  struct Body {
    PHYSGEN_ARRAY(per("tet"), input(), output("n")) Array<SvdObject, Real> svds;  ///< of each tet
    PHYSGEN_ARRAY(per(1), uniform(), input("U", "points.x")) Array<SvdObject, float> one;
  };
  struct Level { PHYSGEN_ARRAY(per("node")) Array<SvdObject, Real> nodes; };
  struct Other { int number; };
  template <class On, class B, class L> static void program(On& on, B& body, const L&, const Other& o, double dt);
};
})");
  ASSERT_TRUE(declaration.scene) << declaration.diagnostics;
  const scenes::Scene& scene = *declaration.scene;
  EXPECT_EQ(scene.qualified_name(), "a::b::scene");
  EXPECT_EQ(scene.doc, "The problem that is solved.");
  EXPECT_EQ(scene.real, "double");
  EXPECT_EQ(scene.include, "scene.h");
  EXPECT_EQ(scene.parameters, (std::vector<std::string>{"a::b::scene::Other", "double"}));
  ASSERT_EQ(scene.groups.size(), 2U);
  const scenes::Group& body = scene.groups[0];
  EXPECT_EQ(body.variable, "body");
  EXPECT_EQ(scene.groups[1].variable, "level") << "of a parameter without a name";
  EXPECT_EQ(body.doc, "The body.");
  EXPECT_EQ(body.sets(), std::vector<std::string>{"tet"});
  ASSERT_EQ(body.arrays.size(), 2U);
  const scenes::Array &svds = body.arrays[0], &one = body.arrays[1];
  EXPECT_EQ(svds.object, "Svd");
  EXPECT_EQ(svds.doc, "of each tet");
  EXPECT_EQ(svds.real, "double");
  EXPECT_TRUE(svds.own_real && !one.own_real);
  EXPECT_EQ(svds.header, "objects.h");
  EXPECT_EQ(svds.set, "tet");
  EXPECT_TRUE(svds.is_input("U") && svds.is_input("n") && svds.is_output("n") && !svds.is_output("U"));
  EXPECT_EQ(svds.location.line, 7);
  EXPECT_EQ(one.real, "float");
  EXPECT_EQ(one.count, 1);
  EXPECT_TRUE(one.uniform && one.is_input("points.x") && !one.is_input("n") && !one.output);
  const std::vector<scenes::Field> fields = {
      {"U", "float32", 9, 36, false}, {"n", "int32", 1, 4, true}, {"points.x", "float32", 6, 24, false}};
  EXPECT_EQ(svds.fields, fields);
}

TEST(SceneDeclaration, counts_the_bytes_of_every_type_of_element_and_refuses_what_the_catalogue_does_not_know) {
  const auto read_field = [](const std::string& type) {
    return read(
        "struct OneObject {\n  template <class Space> struct Formats {};\n  template <class Real, class Formats> "
        "static constexpr std::array<FieldInfo, 1> fields = {{{\"x\", ElementType::" +
        type + ", 3, 0}}};\n};\n" + scene_of("PHYSGEN_ARRAY(per(1)) Array<OneObject, float> one;"));
  };
  for (const auto& [type, bytes] : {std::pair{"float32", 12},
                                    {"float64", 24},
                                    {"int32", 12},
                                    {"half", 6},
                                    {"bfloat16", 6},
                                    {"snorm16", 6},
                                    {"none", 0}}) {
    const auto declaration = read_field(type);
    ASSERT_TRUE(declaration.scene) << declaration.diagnostics;
    EXPECT_EQ(declaration.scene->groups[0].arrays[0].fields[0].bytes, bytes) << type;
  }
  const auto unknown = read_field("fixed24");
  EXPECT_FALSE(unknown.scene);
  EXPECT_NE(unknown.diagnostics.find("with a field in a format that this physgen does not know"), std::string::npos)
      << unknown.diagnostics;
}

TEST(SceneDeclaration, has_the_groups_of_what_it_derives_from_before_its_own) {
  const auto declaration = read(R"(
struct OfBody { struct Body { PHYSGEN_ARRAY(per("tet")) Array<SvdObject, float> svds; }; };
struct OfNodes { struct Nodes { PHYSGEN_ARRAY(per("node")) Array<SvdObject, double> nodes; }; };
struct OfBoth : OfBody, OfNodes {};
struct PHYSGEN_SCENE() scene : OfBoth {
  struct Level { PHYSGEN_ARRAY(per("edge")) Array<SvdObject, float> edges; };
  template <class On, class B, class N, class L> static void program(On& on, B& body, N& nodes, L& level);
};
)");
  ASSERT_TRUE(declaration.scene) << declaration.diagnostics;
  std::vector<std::string> arrays;
  for (const auto& group : declaration.scene->groups)
    for (const auto& array : group.arrays) arrays.push_back(group.full_name(array) + " " + array.real);
  EXPECT_EQ(arrays, (std::vector<std::string>{"body.svds float", "nodes.nodes double", "level.edges float"}));
}

TEST(SceneDeclaration, is_named_in_headers_by_the_folder_of_I_that_it_lies_in) {
  const Folder folder;
  folder.write("a/objects.h", objects);
  const std::string path = folder.write("a/b/scene.h", "#include \"objects.h\"\n" + scene_of(""));
  const auto text = "#include <objects.h>\n" + scene_of("PHYSGEN_ARRAY(per(1)) Array<SvdObject, float> x;");
  folder.write("a/b/scene.h", text);
  const auto declaration = scenes::read(path, {"-I", PHYSGEN_RUNTIME_INCLUDE, "-I" + (folder / "a")});
  ASSERT_TRUE(declaration.scene) << declaration.diagnostics;
  EXPECT_EQ(declaration.scene->include, "b/scene.h");
  const auto has = [&](const std::string& name) {
    return std::any_of(declaration.dependencies.begin(), declaration.dependencies.end(),
                       [&](const std::string& file) { return file.ends_with(name); });
  };
  EXPECT_TRUE(has("/objects.h") && has("/scene.h"));
}

const std::vector<Wrong> cases = {
    {"no_scene",
     "struct A {};\n",
     {"1:8: error: this file declares no scene; write 'struct PHYSGEN_SCENE() scene { ... };' with its groups of "
      "arrays and its program, as <physgen/scene.h> says"}},
    {"another_name",
     "struct PHYSGEN_SCENE() other { struct Body { " + svds +
         " }; \n"
         "template <class On, class B> static void program(On&, B&); };\n",
     {"1:24: error: scene 'other' stands in the file of 'scene'; give both one name, which the generated files get"}},
    {"two_scenes",
     scene_of(svds) + "struct PHYSGEN_SCENE() second {};\n",
     {"7:24: error: a file declares one scene; move 'second' to a file of its own"}},
    {"an_array_outside_of_groups",
     "struct PHYSGEN_SCENE() scene {\n" + svds + "\n};\n",
     {"1:24: error: scene 'scene' has no function template 'program'; write 'template <class On> static void "
      "program(On& on)'",
      "2:51: error: arrays stand in a group of their scene, which programs get as a whole; write 'struct Body { "
      "PHYSGEN_ARRAY(...) ...; };'"}},
    {"no_arrays",
     "struct PHYSGEN_SCENE() scene { template <class On> static void program(On&); };\n",
     {"1:24: error: scene 'scene' has no arrays; write a group, 'struct Body { PHYSGEN_ARRAY(per(\"tet\")) "
      "Array<elasticity::TetObject, Real> tets; };'"}},
    {"an_unmarked_member",
     scene_of(svds + " int n;"),
     {"3:61: error: 'n' is not marked as an array; write PHYSGEN_ARRAY(per(\"tet\"), ...) before it"}},
    {"no_program",
     scene_of(svds, ""),
     {"1:24: error: scene 'scene' has no function template 'program'; write 'template <class On, class Body> static "
      "void program(On& on, Body& body)'"}},
    {"too_few_parameters",
     scene_of(svds, "template <class On> static void program(On&);"),
     {"5:33: error: program takes an executor and a reference to each group, in their order, and is static; write "
      "'template <class On, class Body> static void program(On& on, Body& body)'"}},
    {"a_parameter_of_a_templates_type",
     scene_of(svds, "template <class On, class B> static void program(On&, B&, typename B::Real dt);"),
     {"5:76: error: a parameter of program behind its groups must not depend on a template's parameter; write a "
      "concrete type"}},
    {"no_set",
     scene_of("PHYSGEN_ARRAY() Array<SvdObject, float> svds;"),
     {"3:41: error: array 'svds' does not say how many objects it has; write PHYSGEN_ARRAY(per(\"tet\"), ...), or "
      "per(1) "
      "for one object"}},
    {"a_set_without_a_name",
     scene_of("PHYSGEN_ARRAY(per(\"a tet\")) Array<SvdObject, float> svds;"),
     {"3:15: error: array 'svds' has a per(...) that is neither a name nor a number of objects; write per(\"tet\"), "
      "with "
      "letters, digits and '_', or per(1)"}},
    {"an_option_twice",
     scene_of("PHYSGEN_ARRAY(per(1), per(2)) Array<SvdObject, float> svds;"),
     {"3:23: error: array 'svds' has this option twice; remove one of them"}},
    {"no_option",
     scene_of("PHYSGEN_ARRAY(per(1), 3) Array<SvdObject, float> svds;"),
     {"3:23: error: this is not an option; PHYSGEN_ARRAY takes per(...), input(...), output(...), uniform(), "
      "names(...), no_index(...) and follows(...)"}},
    {"an_unknown_field",
     scene_of("PHYSGEN_ARRAY(per(1), input(\"point.x\")) Array<SvdObject, float> svds;"),
     {"3:23: error: array 'svds' holds Svd; there is no field 'point.x'; did you mean 'points.x'?"}},
    {"a_uniform_output",
     scene_of("PHYSGEN_ARRAY(per(1), output(), uniform()) Array<SvdObject, float> svds;"),
     {"3:68: error: array 'svds' is uniform(), which programs only read, and an output; remove one of them"}},
    {"no_array",
     scene_of("PHYSGEN_ARRAY(per(1)) float svds;"),
     {"3:23: error: array 'svds' is not an array of objects; write 'Array<elasticity::TetObject, Real> svds;'"}},
    {"another_precision",
     scene_of("PHYSGEN_ARRAY(per(1)) Array<SvdObject, long double> svds;"),
     {"3:23: error: array 'svds' has the precision 'long double'; it is float or double"}},
};

class WrongDeclaration : public testing::TestWithParam<Wrong> {};
TEST_P(WrongDeclaration, is_reported) {
  const auto declaration = read(GetParam().text);
  EXPECT_FALSE(declaration.scene);
  EXPECT_EQ(errors_of(declaration.diagnostics), GetParam().expected) << declaration.diagnostics;
}
INSTANTIATE_TEST_SUITE_P(With, WrongDeclaration, testing::ValuesIn(cases),
                         [](const auto& info) { return info.param.name; });

TEST(SceneDeclaration, that_does_not_parse_has_clangs_errors) {
  const auto declaration = read(scene_of("PHYSGEN_ARRAY(per(1)) Array<AbsentObject, float> svds;"));
  EXPECT_FALSE(declaration.scene);
  EXPECT_NE(declaration.diagnostics.find("3:29: error: use of undeclared identifier 'AbsentObject'"), std::string::npos)
      << declaration.diagnostics;
}

}  // namespace
}  // namespace physgen::test
