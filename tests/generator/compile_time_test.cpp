// How much work generated code makes for compilers: one object of 1000 scalars against 10 objects of 100, each read and
// written as a whole by a kernel in a loop. The times are printed. What is checked is what the compiler counts itself,
// the same on every machine: instantiated functions, their names, which grow with the depth of templates, and the
// memory that the compiler took.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "emit/emitter.h"
#include "models.h"

namespace physgen {
namespace {

// Writes a header with `objects` objects of `scalars` scalars and a source with a kernel for each.
std::filesystem::path write_source(const std::filesystem::path& folder, int objects, int scalars) {
  model::Schema schema = test::schema({});
  schema.file = "of" + std::to_string(scalars) + ".h";
  const emit::Emitter& emitter = emit::emitter("cpp");
  const std::string header = emit::file_of(emitter, schema.file);
  std::string kernels = "#include <physgen/runtime.h>\n#include \"" + header + "\"\n";
  for (int o = 0; o < objects; ++o) {
    const std::string name = "Object" + std::to_string(o);
    schema.objects.push_back(test::object(name, {}));
    for (int f = 0; f < scalars; ++f) schema.objects.back().fields.push_back(test::scalar("x" + std::to_string(f)));
    const std::string view = "test::" + name + "View<float, physgen::Aosoa<16>>";
    kernels += "void run(const " + view + "& from, const " + view + "& to) {\n" +
               "  for (physgen::index_t i = 0; i < from.size(); ++i) {\n" +
               "    auto value = from.get(i);\n    value.x0 += value.x1;\n    to.put(i, value);\n  }\n}\n";
  }
  std::ofstream(folder / header) << emitter.emit(schema);
  const std::filesystem::path source = folder / ("of" + std::to_string(scalars) + ".cpp");
  std::ofstream(source) << kernels;
  return source;
}

std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

struct Work {
  double functions = 0;
  double names = 0;   // characters of the functions' names
  double memory = 0;  // [MiB]
  double seconds = 0;
};

// Without optimisation, so that every function is there to be counted; and without collecting what is no longer needed,
// so that the most memory that g++ has is all that it ever takes.
Work compile(const std::filesystem::path& source) {
  const std::string assembly = source.string() + ".s", said = source.string() + ".said";
  const std::string command = "exec \"" PHYSGEN_COMPILER "\" -std=c++20 -O0 " PHYSGEN_NO_COLLECTION
                              " -I\"" PHYSGEN_RUNTIME_INCLUDE "\" -isystem \"" PHYSGEN_EIGEN_INCLUDE "\" -S \"" +
                              source.string() + "\" -o \"" + assembly + "\" 2> \"" + said + "\"";
  const auto begin = std::chrono::steady_clock::now();
  const pid_t child = ::fork();
  if (child == 0) {
    ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    ::_exit(127);
  }
  int status = 0;
  rusage used{};
  if (::wait4(child, &status, 0, &used) != child || status != 0)
    throw std::runtime_error("failed: " + command + "\n" + text_of(said));
  Work work;
  work.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  work.memory = static_cast<double>(used.ru_maxrss) / 1024;
  std::ifstream in(assembly);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("_Z") || line.find(':') == std::string::npos) continue;
    ++work.functions;
    work.names += static_cast<double>(line.find(':'));
  }
  return work;
}

TEST(CompileTime, one_object_of_1000_scalars_is_no_more_work_than_10_objects_of_100) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / ("physgen_compile_time_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  Work one = compile(write_source(folder, 1, 1000)), ten = compile(write_source(folder, 10, 100));
  const std::filesystem::path nothing = folder / "nothing.cpp";
  std::ofstream(nothing) << "int nothing;\n";
  const double by_itself = compile(nothing).memory;  // the compiler's program, whatever it reads
  for (Work* work : {&one, &ten}) work->memory -= by_itself;
  std::filesystem::remove_all(folder);
  for (const auto& [what, work] : {std::pair("1 x 1000 scalars: ", one), std::pair("10 x 100 scalars: ", ten)})
    std::cout << what << work.functions << " functions, " << work.names << " characters of their names, " << work.memory
              << " MiB, " << work.seconds << " s\n";
  ASSERT_GT(ten.memory, 0);
  ASSERT_GT(one.functions, 1000) << "the accessors are not there to be counted";
  EXPECT_LE(one.functions, 1.1 * ten.functions);
  EXPECT_LE(one.names, 1.2 * ten.names);
  EXPECT_LE(one.memory, 1.2 * ten.memory);
}

#ifdef PHYSGEN_CLANG
TEST(CompileTime, clang_takes_objects_of_more_fields_than_its_folds_may_have_arguments) {  // which are 256
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / ("physgen_many_fields_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const std::filesystem::path source = write_source(folder, 1, 300);
  std::ofstream(source, std::ios::app) << "physgen::UntypedArray untyped(const test::Object0Array<float>& array) {\n"
                                          "  return array.untyped();\n}\n";
  for (const char* mode : {"", " -DPHYSGEN_CHECKED"}) {
    const std::string command = "\"" PHYSGEN_CLANG "\" -std=c++20 -fsyntax-only -I\"" PHYSGEN_RUNTIME_INCLUDE
                                "\" -isystem \"" PHYSGEN_EIGEN_INCLUDE "\" \"" +
                                source.string() + "\"" + mode;
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
  }
  std::filesystem::remove_all(folder);
}
#endif

}  // namespace
}  // namespace physgen
