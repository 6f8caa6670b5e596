// The fields that programs of whole scenes read and write, found by four compilers: by g++ and by nvcc's compiler of
// the host as what probes register in a program that is made of the scene's, and by Clang for the host and for CUDA.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <sstream>

#include "frontend/case.h"
#include "scenes/probe_unit.h"
#include "scenes/read.h"
#include "usage/analyse.h"

namespace physgen::test {
namespace {

namespace fs = std::filesystem;
using Texts = std::set<std::string>;

std::vector<std::string> flags() {
  std::vector<std::string> flags;
  if (*PHYSGEN_MARCH != '\0') flags.emplace_back(PHYSGEN_MARCH);
  std::istringstream folders(PHYSGEN_INCLUDES);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (!folder.empty()) flags.push_back("-I" + folder);
  return flags;
}

scenes::Scene scene_of(const std::string& name) {
  const auto declaration = scenes::read(PHYSGEN_SCENE_FOLDER "/" + name + ".h", flags());
  EXPECT_TRUE(declaration.scene) << declaration.diagnostics;
  return declaration.scene ? *declaration.scene : scenes::Scene();
}
std::string unit_of(const std::string& name, const std::string& space) {
  return scenes::probe_unit(scene_of(name), space, PHYSGEN_SCENE_FOLDER "/" + name + ".h");
}

/// The uses that Clang finds, over all steps and outside of them.
Texts analysed(const std::string& name, usage::Side side) {
  usage::Diagnostics diagnostics;
  const auto usage = usage::analyse("unit.cpp", unit_of(name, side == usage::Side::host ? "Host" : "Cuda"), flags(),
                                    side, diagnostics);
  EXPECT_TRUE(usage) << diagnostics.text;
  Texts result;
  if (!usage) return result;
  for (const usage::FieldUse& use : usage::all_fields(*usage))
    result.insert(use.array + "." + use.field + (use.read ? " R" : " ") + (use.written ? "W" : "") +
                  (use.address_taken ? "&" : ""));
  return result;
}

/// The lines that a command prints.
Texts lines_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
  std::string text;
  char block[4096];
  while (const auto count = std::fread(block, 1, sizeof block, pipe.get())) text.append(block, count);
  Texts lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.insert(line);
  return lines;
}

std::string text_of_first_error(const std::string& said) {
  const Texts lines = lines_of("grep -m1 'error' '" + said + "'");
  return lines.empty() ? "" : *lines.begin();
}

/// The uses that probes register in a program of the scene: compiled, linked and run. Its code is never called, so that
/// nothing but the names of what it would call is wanted of libraries. Arrays without probes register nothing.
/// @param compile a command that takes the source and writes what -o says, without optimisation
Texts registered(const std::string& name, const std::string& space, const std::string& suffix,
                 const std::string& compile) {
  std::string unit;
  std::istringstream lines(unit_of(name, space));
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with("template void instantiate<") || line.starts_with("template void instantiate<Probed>"))
      unit += line + '\n';
  unit += R"(
#include <iostream>
int main() {
  for (const auto& row : physgen::probe::registered())
    std::cout << row.array << '.' << row.field << (row.read ? " R" : " ") << (row.written ? "W" : "")
              << (row.address_taken ? "&" : "") << '\n';
  for (const std::string& name : physgen::probe::unseen()) std::cout << "not seen: " << name << '\n';
}
)";
  const Folder folder;
  const std::string source = folder.write("unit" + suffix, unit), program = folder / "unit", said = folder / "said";
  std::string command = compile + " -std=c++20 -w";
  for (const std::string& flag : flags())
    if (flag.starts_with("-I")) command += " " + flag;
  command += " '" + source + "' -o '" + program + "' > '" + said + "' 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << text_of_first_error(said);
  return lines_of("'" + program + "'");
}
Texts registered_by_gcc(const std::string& name) {
  return registered(name, "Host", ".cpp",
                    PHYSGEN_COMPILER " -O0 " PHYSGEN_MARCH " -no-pie -Wl,--unresolved-symbols=ignore-all");
}

TEST(RegistrationOfScenes, is_one_set_for_gcc_clang_and_nvcc_of_a_scene_whose_steps_are_kernels_alone) {
  const std::string scene = "force_chain";
  const Texts expected = analysed(scene, usage::Side::host);
  EXPECT_EQ(expected.size(), 15U);
  EXPECT_TRUE(expected.contains("body.svds.U RW") && expected.contains("body.positions.x R") &&
              expected.contains("body.forces.f W"));
  EXPECT_EQ(registered_by_gcc(scene), expected);
#ifdef PHYSGEN_NVCC
  EXPECT_EQ(registered(scene, "Cuda", ".cu",
                       PHYSGEN_NVCC " -O0 --expt-relaxed-constexpr -diag-suppress 20012 "
                                    "-Xcompiler -no-pie -Xlinker --unresolved-symbols=ignore-all"),
            expected);
#endif
  if (!usage::has_device_side()) GTEST_SKIP() << "there is no CUDA toolkit";
  EXPECT_EQ(analysed(scene, usage::Side::device), expected);
}

// Not for nvcc: what steps of the solver do in a way of their own on CUDA is code for devices, which registers nothing.
TEST(RegistrationOfScenes, is_one_set_for_gcc_and_clang_of_a_solver_with_an_assembled_matrix) {
  const Texts expected = analysed("quasistatic", usage::Side::host);
  EXPECT_GE(expected.size(), 90U);
  EXPECT_TRUE(expected.contains("level.edge_stiffness.E RW"));
  EXPECT_EQ(registered_by_gcc("quasistatic"), expected);
}

}  // namespace
}  // namespace physgen::test
