// The command physgen as its users run it: a process with exit status, output and files.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>

#include "command_case.h"

namespace physgen::test {
namespace {

namespace fs = std::filesystem;

const std::string sound = schema_of(object("Scalar x;"));
const std::string broken = schema_of(object("Scalar& x;"));

TEST_F(Command, generates_a_header_per_schema) {
  folder.write("a.h", sound);
  folder.write("sub/b.schema.h", sound);
  const auto outcome = run("generate a.h sub/b.schema.h -o new/out");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out + outcome.err, "");
  EXPECT_EQ(files("new/out"), (std::vector<std::string>{"a.physgen.h", "b.schema.physgen.h"}));
}

TEST_F(Command, writes_sources_of_python_modules_as_well) {
  folder.write("a.h", sound);
  const auto outcome = run("generate a.h -o out --python --layout soa");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(files("out"), (std::vector<std::string>{"a.physgen.h", "a.python.cpp"}));
  EXPECT_NE(text_of(folder / "out/a.python.cpp").find(", physgen::Soa, physgen::Soa>("), std::string::npos);
  folder.write("a-b.h", sound);
  EXPECT_EQ(run("generate a-b.h -o out").status, 0);
  EXPECT_EQ(run("generate a-b.h -o other --python").status, 1);
  EXPECT_FALSE(exists("other"));
}

TEST_F(Command, takes_schemas_without_the_word_generate) {
  folder.write("a.h", sound);
  EXPECT_EQ(run("a.h -o x").status, 0);
  EXPECT_EQ(run("-o y a.h").status, 0);
  EXPECT_EQ(run("generate a.h -o z").status, 0);
  EXPECT_EQ(text_of(folder / "x/a.physgen.h"), text_of(folder / "z/a.physgen.h"));
  EXPECT_EQ(text_of(folder / "y/a.physgen.h"), text_of(folder / "z/a.physgen.h"));
}

TEST_F(Command, writes_the_same_text_from_every_folder) {
  folder.write("a.h", sound);
  ASSERT_EQ(run("a.h -o x").status, 0);
  ASSERT_EQ(run("'" + (folder / "a.h") + "' -o '" + (folder / "y") + "'").status, 0);
  EXPECT_EQ(text_of(folder / "x/a.physgen.h"), text_of(folder / "y/a.physgen.h"));
  EXPECT_EQ(text_of(folder / "x/a.physgen.h").find(folder / ""), std::string::npos) << "an absolute path";
  EXPECT_EQ(run("model a.h").out, run("model '" + (folder / "a.h") + "'").out);
}

TEST_F(Command, writes_nothing_when_any_schema_has_errors) {
  folder.write("a.h", sound);
  folder.write("b.h", broken);
  folder.write("c.h", broken);
  folder.write("out/a.physgen.h", "old");
  const auto outcome = run("generate a.h b.h c.h -o out --stamp stamp --depfile d");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("b.h:4:3: error: field 'x' is a reference"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("c.h:4:3: error: field 'x' is a reference"), std::string::npos) << outcome.err;
  EXPECT_EQ(files("out"), std::vector<std::string>{"a.physgen.h"});
  EXPECT_EQ(text_of(folder / "out/a.physgen.h"), "old");
  EXPECT_FALSE(exists("stamp") || exists("d"));
  EXPECT_EQ(run("generate b.h -o not_made").status, 1);
  EXPECT_FALSE(exists("not_made"));
}

TEST_F(Command, does_not_touch_an_unchanged_header) {
  folder.write("a.h", sound);
  ASSERT_EQ(run("a.h -o out --stamp stamp").status, 0);
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(1);
  fs::last_write_time(folder / "out/a.physgen.h", long_ago);
  fs::last_write_time(folder / "stamp", long_ago);
  const auto unchanged = run("generate a.h -o out --stamp stamp --verbose");
  EXPECT_EQ(unchanged.out, "unchanged out/a.physgen.h\n");
  EXPECT_EQ(fs::last_write_time(folder / "out/a.physgen.h"), long_ago);
  EXPECT_GT(fs::last_write_time(folder / "stamp"), long_ago) << "the stamp says that physgen has run";
  folder.write("a.h", schema_of(object("Scalar y;")));
  EXPECT_EQ(run("generate a.h -o out --verbose").out, "written   out/a.physgen.h\n");
  EXPECT_GT(fs::last_write_time(folder / "out/a.physgen.h"), long_ago);
}

TEST_F(Command, refuses_an_output_folder_that_cannot_be_made_or_written) {
  folder.write("a.h", sound);
  folder.write("file", "");
  auto outcome = run("generate a.h -o file/out");  // below a regular file: not even root can
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("physgen: error: cannot make the folder 'file/out': Not a directory"), std::string::npos)
      << outcome.err;
  outcome = run("generate a.h -o file");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("'file'"), std::string::npos) << outcome.err;
  EXPECT_EQ(text_of(folder / "file"), "");
}

TEST_F(Command, leaves_no_half_written_files_when_one_of_them_fails) {
  folder.write("a.h", sound);
  folder.write("b.h", sound);
  fs::create_directories(folder / "out/b.physgen.h");  // a folder where a header should be
  const auto outcome = run("generate a.h b.h -o out --stamp stamp");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("cannot write 'out/b.physgen.h': Is a directory"), std::string::npos) << outcome.err;
  EXPECT_EQ(files("out"), std::vector<std::string>{"b.physgen.h"});
  EXPECT_FALSE(exists("stamp"));
  folder.write("file", "");
  EXPECT_EQ(run("generate a.h -o out --stamp stamp --depfile file/d").status, 2);
  EXPECT_EQ(files("out"), std::vector<std::string>{"b.physgen.h"});
}

TEST_F(Command, refuses_two_schemas_that_would_write_one_header) {
  folder.write("x/a.h", sound);
  folder.write("y/a.hpp", sound);
  const auto outcome = run("generate x/a.h y/a.hpp -o out");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err,
            "physgen: error: 'x/a.h' and 'y/a.hpp' would both write 'a.physgen.h'; rename one, or generate them into "
            "different folders\n");
  EXPECT_FALSE(exists("out"));
}

TEST_F(Command, refuses_an_empty_output_folder_and_a_schema_given_twice) {
  folder.write("a.h", sound);
  const auto empty = run("generate a.h -o ''");
  EXPECT_EQ(empty.status, 2);
  EXPECT_EQ(empty.err, "physgen: error: the folder given with -o is empty; write -o . for this folder\n");
  const auto twice = run("generate a.h a.h -o out");
  EXPECT_EQ(twice.status, 2);
  EXPECT_EQ(twice.err, "physgen: error: 'a.h' is given twice\n");
  EXPECT_FALSE(exists("out"));
}

TEST_F(Command, says_which_file_it_cannot_read) {
  folder.write("a.h", sound);
  auto outcome = run("generate a.h missing.h -o out");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "physgen: error: cannot read 'missing.h': No such file or directory\n");
  EXPECT_FALSE(exists("out"));
  outcome = run("check .");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "physgen: error: cannot read '.': Is a directory\n");
}

TEST_F(Command, says_what_an_empty_file_needs) {
  folder.write("a.h", "");
  const auto outcome = run("generate a.h -o out");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("a.h:1:1: error: this schema declares no object"), std::string::npos) << outcome.err;
  EXPECT_FALSE(exists("out"));
}

TEST_F(Command, lists_what_the_stamp_depends_on) {
  folder.write("a.h", "#include \"odd #1 $name.h\"\n#include \"b.h\"\n" + schema_of(object("B b;")));
  folder.write("odd #1 $name.h", "#pragma once\n#include \"b.h\"\n");
  folder.write("inc/b.h", "#pragma once\n" + schema_of("struct PHYSGEN_OBJECT() B {\n  Scalar x;\n};\n"));
  folder.write("c.h", "#include \"b.h\"\n" + schema_of(object("B b;")));
  const auto outcome = run("generate a.h c.h -o out -I inc --depfile 'some dir/d' --stamp 'some dir/stamp'");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(text_of(folder / "some dir/d"),
            "some\\ dir/stamp: \\\n  a.h \\\n  odd\\ \\#1\\ $$name.h \\\n  inc/b.h \\\n  c.h\n");
  EXPECT_TRUE(exists("some dir/stamp"));
}

TEST_F(Command, checks_without_writing) {
  folder.write("a.h", sound);
  folder.write("b.h", broken);
  EXPECT_EQ(run("check a.h").out, "a.h: 1 objects, 1 fields\n");
  EXPECT_EQ(run("check a.h").status, 0);
  EXPECT_EQ(run("check a.h b.h").status, 1);
  EXPECT_EQ(files("."), (std::vector<std::string>{"a.h", "b.h"}));
}

TEST_F(Command, prints_the_model_as_json) {
  folder.write("a.h", sound);
  const auto outcome = run("model a.h");
  EXPECT_EQ(outcome.status, 0);
  const auto schema = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(schema.at("file"), "a.h");
  EXPECT_EQ(schema.at("objects").at(0).at("fields").at(0).at("name"), "x");
  folder.write("b.h", broken);
  EXPECT_EQ(run("model b.h").status, 1);
  EXPECT_EQ(run("model b.h").out, "");
}

TEST_F(Command, generates_what_a_schema_would_that_states_the_layout_itself) {
  struct Case {
    const char *argument, *host, *cuda;
  };
  // In each: an object without a layout, one with others, one that states its own alignment.
  const auto schema = [](const std::string& first, const std::string& second, const std::string& third) {
    return schema_of("struct PHYSGEN_OBJECT(" + first + ") A { Scalar x; Matrix<3, 3> F; };\n" +
                     "struct PHYSGEN_OBJECT(" + second + ") B { Vector<3> v; };\n" + "struct PHYSGEN_OBJECT(" + third +
                     ") C { A a[2]; Index i; };\n");
  };
  for (const Case& one :
       {Case{"aos", "aos", "aos"}, Case{"aos_padded", "aos_padded", "aos_padded"}, Case{"soa", "soa", "soa"},
        Case{"aosoa", "aosoa(16)", "aosoa(32)"}, Case{"'aosoa(8)'", "aosoa(8)", "aosoa(8)"}}) {
    const std::string layouts = "layout(host, " + std::string(one.host) + "), layout(cuda, " + one.cuda + ")";
    folder.write("given/a.h", schema("", "layout(host, soa), layout(cuda, aos_padded)", "align(64)"));
    folder.write("stated/a.h", schema(layouts, layouts, layouts + ", align(64)"));
    const auto outcome = run(std::string("generate given/a.h -o by_option --layout ") + one.argument);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    ASSERT_EQ(run("generate stated/a.h -o by_schema").status, 0);
    ASSERT_EQ(run("generate given/a.h -o untouched").status, 0);
    EXPECT_EQ(text_of(folder / "by_option/a.physgen.h"), text_of(folder / "by_schema/a.physgen.h")) << one.argument;
    EXPECT_NE(text_of(folder / "by_option/a.physgen.h"), text_of(folder / "untouched/a.physgen.h")) << one.argument;
  }
}

TEST_F(Command, refuses_layouts_that_do_not_exist_and_says_which_do) {
  folder.write("a.h", sound);
  for (const char* layout : {"aoss", "schema", "all", "''", "'soa(4)'"}) {
    const auto outcome = run(std::string("generate a.h -o out --layout ") + layout);
    EXPECT_EQ(outcome.status, 2) << layout;
    EXPECT_NE(outcome.err.find("write aos, aos_padded, soa, 'aosoa(32)' or aosoa"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(run("generate a.h -o out --layout 'aosoa(3)'").status, 2);
  EXPECT_FALSE(exists("out"));
}

TEST_F(Command, refuses_wrong_use) {
  folder.write("a.h", sound);
  for (const char* arguments : {"", "generate", "generate a.h", "generate -o out", "a.h", "generate a.h -o out --bogus",
                                "generate a.h -o out --depfile d", "model a.h a.h", "check", "--bogus"}) {
    const auto outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_NE(outcome.err, "") << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
  }
  EXPECT_EQ(files("."), std::vector<std::string>{"a.h"});
}

TEST_F(Command, says_that_there_is_no_such_command_or_schema) {
  folder.write("a.h", sound);
  for (const char* arguments : {"foo", "foo -o out", "genrate a.h -o out"}) {
    const auto outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_EQ(outcome.err.substr(0, 48),
              "physgen: error: there is no command or schema '" + std::string(1, arguments[0]))
        << outcome.err;
  }
}

TEST_F(Command, explains_itself) {
  EXPECT_EQ(run("--help").status, 0);
  EXPECT_NE(run("--help").out.find("generate"), std::string::npos);
  EXPECT_EQ(run("generate --help").status, 0);
  EXPECT_EQ(run("--version").out.substr(0, 8), "physgen ");
  EXPECT_EQ(run("--version").status, 0);
}

// ---- Speed is printed, and judged by people: test machines differ. --------------------------------------------------

double best_of(int times, const std::function<void()>& work) {
  double best = 1e9;
  for (int i = 0; i < times; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  return best;
}

TEST_F(Command, generates_the_shipped_schemas_and_prints_the_time) {
  for (const auto& entry : fs::directory_iterator(PHYSGEN_SCHEMAS)) {
    if (entry.path().extension() != ".h") continue;
    const double seconds =
        best_of(5, [&] { EXPECT_EQ(run("generate '" + entry.path().string() + "' -o out").status, 0); });
    std::printf("physgen %s: %.1f ms (goal: 60)\n", entry.path().filename().c_str(), 1e3 * seconds);
  }
}

TEST_F(Command, generates_a_thousand_objects_and_prints_the_time) {
  std::string text;
  for (int i = 0; i < 1000; ++i)
    text += "/// Object.\nstruct PHYSGEN_OBJECT(layout(host, aosoa(16))) Object" + std::to_string(i) +
            "x {\n  PHYSGEN(unit(\"Pa\")) Scalar a, b, c;  ///< stress\n  Matrix<3, 3> F;\n};\n";
  folder.write("a.h", schema_of(text));
  const double seconds = best_of(2, [&] { EXPECT_EQ(run("generate a.h -o out").status, 0); });
  std::printf("physgen, 1000 objects: %.2f s (goal: 2)\n", seconds);
}

}  // namespace
}  // namespace physgen::test
