// `physgen layout` as its users run it: a process with exit status, output and files.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <chrono>
#include <cstdlib>
#include <iterator>

#include "frontend/case.h"

namespace physgen::test {
namespace {

namespace fs = std::filesystem;

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class LayoutCommand : public testing::Test {
 protected:
  struct Outcome {
    int status;
    std::string out, err;
  };

  LayoutCommand() {
    folder.write("a.h",
                 schema_of("struct PHYSGEN_OBJECT(layout(cuda, aos_padded)) Node {\n  Vector<3> x;\n};\n"
                           "struct PHYSGEN_OBJECT() Tet {\n  PHYSGEN(format(cuda, half)) Matrix<3, 3> F;\n};\n"));
    folder.write("broken.h", schema_of(object("Scalar& x;")));
  }

  /// Runs `physgen layout` in the test's folder.
  Outcome run(const std::string& arguments) const {
    const std::string line = "cd '" + (folder / ".") + "' && '" PHYSGEN_COMMAND "' layout " + arguments + " > '" +
                             (streams / "out") + "' 2> '" + (streams / "err") + "'";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(streams / "out"), text_of(streams / "err")};
  }

  Folder folder, streams;
};

TEST_F(LayoutCommand, draws_all_objects_of_a_schema) {
  const auto outcome = run("a.h");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  for (const char* title : {"Node on host, aosoa(16), Real = float\n", "Node on cuda, aos_padded, Real = float\n",
                            "Tet on host, aosoa(16)", "Tet on cuda, aosoa(32)", "half"})
    EXPECT_NE(outcome.out.find(title), std::string::npos) << title;
}

TEST_F(LayoutCommand, draws_what_is_asked_for) {
  const auto outcome = run("a.h --object Tet --space cuda --real double --layout 'aosoa(8)'");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("m::Tet on cuda, aosoa(8), Real = double\n")) << outcome.out;
  EXPECT_EQ(outcome.out.find("Node"), std::string::npos);
}

TEST_F(LayoutCommand, writes_json_to_the_output_or_to_a_file_that_changed) {
  const auto outcome = run("a.h --json");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("{\n  \"physgen_layout\": 1,\n")) << outcome.out.substr(0, 100);
  const auto written = run("a.h --json -o new/a.json");
  EXPECT_EQ(written.status, 0) << written.err;
  EXPECT_EQ(written.out + written.err, "");
  EXPECT_EQ(text_of(folder / "new/a.json"), outcome.out);
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(1);
  fs::last_write_time(folder / "new/a.json", long_ago);
  EXPECT_EQ(run("a.h --json -o new/a.json").status, 0);
  EXPECT_EQ(fs::last_write_time(folder / "new/a.json"), long_ago);
  EXPECT_EQ(run("a.h --json -o new/a.json --real double").status, 0);
  EXPECT_GT(fs::last_write_time(folder / "new/a.json"), long_ago);
}

TEST_F(LayoutCommand, says_how_to_draw_an_svg) {
  for (const char* arguments : {"a.h --svg", "a.h --svg -o a.svg"}) {
    const auto outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(
        outcome.err,
        "physgen: error: physgen cannot draw SVG; write '--json -o x.json' in place of --svg, and draw x.json with "
        "'tools/report/layout_picture.py x.json -o x.svg' of physgen's sources\n");
  }
  EXPECT_EQ(run("--help").out.find("svg"), std::string::npos);
}

TEST_F(LayoutCommand, refuses_wrong_use) {
  for (const char* arguments :
       {"", "a.h a.h", "a.h --object Edge", "a.h --space gpu", "a.h --real half", "a.h --layout x",
        "a.h --layout 'aosoa(3)'", "a.h -o a.json", "missing.h", "a.h --json -o a.h/x.json"}) {
    const auto outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_NE(outcome.err, "") << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
  }
  EXPECT_EQ(run("a.h --object Edge").err, "physgen: error: there is no object 'Edge' in a.h; it declares Node, Tet\n");
}

TEST_F(LayoutCommand, writes_nothing_when_the_schema_has_errors) {
  const auto outcome = run("broken.h --json -o x.json");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("broken.h:4:3: error: field 'x' is a reference"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(folder / "x.json"));
}

}  // namespace
}  // namespace physgen::test
