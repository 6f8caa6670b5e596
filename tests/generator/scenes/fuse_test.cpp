// `physgen scene` over a program with neighbouring steps of many kinds: which become one, and why the others do not;
// and that what is written compiles, while the scene's own program over arrays that hold no memory does not.
#include <gtest/gtest.h>

#include "fuse_case.h"
#include "fuse_kernels.h"

namespace physgen::test {
namespace {

const std::vector<Block> blocks = {
    {"one", "on.run(n, Copy{in, M});\n    // A comment stays.\n    on.run(n, CopyBack{M, OUT});", "\"a\", \"x\""},
    {"three",
     "on.run(n, Copy{in, M});\n    const auto further = body.further.view();\n"
     "    on.run(n, CopyVector{M, further});\n    on.run(n, CopyVector{further, OUT});",
     "\"x\""},
    {"gathered", "on.run(n, Copy{in, M});\n    on.run(n, Gather{links, M, OUT});", "\"a\""},
    {"scattered", "on.run(n, Scatter{links, in, M});\n    on.run(n, Shift{1, M, OUT});", "\"a\""},
    {"otherset",
     "on.run(n, Copy{in, M});\n    on.run(body.few.size(), CopyVector{M, body.few.view()});\n"
     "    on.run(body.few.size(), CopyVector{body.few.view(), OUT});",
     "\"x\""},
    {"single", "on.run(n, Copy{in, M});\n    on.run(n, CopyOne{M, OUT});", "\"a\""},
    {"some", "on.run(n, CopySome{in, M});\n    on.run(n, Shift{1, M, OUT});", "\"a\""},
    {"masked", "on.run(n, Copy{in, M});\n    on.run(n, Limit{M});\n    on.run(n, Shift{1, M, OUT});", "\"a\""},
    {"element", "on.run(n, CopyElement{in, M});\n    on.run(n, CopyVector{M, OUT});", "\"x\""},
    {"index", "on.run(n, CopyByIndex{in, M});\n    on.run(n, Shift{1, M, OUT});", "\"a\""},
    {"leave", "on.run(n, CopyOrLeave{in, M});\n    on.run(n, Shift{1, M, OUT});", "\"a\""},
    {"pointer", "on.run(n, CopyRemembering{&last, in, M});\n    on.run(n, Shift{1, M, OUT});", "\"a\""},
    {"variable", "on.run(n, CopyCounting{in, M});\n    on.run(n, Shift{1, M, OUT});", "\"a\""},
    {"reduced",
     "on.run(n, Copy{in, M});\n    on.reduce(n, Value{M}, physgen::Sum{}, Keep{body.sum.view()});\n"
     "    on.run(n, CopyBack{M, OUT});",
     "\"a\", \"x\""},
    {"host", "on.run(n, Copy{in, M});\n    const float s = on.value(body.sum).a;\n    on.run(n, Shift{s, M, OUT});",
     "\"a\""},
    {"called", "on.run(n, Copy{in, M});\n    on.run(n, Shift{told(2), M, OUT});", "\"a\""},
    {"held", "const auto& held = body.m_held;\n    on.run(n, Copy{in, M});\n    on.run(n, CopyBack{M, OUT});",
     "\"a\", \"x\""},
};

/// The messages of a compiler on a program over the generated arrays.
std::string compile(const Folder& folder, const std::string& compiler, const std::string& program) {
  folder.write("unit.cpp",
               "#include <physgen/executor.h>\n#include \"out/groups.program.h\"\n"
               "void run(physgen::HostExecutor& on, groups_scene::Body<>& body) { " +
                   program + "::program(on, body); }\n");
  const std::string said = folder / "said";
  const std::string line = "cd '" + (folder / ".") + "' && LC_ALL=C " + compiler +
                           " -std=c++20 -fsyntax-only -w -I. -Igenerated " PHYSGEN_FLAGS " unit.cpp 2> said";
  return std::system(line.c_str()) == 0 ? "" : text_of(said);
}

class FusedScene : public Command {
 protected:
  void SetUp() override {
    folder.write("particles.h", particles_schema);
    folder.write("kernels.h", particles_kernels);
    folder.write("scenes/groups.h", scene_of(blocks));
    ASSERT_EQ(run("generate particles.h -o generated").status, 0);
  }
};

TEST_F(FusedScene, joins_what_can_be_joined_says_why_the_rest_is_not_and_compiles) {
  const auto outcome = run("scene scenes/groups.h -o out -- -I. -Igenerated " PHYSGEN_FLAGS);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto needs = nlohmann::json::parse(text_of(folder / "out/groups.need.json"));
  std::vector<std::string> locals;
  for (const auto& group : needs.at("groups"))
    for (const auto& local : group.at("locals")) locals.push_back(local.at("array"));
  EXPECT_EQ(locals, (std::vector<std::string>{"body.m_one", "body.further", "body.m_three", "body.few"}))
      << needs.at("groups");
  auto [why, between] = apart_of(needs, blocks, folder / "");
  EXPECT_EQ(why.size(), blocks.size() - 2) << "all but the first two";
  for (const auto& [name, reason] : std::map<std::string, std::string>{
           {"gathered", "Gather reads body.m_gathered.a of other objects than its own, kernels.h:"},
           {"scattered", "Scatter adds to body.m_scattered.a of other objects than its own, kernels.h:"},
           {"otherset", "they run over different objects, per particle of body and per few of body; "},
           {"single", "CopyOne cannot take packs, since its call operator takes single objects alone; "},
           {"some", "no earlier step of the group is sure to store all of body.m_some.a, which Shift reads; "},
           {"masked", "Limit: it holds 'physgen::store_where("},
           {"element",
            "no earlier step of the group is sure to store all of body.m_element.x, which CopyVector reads; "},
           {"index", "CopyByIndex: it chooses its code by types at kernels.h:"},
           {"leave", "CopyOrLeave: it holds '({...' at kernels.h:"},
           {"pointer",
            "CopyRemembering: its remembered is neither a number nor a view of the scene's arrays, at kernels.h:"},
           {"variable", "CopyCounting: it uses the variable 'last' at kernels.h:"},
           {"reduced", "'on.reduce(n, Value{"},
           {"host", "the declaration of s by 'on.value(body.sum).a' at scenes/groups.h:"},
           {"called", "Shift: it is given 'told(2)' at scenes/groups.h:"},
           {"held", "body.m_held is stored: the program does more than hand its views to kernels at scenes/groups.h:"}})
    EXPECT_NE(why[name].find(reason), std::string::npos) << name << ": " << why[name];
  for (const auto& [name, fields] : std::map<std::string, std::string>{{"gathered", "body.m_gathered.a; "},
                                                                       {"single", "body.m_single.a; "},
                                                                       {"held", "body.m_held.a; body.m_held.x; "}})
    EXPECT_EQ(between[name], fields) << name;
  EXPECT_NE(text_of(folder / "out/groups.need.txt").find("    stored between them: body.m_single.a\n"),
            std::string::npos);

  const std::string program = text_of(folder / "out/groups.program.h");
  EXPECT_NE(program.find("    {\n    // A comment stays.\n    on.run(n, ::physgen::fuse(\n"
                         "        ::physgen::locals(body.m_one.view()),\n"
                         "        Copy{in, body.m_one.view()},\n"
                         "        CopyBack{body.m_one.view(), body.out_one.view()}));\n    }\n"),
            std::string::npos)
      << program;
  EXPECT_EQ(compile(folder, PHYSGEN_COMPILER, "groups_scene::fused"), "");
  EXPECT_NE(
      compile(folder, PHYSGEN_COMPILER, "groups").find("a local of fuse() has the objects at the kernel's own index"),
      std::string::npos)
      << "the program with separate steps has no memory for what is between them";
}

}  // namespace
}  // namespace physgen::test
