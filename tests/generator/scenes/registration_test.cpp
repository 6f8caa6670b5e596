// The fields that programs of whole scenes read and write, found by four compilers: by g++ and by nvcc's compiler of
// the host as what probes register in a program that is made of the scene's, and by Clang for the host and for CUDA.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

#include "scenes/halos.h"
#include "scenes/probe_unit.h"
#include "scenes/read.h"
#include "scenes/read_once.h"
#include "scenes/report_halos.h"
#include "usage/analyse.h"

namespace physgen::test {
namespace {

namespace fs = std::filesystem;
using Texts = std::set<std::string>;

std::vector<std::string> flags() {
  std::vector<std::string> flags;
  if (*PHYSGEN_MARCH != '\0') flags.emplace_back(PHYSGEN_MARCH);
  for (const std::string& folder : split(PHYSGEN_INCLUDES)) flags.push_back("-I" + folder);
  return flags;
}
std::string with_folders() {
  std::string text = " -std=c++20 -w";
  for (const std::string& flag : flags())
    if (flag.starts_with("-I")) text += " " + flag;
  return text;
}
const std::string of_gcc = PHYSGEN_COMPILER " -O0 " PHYSGEN_MARCH " -no-pie";

/// The lines that a command prints.
Texts lines_of(const std::string& command) {
  Texts lines;
  std::istringstream in(output_of(command));
  for (std::string line; std::getline(in, line);) lines.insert(line);
  return lines;
}

struct ReadByBoth : ReadOnce {  // by Clang and by g++
  ReadByBoth() : ReadOnce(split(PHYSGEN_SOLVER_HEADERS), physgen::test::flags()) {
    const std::string header = "'" + file() + "'";
    EXPECT_EQ(output_of(of_gcc + with_folders() + " -x c++-header " + header + " -o " + header + ".gch 2>&1"), "");
  }
};
const ReadOnce& once() {
  static const ReadByBoth read;
  return read;
}

std::string path_of(const std::string& name) {
  const std::string tested = PHYSGEN_TESTED_SCENE_FOLDER "/" + name + ".h";
  return fs::exists(tested) ? tested : PHYSGEN_SCENE_FOLDER "/" + name + ".h";
}
/// Reads a scene, once, since that takes seconds.
const scenes::Scene& scene_of(const std::string& name) {
  static std::map<std::string, scenes::Scene> known;
  const auto [entry, is_new] = known.try_emplace(name);
  if (is_new) {
    const auto declaration = scenes::read(path_of(name), once().flags());
    EXPECT_TRUE(declaration.scene) << declaration.diagnostics;
    if (declaration.scene) entry->second = *declaration.scene;
  }
  return entry->second;
}
std::string unit_of(const std::string& name, const std::string& space) {
  return scenes::probe_unit(scene_of(name), space, path_of(name));
}

usage::Usage usage_of(const std::string& name, usage::Side side) {
  usage::Diagnostics diagnostics;
  const bool on_host = side == usage::Side::host;
  auto usage = usage::analyse("unit.cpp", unit_of(name, on_host ? "Host" : "Cuda"), on_host ? once().flags() : flags(),
                              side, diagnostics);
  EXPECT_TRUE(usage) << diagnostics.text;
  return usage ? std::move(*usage) : usage::Usage();
}

/// Uses, over all steps and outside of them.
Texts texts_of(const usage::Usage& usage) {
  Texts result;
  for (const usage::FieldUse& use : usage::all_fields(usage))
    result.insert(use.array + "." + use.field + (use.read ? " R" : " ") + (use.written ? "W" : "") +
                  (use.address_taken ? "&" : ""));
  return result;
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
  const std::string command = compile + with_folders() + " '" + source + "' -o '" + program + "' > '" + said + "' 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << output_of("grep -m1 'error' '" + said + "'");
  return lines_of("'" + program + "'");
}
Texts registered_by_gcc(const std::string& name) {
  return registered(name, "Host", ".cpp",
                    of_gcc + " -Winvalid-pch -include '" + once().file() + "' -Wl,--unresolved-symbols=ignore-all");
}

/// What the rows of a scene's table say of the fields of arrays, as registered() does; and of what steps do in ways of
/// their own, or after a reduction, what the analysis says.
Texts said_by(const scenes::Halos& halos, const usage::Usage& usage) {
  std::vector<usage::FieldUse> said = usage.unattributed;
  for (const usage::StepUse& step : usage.steps) {
    for (usage::FieldUse use : step.fields) {
      const auto has = [&](const usage::KernelUse& kernel) {
        return std::ranges::any_of(
            kernel.fields, [&](const usage::FieldUse& of) { return of.array == use.array && of.field == use.field; });
      };
      if (std::ranges::none_of(step.kernels, has)) usage::add(said, use);
    }
    for (const usage::KernelUse& kernel : step.kernels)
      for (const scenes::HaloRow& row : halos.table) {
        const auto view = static_cast<std::size_t>(row.view);
        if (row.kernel != kernel.name || view >= kernel.views.arrays.size()) continue;
        usage::FieldUse use;
        use.array = kernel.views.arrays[view];
        use.field = row.field;
        use.read = row.reads_own || row.reads_others;
        use.written = row.writes_own || row.writes_others;
        const bool is_of_this = std::ranges::any_of(kernel.fields, [&](const usage::FieldUse& of) {
          return of.array == use.array && of.field == use.field;  // else of the kernel over other views
        });
        if (is_of_this) usage::add(said, use);
      }
  }
  usage::Usage all;
  all.unattributed = said;
  return texts_of(all);
}

/// Checks a scene's table against what probes have registered. @return the table as the header has it
std::string table_of(const std::string& name, const usage::Usage& usage, const Texts& registered) {
  std::vector<scenes::Issue> errors;
  const scenes::Halos halos = scenes::find_halos(scene_of(name), usage, errors);
  for (const scenes::Issue& error : errors) ADD_FAILURE() << error.message;
  EXPECT_EQ(halos.unknown, std::vector<scenes::UnknownHalo>());
  EXPECT_EQ(said_by(halos, usage), registered);
  const std::string text = scenes::halos_header(scene_of(name), halos);
  const auto begin = text.find("    {");
  return text.substr(begin, text.find("};\n") - begin);
}

TEST(RegistrationOfScenes, is_one_set_for_gcc_clang_and_nvcc_of_a_scene_whose_steps_are_kernels_alone) {
  const std::string scene = "force_chain";
  const usage::Usage usage = usage_of(scene, usage::Side::host);
  const Texts expected = texts_of(usage);
  EXPECT_EQ(expected.size(), 15U);
  EXPECT_TRUE(expected.contains("body.svds.U RW") && expected.contains("body.positions.x R") &&
              expected.contains("body.forces.f W"));
  EXPECT_EQ(registered_by_gcc(scene), expected);
  EXPECT_EQ(table_of(scene, usage, expected),
            R"(    {"physgen::fem::ComputeCornerForces", 0, "dm_inverse", {.reads_own = true}},
    {"physgen::fem::ComputeCornerForces", 0, "volume", {.reads_own = true}},
    {"physgen::fem::ComputeCornerForces", 1, "P", {.reads_own = true}},
    {"physgen::fem::ComputeCornerForces", 2, "G", {.writes_own = true}},
    {"physgen::fem::ComputeDeformationGradient", 0, "nodes", {.reads_own = true}},
    {"physgen::fem::ComputeDeformationGradient", 1, "x", {.reads_others = true}, "body.tets.nodes"},
    {"physgen::fem::ComputeDeformationGradient", 2, "dm_inverse", {.reads_own = true}},
    {"physgen::fem::ComputeDeformationGradient", 3, "F", {.writes_own = true}},
    {"physgen::fem::ComputeStress", 0, "U", {.reads_own = true}},
    {"physgen::fem::ComputeStress", 0, "V", {.reads_own = true}},
    {"physgen::fem::ComputeStress", 0, "s", {.reads_own = true}},
    {"physgen::fem::ComputeStress", 1, "P", {.writes_own = true}},
    {"physgen::fem::ComputeSvd", 0, "F", {.reads_own = true}},
    {"physgen::fem::ComputeSvd", 1, "U", {.writes_own = true}},
    {"physgen::fem::ComputeSvd", 1, "V", {.writes_own = true}},
    {"physgen::fem::ComputeSvd", 1, "s", {.writes_own = true}},
    {"physgen::fem::GatherForces", 0, "begin", {.reads_own = true}},
    {"physgen::fem::GatherForces", 0, "end", {.reads_own = true}},
    {"physgen::fem::GatherForces", 1, "element", {.reads_others = true}, "body.node_ranges.begin, body.node_ranges.end"},
    {"physgen::fem::GatherForces", 1, "local", {.reads_others = true}, "body.node_ranges.begin, body.node_ranges.end"},
    {"physgen::fem::GatherForces", 2, "G", {.reads_others = true}, "body.node_tets.element"},
    {"physgen::fem::GatherForces", 3, "f", {.writes_own = true}},
)");
#ifdef PHYSGEN_NVCC
  EXPECT_EQ(registered(scene, "Cuda", ".cu",
                       PHYSGEN_NVCC " -O0 --expt-relaxed-constexpr -diag-suppress 20012 "
                                    "-Xcompiler -no-pie -Xlinker --unresolved-symbols=ignore-all"),
            expected);
#endif
  if (!usage::has_device_side()) GTEST_SKIP() << "there is no CUDA toolkit";
  EXPECT_EQ(texts_of(usage_of(scene, usage::Side::device)), expected);
}

// Not for nvcc: what steps of the solver do in a way of their own on CUDA is code for devices, which registers nothing.
TEST(RegistrationOfScenes, is_one_set_for_gcc_and_clang_of_a_solver_with_an_assembled_matrix) {
  const usage::Usage usage = usage_of("quasistatic", usage::Side::host);
  const Texts expected = texts_of(usage);
  EXPECT_GE(expected.size(), 90U);
  EXPECT_TRUE(expected.contains("level.edge_stiffness.E RW"));
  EXPECT_EQ(registered_by_gcc("quasistatic"), expected);
  const std::string table = table_of("quasistatic", usage, expected);
  EXPECT_EQ(std::ranges::count(table, '\n'), 293);
  std::vector<scenes::Issue> errors;
  Texts cross;
  for (const scenes::HaloRead& read : scenes::find_halos(scene_of("quasistatic"), usage, errors).reads)
    if (read.local.empty()) cross.insert(read.array + "." + read.field + "\n");
  EXPECT_EQ(std::accumulate(cross.begin(), cross.end(), std::string()), R"(body.increment.dx
body.kept.x
body.positions.x
body.rest.x
body.tets.nodes
body.trial.x
body.trial_forces.f
body.volumes.linearised
body.volumes.pressure
body.volumes.tangent_pressure
chunk.tangent.U
chunk.tangent.g
chunk.tangent.x1111
chunk.tangent.x2112
chunk.tangent.x2121
chunk.tangent.x2211
chunk.tangent.x2222
chunk.tangent.x3113
chunk.tangent.x3131
chunk.tangent.x3223
chunk.tangent.x3232
chunk.tangent.x3311
chunk.tangent.x3322
chunk.tangent.x3333
krylov.direction.dx
krylov.product.df
krylov.residual.df
krylov.step.dx
level.coarse_inverse.G
level.constraints.fixed
level.correction.dx
level.direction.dx
level.edge_stiffness.E
level.edges.nodes
level.node_stiffness.K
level.power.dx
level.residual.df
level.scaled_nodes.K
level.scales.inverse
level.scales.scale
level.smoother.largest
level.smoother.length
patches.tangent.g
patches.tangent.k
)");
}

TEST(RegistrationOfScenes, is_the_table_of_halos_of_springs_in_which_positions_alone_cross) {
  const usage::Usage usage = usage_of("relax", usage::Side::host);
  const Texts registered = registered_by_gcc("relax");
  EXPECT_EQ(registered, texts_of(usage));
  EXPECT_EQ(table_of("relax", usage, registered),
            R"(    {"springs::Pull", 0, "nodes", {.reads_own = true}},
    {"springs::Pull", 1, "x", {.reads_others = true}, "body.edges.nodes"},
    {"springs::Pull", 2, "f", {.writes_own = true}},
    {"springs::Step", 0, "f", {.reads_own = true}},
    {"springs::Step", 1, "x", {.reads_own = true, .writes_own = true}},
    {"springs::SumPulls", 0, "begin", {.reads_own = true}},
    {"springs::SumPulls", 0, "end", {.reads_own = true}},
    {"springs::SumPulls", 1, "element", {.reads_others = true}, "body.ranges.begin, body.ranges.end"},
    {"springs::SumPulls", 1, "local", {.reads_others = true}, "body.ranges.begin, body.ranges.end"},
    {"springs::SumPulls", 2, "f", {.reads_others = true}, "body.ends.element"},
    {"springs::SumPulls", 3, "f", {.writes_own = true}},
)");
  std::vector<scenes::Issue> errors;
  EXPECT_EQ(scenes::halos_text(scenes::find_halos(scene_of("relax"), usage, errors)),
            "\nHalos:\n"
            "  springs::Pull: body.positions.x gathered through body.edges.nodes: exchanged if stale\n"
            "  springs::SumPulls: body.ends.element gathered through body.ranges.begin, body.ranges.end: none (rows of "
            "node)\n"
            "  springs::SumPulls: body.ends.local gathered through body.ranges.begin, body.ranges.end: none (rows of "
            "node)\n"
            "  springs::SumPulls: body.pulls.f gathered through body.ends.element: none (edge follows node)\n");
}

}  // namespace
}  // namespace physgen::test
