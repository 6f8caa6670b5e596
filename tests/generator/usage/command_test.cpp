// `physgen usage` as its users run it.
#include <gtest/gtest.h>

#include "command_case.h"
#include "small.h"
#include "usage/json.h"

namespace physgen::test {
namespace {

/// A program with one kernel, whose call operator has this body.
std::string program(const std::string& body) {
  return small_probes + "struct K { V<A> a; V<B> b; void operator()(int i) const {\n" + body +
         "\n} };\nvoid f() { run(K{}); }\n";
}
const std::string sound_program = program("b.put(a.get());");

class UsageCommand : public Command {
 protected:
  UsageCommand() { folder.write("a.cpp", sound_program); }
};

TEST_F(UsageCommand, prints_a_table_and_the_time_of_each_side) {
  const auto outcome = run("usage a.cpp --side host");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("  K(a, b)  small.cpp:1:8\n"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("    a      7      R    small.cpp:2:9\n"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("    b      7       W   small.cpp:2:3\n"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("a.cpp, host: analysed in "), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("device"), std::string::npos) << outcome.out;
}

TEST_F(UsageCommand, writes_json_of_all_files) {
  folder.write("sub/b.cpp", program("a.put(b.get());"));
  const auto outcome = run("usage a.cpp sub/b.cpp --side host --json out/usage.json");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const auto programs = usage::from_json(text_of(folder / "out/usage.json"));
  ASSERT_EQ(programs.size(), 2U);
  EXPECT_EQ(programs[0].name, "a.cpp");
  EXPECT_EQ(programs[1].name, "b.cpp");
  EXPECT_TRUE(programs[1].usage.steps.at(0).fields.at(0).written);
}

TEST_F(UsageCommand, takes_flags_of_a_compiler) {
  folder.write("include/body.h", "a.get();\n");
  folder.write("a.cpp", program("#ifdef READS\n#include <body.h>\n#endif"));
  const auto outcome = run("usage a.cpp --side host -- -I include -DREADS");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find(" R "), std::string::npos) << outcome.out;
  EXPECT_EQ(run("usage a.cpp --side host -- -I include").out.find(" R "), std::string::npos);
}

TEST_F(UsageCommand, finds_headers_beside_the_file_and_those_of_the_runtime) {
  folder.write("beside.h", sound_program);
  folder.write("b.cpp", "#include \"beside.h\"\n#include <physgen/config.h>\nphysgen::index_t n;\n");
  const auto outcome = run("usage b.cpp --side host");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("K(a, b)"), std::string::npos) << outcome.out;
}

TEST_F(UsageCommand, accepts_what_is_checked_in_and_names_what_is_stale) {
  ASSERT_EQ(run("usage a.cpp --side host --json usage.json").status, 0);
  const auto same = run("usage a.cpp --side host --check usage.json");
  EXPECT_EQ(same.status, 0) << same.err;
  EXPECT_EQ(same.err, "");
  EXPECT_EQ(same.out.find("K(a, b)"), std::string::npos) << "only the times are printed";
  folder.write("a.cpp", program("b.put(a.get()); a.put(1);"));
  const auto stale = run("usage a.cpp --side host --check usage.json -- -DX=1");
  EXPECT_EQ(stale.status, 1);
  EXPECT_EQ(stale.err,
            "usage.json: error: it is stale:\n"
            "  a.cpp: K(a, b): a.7: places: small.cpp:2:9, small.cpp:2:19; in the file: small.cpp:2:9\n"
            "  a.cpp: K(a, b): a.7: written: yes; in the file: no\n"
            "note: to renew it: physgen usage a.cpp --json usage.json --side host -- -DX=1\n");
  ASSERT_EQ(run("usage a.cpp --json usage.json --side host -- -DX=1").status, 0);
  EXPECT_EQ(run("usage a.cpp --side host --check usage.json").status, 0);
  folder.write("usage.json", "{}");
  const auto other = run("usage a.cpp --side host --check usage.json");
  EXPECT_EQ(other.status, 1);
  EXPECT_NE(other.err.find("usage.json: error: it is stale:\n  it has no 'format'\n"), std::string::npos) << other.err;
}

TEST_F(UsageCommand, writes_nothing_when_a_file_has_errors) {
  folder.write("b.cpp", program("a.got();"));
  folder.write("usage.json", "old");
  const auto outcome = run("usage a.cpp b.cpp --side host --json usage.json");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("small.cpp:2:3: error: no member named 'got'"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.out.find("K(a, b)"), std::string::npos) << outcome.out;
  EXPECT_EQ(text_of(folder / "usage.json"), "old");
}

TEST_F(UsageCommand, shows_errors_at_their_place_in_the_file_that_was_given) {
  folder.write("b.cpp", "int x;\nint y = z;\n");
  EXPECT_NE(run("usage b.cpp --side host").err.find("b.cpp:2:9: error: use of undeclared identifier 'z'"),
            std::string::npos);
}

TEST_F(UsageCommand, refuses_what_it_cannot_follow) {
  folder.write("b.cpp", program("a.data()[i] = 1;"));
  const auto outcome = run("usage b.cpp --side host");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err,
            "small.cpp:2:3: error: data() may use any field of a in any way; use its fields by name, or declare all of "
            "them as input() and output() of a scene\n");
}

TEST_F(UsageCommand, says_how_to_write_a_scene_where_there_is_none) {
  folder.write("b.cpp", "int x;\n");
  const auto outcome = run("usage b.cpp --side host");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err,
            "b.cpp: error: this file has no scene and gives no steps to a ProbeExecutor; declare a scene "
            "as <physgen/scene.h> says, or write a program over probes as <physgen/probe.h> says\n");
  folder.write("c.h", "// PHYSGEN_SCENE\nint x;\n");
  const auto marked = run("usage c.h --side host");
  EXPECT_EQ(marked.status, 1);
  EXPECT_NE(marked.err.find("error: this file declares no scene; write 'struct PHYSGEN_SCENE() c"), std::string::npos)
      << marked.err;
}

TEST_F(UsageCommand, refuses_wrong_use) {
  EXPECT_EQ(run("usage").status, 2);
  EXPECT_EQ(run("usage a.cpp --side nowhere").status, 2);
  const auto missing = run("usage not_there.cpp");
  EXPECT_EQ(missing.status, 2);
  EXPECT_NE(missing.err.find("cannot read 'not_there.cpp'"), std::string::npos) << missing.err;
  EXPECT_EQ(run("usage a.cpp --check not_there.json").status, 2);
}

}  // namespace
}  // namespace physgen::test
