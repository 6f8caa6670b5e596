// That no field is kept in vain, by the compiler's word: where every field that is read were pruned, one compilation
// names each of them, and no other.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <regex>
#include <set>

#include "frontend_case.h"
#include "scenes/header.h"
#include "scenes/probe_unit.h"
#include "scenes/read.h"
#include "usage/analyse.h"

namespace physgen::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, ':');)
    if (!part.empty()) parts.push_back(part);
  return parts;
}

std::vector<std::string> flags() {
  std::vector<std::string> flags = {"-march=native"};
  for (const std::string& folder : split(PHYSGEN_INCLUDES)) flags.push_back("-I" + folder);
  for (const std::string& file : split(PHYSGEN_SCENES))
    flags.push_back("-I" + fs::path(file).parent_path().parent_path().string());
  return flags;
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
  return "#include <physgen/executor.h>\n#include \"" + scenes::file_of(scene) +
         "\"\nvoid run(physgen::HostExecutor& on" + parameters + ") {\n  " + scene.qualified_name() + "::program(on" +
         arguments + ");\n}\n";
}

/// What the compiler prints of it.
std::string compile(const std::string& path) {
  std::string command = "LC_ALL=C " + std::string(PHYSGEN_COMPILER) +
                        " -std=c++20 -fsyntax-only -w -fopenmp -ftemplate-backtrace-limit=1 -fmax-errors=0";
  for (const std::string& flag : flags()) command += " " + flag;
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen((command + " " + path + " 2>&1").c_str(), "r"), ::pclose);
  std::string text;
  char block[4096];
  while (const auto count = std::fread(block, 1, sizeof block, pipe.get())) text.append(block, count);
  return text;
}

class EveryScene : public testing::TestWithParam<std::string> {};

TEST_P(EveryScene, keeps_no_field_that_compiles_without) {
  const auto declaration = scenes::read(GetParam(), flags());
  ASSERT_TRUE(declaration.scene) << declaration.diagnostics;
  const scenes::Scene& scene = *declaration.scene;
  usage::Diagnostics diagnostics;
  const auto usage = usage::analyse("unit.cpp", scenes::probe_unit(scene, "Host", GetParam()), flags(),
                                    usage::Side::host, diagnostics);
  ASSERT_TRUE(usage) << diagnostics.text;
  scenes::Needs needs = scenes::find_needs(scene, *usage);
  ASSERT_TRUE(needs.sound());
  const Folder folder;
  folder.write(scenes::file_of(scene), scenes::header(scene, needs));
  const std::string unit = folder.write("unit.cpp", program_unit(scene));
  const std::string sound = compile(unit);
  EXPECT_EQ(sound, "") << "what is not kept is not read";

  std::set<std::string> read;
  for (auto& array : needs.arrays)
    for (auto& field : array.fields) {
      field.kept = field.readers.empty();
      std::string name = array.array + "." + field.field.name;
      std::replace(name.begin(), name.end(), '.', '_');
      if (!field.kept) read.insert(std::move(name));
    }
  folder.write(scenes::file_of(scene), scenes::header(scene, needs));
  const std::string said = compile(unit);
  std::set<std::string> named;
  const std::regex tag("Field_ = [A-Za-z0-9_:]*_scene::pruned::([A-Za-z0-9_:]+)");
  for (auto match = std::sregex_iterator(said.begin(), said.end(), tag); match != std::sregex_iterator(); ++match)
    named.insert(std::regex_replace((*match)[1].str(), std::regex("::"), "_"));
  EXPECT_EQ(named, read);
  EXPECT_FALSE(read.empty());
}

INSTANTIATE_TEST_SUITE_P(Shipped, EveryScene, testing::ValuesIn(split(PHYSGEN_SCENES)),
                         [](const auto& info) { return fs::path(info.param).stem().string(); });

}  // namespace
}  // namespace physgen::test
