// What the command writes, and where: over nothing that it reads, with a time that is no later than that of reading,
// and with an exit status that says when output was lost.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>

#include "command_case.h"

namespace physgen::test {
namespace {

namespace fs = std::filesystem;

const std::string sound_schema = schema_of(object("Scalar x;"));

using Outputs = Command;

TEST_F(Outputs, never_overwrite_what_is_read) {
  folder.write("a.h", "#include \"b.h\"\n" + schema_of(object("B b;")));
  folder.write("b.h", schema_of("struct PHYSGEN_OBJECT() B {\n  Scalar x;\n};\n"));
  const std::string a = text_of(folder / "a.h"), b = text_of(folder / "b.h");
  fs::create_symlink("b.h", folder / "link");
  for (const char* arguments :
       {"generate a.h -o out --stamp a.h", "generate a.h -o out --stamp s --depfile b.h",
        "generate a.h -o out --stamp ./out/../a.h", "generate a.h -o out --stamp link", "layout a.h --json -o a.h"}) {
    const auto outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_NE(outcome.err.find("it is an input, and would be lost; name another file"), std::string::npos)
        << arguments << '\n'
        << outcome.err;
  }
  EXPECT_EQ(text_of(folder / "a.h"), a);
  EXPECT_EQ(text_of(folder / "b.h"), b);
  EXPECT_FALSE(exists("out") || exists("s")) << "files were written before the error was found";
}

TEST_F(Outputs, are_different_files) {
  folder.write("a.h", sound_schema);
  for (const char* arguments :
       {"generate a.h -o out --stamp s --depfile ./s", "generate a.h -o out --stamp out/a.physgen.h"}) {
    const auto outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_NE(outcome.err.find("another output is written there; name another file"), std::string::npos) << outcome.err;
  }
  EXPECT_FALSE(exists("out") || exists("s"));
}

TEST_F(Outputs, of_usage_are_not_the_file_that_it_compares_with) {
  folder.write("a.cpp", "");
  folder.write("a.json", "{}");
  const auto outcome = run("usage a.cpp --json a.json --check a.json");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("cannot write 'a.json': it is an input, and would be lost"), std::string::npos)
      << outcome.err;
  EXPECT_EQ(text_of(folder / "a.json"), "{}");
}

TEST_F(Outputs, go_into_a_pipe_and_leave_it_a_pipe) {
  folder.write("a.h", sound_schema);
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  const int pipe = ::open((folder / "pipe").c_str(), O_RDWR | O_NONBLOCK);  // has a reader before physgen writes
  ASSERT_GE(pipe, 0);
  EXPECT_EQ(run("layout a.h --json -o pipe").status, 0);
  EXPECT_TRUE(fs::is_fifo(folder / "pipe"));
  std::string text(1 << 16, '\0');
  const auto length = ::read(pipe, text.data(), text.size());
  EXPECT_GT(length, 0) << "nothing came through the pipe";
  EXPECT_NE(text.find("\"physgen_layout\""), std::string::npos);
  ::close(pipe);
}

TEST_F(Outputs, that_cannot_all_be_printed_are_an_error) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  folder.write("a.h", sound_schema);
  for (const char* arguments : {"model a.h", "layout a.h", "check a.h", "--help"}) {
    run(std::string(arguments) + " > /dev/full 2> messages; echo $? > status; true");
    EXPECT_EQ(text_of(folder / "status"), "2\n") << arguments;
  }
}

// A schema that is saved while physgen reads it is newer than the stamp, so that Make and Ninja run physgen again.
TEST_F(Outputs, have_a_stamp_that_is_older_than_what_changes_while_physgen_reads) {
  std::string text = "#include <physgen/schema.h>\nnamespace m { using namespace physgen::schema;\n";
  for (int i = 0; i < 300; ++i)
    text += "struct PHYSGEN_OBJECT() A" + std::to_string(i) + " { Matrix<3, 3> x[4]; Vector<3> y; Scalar z; };\n";
  folder.write("a.h", text + "}\n");
  const auto before = fs::file_time_type::clock::now();
  ASSERT_EQ(run("generate a.h -o out --stamp s --depfile d").status, 0);
  const auto stamp = fs::last_write_time(folder / "s");
  EXPECT_GE(stamp, before);
  EXPECT_EQ(stamp, fs::last_write_time(folder / "out/a.physgen.h"));
  struct stat status{};
  ASSERT_EQ(::stat((folder / "out/a.physgen.h").c_str(), &status), 0);
  const auto written = std::chrono::seconds(status.st_ctim.tv_sec) + std::chrono::nanoseconds(status.st_ctim.tv_nsec);
  EXPECT_LT(fs::file_time_type::clock::to_sys(stamp).time_since_epoch(), written) << "reading began before writing";
}

}  // namespace
}  // namespace physgen::test
