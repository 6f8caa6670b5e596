// Whole analyses of programs over probes: against what the compiler of this test has registered for the same sources,
// and against what their authors say of them.
#include <gtest/gtest.h>
#include <physgen/probe/registry.h>

#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include "usage/analyse.h"

namespace physgen::usage {
namespace {

using Fields = std::set<std::string>;

const std::vector<std::string>& flags() {
  static const std::vector<std::string> words = [] {
    std::istringstream text(PHYSGEN_USAGE_FLAGS);
    return std::vector<std::string>(std::istream_iterator<std::string>(text), {});
  }();
  return words;
}

struct Analysis {
  std::optional<Usage> usage;
  Diagnostics diagnostics;
};

Analysis analysed(const std::string& name, const std::string& text, Side side = Side::host) {
  Analysis analysis;
  analysis.usage = analyse(name, text, flags(), side, analysis.diagnostics);
  return analysis;
}

/// What is found in a file of tests/generator/usage. Each is analysed once for each side.
const Usage& usage_of(const std::string& file, Side side) {
  static std::map<std::pair<std::string, Side>, Usage> known;
  const auto [entry, is_new] = known.try_emplace({file, side});
  if (is_new) {
    std::ifstream in(PHYSGEN_USAGE_SOURCES "/" + file);
    const Analysis analysis = analysed(file, {std::istreambuf_iterator<char>(in), {}}, side);
    EXPECT_TRUE(analysis.usage) << analysis.diagnostics.text;
    EXPECT_EQ(analysis.diagnostics.text, "");
    if (analysis.usage) entry->second = *analysis.usage;
  }
  return entry->second;
}

std::string text_of(const std::string& array, const std::string& field, bool read, bool written, bool address) {
  return array.substr(array.find('.') + 1) + "." + field + " " + (read ? "R" : "") + (written ? "W" : "") +
         (address ? "&" : "");
}

Fields texts_of(const std::vector<FieldUse>& uses) {
  Fields result;
  for (const FieldUse& use : uses)
    result.insert(text_of(use.array, use.field, use.read, use.written, use.address_taken));
  return result;
}

/// What the compiler of this test has found in the arrays of a namespace.
Fields registered(const std::string& space) {
  Fields result;
  for (const probe::FieldAccess& row : probe::registered())
    if (row.array.starts_with(space + "."))
      result.insert(text_of(row.array, row.field, row.read, row.written, row.address_taken));
  return result;
}

const StepUse* step(const Usage& usage, const std::string& kernel) {
  for (const StepUse& step : usage.steps)
    if (step.kernel == kernel) return &step;
  return nullptr;
}

Fields fields_of(const Usage& usage, const std::string& kernel) {
  const StepUse* found = step(usage, kernel);
  EXPECT_NE(found, nullptr) << "there is no step " << kernel;
  return found == nullptr ? Fields() : texts_of(found->fields);
}

Fields without(Fields fields, const std::string& array) {
  std::erase_if(fields, [&](const std::string& field) { return field.starts_with(array + "."); });
  return fields;
}

// ---- Kernels of tools/fem -------------------------------------------------------------------------------------------

TEST(UsageOfKernels, is_what_the_compiler_registers) {
  EXPECT_GE(registered("kernels").size(), 40U);
  EXPECT_EQ(texts_of(all_fields(usage_of("kernels.cpp", Side::host))), registered("kernels"));
}

TEST(UsageOfKernels, is_the_same_on_both_sides) {
  if (!has_device_side()) GTEST_SKIP() << "there is no CUDA toolkit";
  const Usage &host = usage_of("kernels.cpp", Side::host), &device = usage_of("kernels.cpp", Side::device);
  EXPECT_EQ(texts_of(all_fields(device)), texts_of(all_fields(host)));
  for (const StepUse& on_host : host.steps)
    if (on_host.kernel != "lambda") EXPECT_EQ(fields_of(device, on_host.kernel), texts_of(on_host.fields));
}

TEST(UsageOfKernels, is_what_their_comments_say) {
  const Fields derivative = {"derivatives.x1111", "derivatives.x2112", "derivatives.x2121", "derivatives.x2211",
                             "derivatives.x2222", "derivatives.x3113", "derivatives.x3131", "derivatives.x3223",
                             "derivatives.x3232", "derivatives.x3311", "derivatives.x3322", "derivatives.x3333"};
  const auto with_derivative = [&](const char* access, Fields fields) {
    for (const std::string& field : derivative) fields.insert(field + access);
    return fields;
  };
  const Fields rows = {"node_ranges.begin R", "node_ranges.end R", "node_entries.element R", "node_entries.local R"};
  const auto with_rows = [&](Fields fields) {
    fields.insert(rows.begin(), rows.end());
    return fields;
  };
  const std::map<std::string, Fields> expected = {
      {"ComputeDeformationGradient", {"tets.nodes R", "positions.x R", "rest.dm_inverse R", "gradients.F W"}},
      {"ComputeSvd", {"gradients.F R", "svds.U W", "svds.V W", "svds.s W"}},
      {"ComputeSvdParts", {"gradients.F R", "stretches.s W"}},
      {"ComputeStress", {"svds.U R", "svds.V R", "svds.s R", "stresses.P W"}},
      {"ComputeStressDerivative", with_derivative(" W", {"svds.s R"})},
      {"DpFromDf", with_derivative(" R", {"svds.U R", "svds.V R", "gradient_changes.dF R", "stress_changes.dP W"})},
      {"ComputeCornerForces", {"rest.dm_inverse R", "rest.volume R", "stresses.P R", "corner_forces.G W"}},
      {"GatherForces", with_rows({"corner_forces.G R", "forces.f W"})},
      {"ForceDifferential", with_rows({"node_stiffness.K R", "edge_stiffness.E R", "edges.nodes R", "displacements.dx R",
                                       "force_changes.df W"})},
      {"ComputeCornerForceDifferentials",
       with_derivative(" R", {"tets.nodes R", "displacements.dx R", "rest.dm_inverse R", "rest.volume R", "svds.U R",
                              "svds.V R", "corner_changes.G W"})},
      {"GatherForceDifferentials", with_rows({"corner_changes.G R", "force_changes.df W"})},
      {"ComputeTetStiffness", with_derivative(" R", {"rest.dm_inverse R", "rest.volume R", "svds.U R", "svds.V R",
                                                     "tet_stiffness.e W", "tet_stiffness.k W"})},
      {"lambda", {"node_stiffness.K R", "edge_stiffness.E R", "edges.nodes R", "displacements.dx R", "product.df RW"}},
  };
  const Usage& usage = usage_of("kernels.cpp", Side::host);
  EXPECT_EQ(usage.steps.size(), expected.size());
  EXPECT_EQ(texts_of(usage.unattributed), Fields());
  for (const auto& [kernel, fields] : expected)
    EXPECT_EQ(fields_of(usage, kernel == "lambda" ? kernel : "physgen::fem::" + kernel), fields) << kernel;
}

TEST(UsageOfKernels, has_places_in_the_kernels_own_source) {
  const Usage& usage = usage_of("kernels.cpp", Side::host);
  for (const StepUse& step : usage.steps) {
    EXPECT_GT(step.place.line, 0);
    for (const FieldUse& use : step.fields) {
      EXPECT_FALSE(use.places.empty()) << step.kernel << " " << use.array << "." << use.field;
      for (const Place& place : use.places) EXPECT_EQ(place.file, step.place.file);
    }
  }
  const StepUse* parts = step(usage, "physgen::fem::ComputeSvdParts");
  ASSERT_NE(parts, nullptr);
  EXPECT_EQ(parts->place.file, "fem/kernels/compute_svd.h");
  EXPECT_EQ(parts->arrays, (std::vector<std::string>{"kernels.gradients", "kernels.stretches"}));
  EXPECT_TRUE(parts->fields[0].whole_object) << "gradients.get(i)";
  const StepUse* differential = step(usage, "physgen::fem::ForceDifferential");
  ASSERT_NE(differential, nullptr);
  for (const FieldUse& use : differential->fields) {
    EXPECT_FALSE(use.whole_object) << use.field;
    if (use.field == "dx") EXPECT_EQ(use.places.size(), 2U) << "of the node itself, and in the lambda over its edges";
  }
}

// ---- Kernels that are hard to read ----------------------------------------------------------------------------------

TEST(UsageOfAwkwardKernels, is_what_the_compiler_registers) {
  EXPECT_GE(registered("awkward").size(), 25U);
  EXPECT_EQ(texts_of(all_fields(usage_of("awkward.cpp", Side::host))), registered("awkward"));
}

TEST(UsageOfAwkwardKernels, is_the_same_on_both_sides) {
  if (!has_device_side()) GTEST_SKIP() << "there is no CUDA toolkit";
  EXPECT_EQ(texts_of(all_fields(usage_of("awkward.cpp", Side::device))),
            without(texts_of(all_fields(usage_of("awkward.cpp", Side::host))), "over"));
}

TEST(UsageOfAwkwardKernels, is_given_to_the_steps_that_make_it) {
  const std::map<std::string, Fields> expected = {
      {"awkward::WholeObjects",
       {"whole.U R", "whole.V R", "whole.s R", "put.U RW", "put.V RW", "put.s RW", "copied.U W", "copied.V W",
        "copied.s W"}},
      {"awkward::Lambdas", {"lambda.volume R", "generic.dm_inverse W"}},
      {"awkward::InFunctionObject", {"function.x2121 R", "function.x2112 W"}},
      {"awkward::VirtualCall", {"virtual_call.volume R"}},
      {"awkward::FunctionPointer", {"pointer.volume R"}},
      {"awkward::InAlgorithm", {"algorithm.x3333 W"}},
      {"awkward::EitherView", {"either.x2211 W", "either.x3311 R", "either.x3322 R"}},
      {"awkward::EndOfScope", {"destroyed.volume W"}},
      {"awkward::TakesAnAddress", {"address.volume RW&"}},
      {"awkward::ByHelper", {"helper.volume RW"}},
      {"awkward::Discards", {"discarded.dm_inverse W"}},
      {"physgen::Over<lambda>", {"over.volume W"}},
      {"awkward::Term", {"terms.volume R", "total.volume W"}},
      {"awkward::IsSmall", {"predicate.volume R"}},
      {"value()", {"value.dm_inverse R", "value.volume R"}},
  };
  const Usage& usage = usage_of("awkward.cpp", Side::host);
  EXPECT_EQ(usage.steps.size(), expected.size());
  for (const auto& [kernel, fields] : expected) EXPECT_EQ(fields_of(usage, kernel), fields) << kernel;
  for (const StepUse& step : usage.steps)
    EXPECT_EQ(step.root, step.kernel == "awkward::IsSmall" || step.kernel == "value()") << step.kernel;
  EXPECT_EQ(texts_of(usage.unattributed), (Fields{"never_given.volume W", "outside.volume R"}));
  EXPECT_TRUE(usage.unknown.empty());
}

TEST(UsageOfAwkwardKernels, has_places_where_their_author_wrote_the_access) {
  const Usage& usage = usage_of("awkward.cpp", Side::host);
  const StepUse* helper = step(usage, "awkward::ByHelper");
  ASSERT_NE(helper, nullptr);
  EXPECT_EQ(helper->fields[0].places.size(), 1U) << "the call of a function of another file";
  EXPECT_EQ(helper->fields[0].places[0].file, "awkward.cpp");
  const StepUse* whole = step(usage, "awkward::WholeObjects");
  ASSERT_NE(whole, nullptr);
  for (const FieldUse& use : whole->fields) EXPECT_EQ(use.whole_places, use.places) << use.array << "." << use.field;
}

}  // namespace
}  // namespace physgen::usage
