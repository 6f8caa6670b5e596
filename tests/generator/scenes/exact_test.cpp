// That no field is kept in vain, by a compiler's word: where every field that is read were pruned, one compilation
// names each of them, and no other. The compiler is clang++, which takes half as long as g++; that g++ needs no more
// fields is what the build shows. What scenes of the solver include is read once, for this compiler and for the
// analysis.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <regex>
#include <set>

#include "scenes/analysis.h"
#include "scenes/header.h"
#include "scenes/read.h"
#include "scenes/read_once.h"
#include "usage/json.h"

namespace physgen::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> flags() {
  std::vector<std::string> flags = {"-march=native"};
  for (const std::string& folder : split(PHYSGEN_INCLUDES)) flags.push_back("-I" + folder);
  for (const std::string& file : split(PHYSGEN_SCENES))
    flags.push_back("-I" + fs::path(file).parent_path().parent_path().string());
  return flags;
}

/// The usage.json that the build wrote for the scene of a file; empty: there is none.
std::string usage_file(const std::string& scene) {
  for (const std::string& folder : split(PHYSGEN_BUILT)) {
    const fs::path file = fs::path(folder) / fs::path(scene).filename().replace_extension(".usage.json");
    if (fs::exists(file)) return file.string();
  }
  return "";
}

std::string text_of(const std::string& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A unit that instantiates the scene's program over its generated arrays, with views of those that are only read.
std::string program_unit(const scenes::Scene& scene) {
  std::string parameters, arguments;
  for (const auto& group : scene.groups) {
    parameters += ", " + scene.qualified_name() + "_scene::" + group.name + "<>& the_" + group.variable;
    arguments += ", the_" + group.variable;
  }
  for (std::size_t i = 0; i < scene.parameters.size(); ++i) {
    parameters += ", " + scene.parameters[i] + "& parameter" + std::to_string(i);
    arguments += ", parameter" + std::to_string(i);
  }
  return "#include <physgen/executor.h>\n#include \"" + scenes::file_of(scene) + "\"\n#include \"" + scene.include +
         "\"\nvoid run(physgen::HostExecutor& on" + parameters + ") {\n  " + scene.qualified_name() + "::program(on" +
         arguments + ");\n}\n";
}

/// What the compiler says. @param what it is to do, as a shell reads it
std::string compile(const std::string& what) {
  std::string command =
      PHYSGEN_CLANG " -std=c++20 -w -ftemplate-backtrace-limit=1 -ferror-limit=0 -fno-caret-diagnostics";
  for (const std::string& flag : flags()) command += " " + flag;
  return output_of(command + " " + what + " 2>&1");
}

/// Those of `a` that `b` has not, with commas.
std::string only_in(const std::set<std::string>& a, const std::set<std::string>& b) {
  std::string text;
  for (const std::string& name : a)
    if (!b.contains(name)) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// As the tags of pruned fields name it.
std::string name_of(const std::string& array, const std::string& field) {
  std::string name = array + "." + field;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

/// The fields that some step reads.
std::set<std::string> fields_read(const scenes::Needs& needs) {
  std::set<std::string> read;
  for (const auto& array : needs.arrays)
    for (const auto& field : array.fields)
      if (!field.readers.empty()) read.insert(name_of(array.array, field.field.name));
  return read;
}

/// The fields that a compiler's messages say to be pruned.
std::set<std::string> refused_fields(const std::string& said) {
  std::set<std::string> named;
  const std::regex tag("Pruned<[A-Za-z0-9_:, ]*_scene::tags::([A-Za-z0-9_:]*[A-Za-z0-9])_*>::");
  for (auto match = std::sregex_iterator(said.begin(), said.end(), tag); match != std::sregex_iterator(); ++match)
    named.insert(std::regex_replace((*match)[1].str(), std::regex("::"), "_"));
  return named;
}

class EveryScene : public testing::TestWithParam<std::string> {
 protected:
  static void SetUpTestSuite() {
    std::vector<std::string> headers = split(PHYSGEN_SOLVER_HEADERS);
    headers.insert(headers.begin(), "physgen/executor.h");
    once = std::make_unique<ReadOnce>(headers, flags());
    ASSERT_EQ(compile("-x c++-header " + once->file() + " -o " + once->file() + ".pch"), "");
  }
  static void TearDownTestSuite() { once.reset(); }

  /// Of a unit: reads what is precompiled first.
  static std::string errors_of(const std::string& unit) {
    return compile("-fsyntax-only -include-pch " + once->file() + ".pch " + unit);
  }

  static inline std::unique_ptr<ReadOnce> once;
};

TEST_P(EveryScene, keeps_no_field_that_compiles_without) {
  const auto declaration = scenes::read(GetParam(), once->flags());
  ASSERT_TRUE(declaration.scene) << declaration.diagnostics;
  const scenes::Scene& scene = *declaration.scene;
  // What the build found, which is what its headers were written from.
  const std::string built = usage_file(GetParam());
  ASSERT_NE(built, "") << "no folder of " << PHYSGEN_BUILT << " has the scene's usage.json";
  const auto programs = usage::from_json(text_of(built));
  ASSERT_EQ(programs.size(), 1U);
  scenes::Needs needs = scenes::find_needs(scene, programs[0].usage);
  ASSERT_TRUE(needs.sound());
  const Folder folder;
  const std::string unit = folder.write("unit.cpp", program_unit(scene));
  std::set<std::string> read = fields_read(needs), named, rest = read;
  // What the compiler says where these are pruned of the fields that are read. What is not kept stays so.
  const auto errors_without = [&](const std::set<std::string>& pruned) {
    for (auto& array : needs.arrays)
      for (auto& field : array.fields) {
        const std::string name = name_of(array.array, field.field.name);
        if (read.contains(name)) field.kept = !pruned.contains(name);
      }
    folder.write(scenes::file_of(scene), scenes::header(scene, needs));
    return errors_of(unit);
  };

  // The fields that are read are pruned all at once; one that is not kept, and read all the same, is named with them.
  // An error may keep the compiler from looking at what follows it in the same function: what it has not named then is
  // pruned alone, until all is named or nothing new is, and the scene's own header has to compile as well.
  bool hides = false;
  for (std::size_t before = 0; !rest.empty() && rest.size() != before;) {
    before = rest.size();
    for (const std::string& name : refused_fields(errors_without(rest))) {
      named.insert(name);
      rest.erase(name);
    }
    hides = hides || !rest.empty();
  }
  EXPECT_EQ(hides ? errors_without({}) : "", "") << "what is not kept is not read";
  EXPECT_EQ(only_in(named, read), "") << "pruned and refused, but no step is said to read it";
  if (!rest.empty()) {  // Code of devices alone may read them, which a compiler of the host does not see: the host's
                        // says so.
    const auto host = scenes::analyse(scene, GetParam(), once->flags(), {usage::Side::host});
    ASSERT_TRUE(host.usage) << host.diagnostics[0].text;
    const std::set<std::string> read_on_host = fields_read(scenes::find_needs(scene, *host.usage));
    for (const std::string& name : rest) {
      if (!read_on_host.contains(name)) read.erase(name);
    }
  }
  EXPECT_EQ(only_in(read, named), "") << "said to be read, but compiles without";
  EXPECT_FALSE(read.empty());
}

INSTANTIATE_TEST_SUITE_P(Shipped, EveryScene, testing::ValuesIn(split(PHYSGEN_SCENES)),
                         [](const auto& info) { return fs::path(info.param).stem().string(); });

}  // namespace
}  // namespace physgen::test
