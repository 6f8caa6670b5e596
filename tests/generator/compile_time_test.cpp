// How long generated code takes to compile: one object of 1000 scalars against 10 objects of 100, each read and written
// as a whole by a kernel in a loop. Prints the times and checks their ratio: how long a machine takes is no reason to
// fail, that large objects cost more than their share is one.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "emit/emitter.h"
#include "models.h"

namespace physgen {
namespace {

// Writes a header with `objects` objects of `scalars` scalars and a source with a kernel for each.
std::filesystem::path write_source(const std::filesystem::path& folder, int objects, int scalars) {
  model::Schema schema = test::schema({});
  schema.file = "of" + std::to_string(scalars) + ".h";
  std::string kernels = "#include <physgen/runtime.h>\n#include \"" + model::generated_header(schema.file) + "\"\n";
  for (int o = 0; o < objects; ++o) {
    const std::string name = "Object" + std::to_string(o);
    schema.objects.push_back(test::object(name, {}));
    for (int f = 0; f < scalars; ++f) schema.objects.back().fields.push_back(test::scalar("x" + std::to_string(f)));
    const std::string view = "test::" + name + "View<float, physgen::Aosoa<16>>";
    kernels += "void run(const " + view + "& from, const " + view + "& to) {\n" +
               "  for (physgen::index_t i = 0; i < from.size(); ++i) {\n" +
               "    auto value = from.get(i);\n    value.x0 += value.x1;\n    to.put(i, value);\n  }\n}\n";
  }
  std::ofstream(folder / model::generated_header(schema.file)) << emit::accessor_header(schema);
  const std::filesystem::path source = folder / ("of" + std::to_string(scalars) + ".cpp");
  std::ofstream(source) << kernels;
  return source;
}

// The shortest of three compilations, in seconds.
double compile(const std::filesystem::path& source) {
  const std::string command = "\"" PHYSGEN_COMPILER "\" -std=c++20 -O2 -I\"" PHYSGEN_RUNTIME_INCLUDE
                              "\" -isystem \"" PHYSGEN_EIGEN_INCLUDE "\" -c \"" +
                              source.string() + "\" -o \"" + source.string() + ".o\"";
  double best = 1e300;
  for (int attempt = 0; attempt < 3; ++attempt) {
    const auto begin = std::chrono::steady_clock::now();
    if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  return best;
}

TEST(CompileTime, of_one_object_of_1000_scalars_is_compared_with_10_objects_of_100) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "physgen_compile_time";
  std::filesystem::create_directories(folder);
  const double one = compile(write_source(folder, 1, 1000));
  const double ten = compile(write_source(folder, 10, 100));
  std::filesystem::remove_all(folder);
  std::cout << "1 x 1000 scalars: " << one << " s, 10 x 100 scalars: " << ten << " s, ratio " << one / ten
            << " (bar: 3)\n";
  EXPECT_LE(one / ten, 3);
  RecordProperty("ratio", std::to_string(one / ten));
}

}  // namespace
}  // namespace physgen
