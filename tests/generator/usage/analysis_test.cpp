// Whole analyses of programs over probes: against what the compiler of this test has registered for the same sources,
// and against what their authors say of them.
#include <gtest/gtest.h>

#include "analysed.h"
#include "kernels/probe_kernels.h"

namespace physgen::usage {
namespace {

/// Those of arrays whose names begin with "beginning.", or those of the others.
Fields of_array(Fields fields, const std::string& beginning) {
  std::erase_if(fields, [&](const std::string& field) { return !field.starts_with(beginning + "."); });
  return fields;
}
Fields without(Fields fields, const std::string& beginning) {
  std::erase_if(fields, [&](const std::string& field) { return field.starts_with(beginning + "."); });
  return fields;
}

// ---- Kernels of tools/fem -------------------------------------------------------------------------------------------

const Fields product = {"product.nodes.K R", "product.blocks.E R", "product.edges.nodes R", "product.x.dx R",
                        "product.y.df RW"};

Fields kernels_and_product() {
  Fields fields = fem::test::what_kernels_do();
  fields.insert(product.begin(), product.end());
  return fields;
}

TEST(UsageOfKernels, is_what_the_compiler_registers) {
  EXPECT_EQ(texts_of(all_fields(usage_of("kernels.cpp", Side::host))),
            without(without(fem::test::what_is_found(), "awkward"), "unusual"));
}

TEST(UsageOfKernels, is_what_their_comments_say_on_both_sides) {
  EXPECT_EQ(texts_of(all_fields(usage_of("kernels.cpp", Side::host))), kernels_and_product());
  if (!has_device_side()) GTEST_SKIP() << "there is no CUDA toolkit";
  EXPECT_EQ(texts_of(all_fields(usage_of("kernels.cpp", Side::device))), kernels_and_product());
}

TEST(UsageOfKernels, is_given_to_the_kernels) {
  for (const Side side : {Side::host, Side::device}) {
    if (side == Side::device && !has_device_side()) continue;
    const Usage& usage = usage_of("kernels.cpp", side);
    EXPECT_EQ(usage.steps.size(), 16U);
    EXPECT_EQ(texts_of(usage.unattributed), Fields());
    for (const StepUse& step : usage.steps) {
      const std::string kernel = step.kernel.substr(step.kernel.rfind(':') + 1);
      const Fields expected = step.kernel == "lambda in physgen::fem::multiply"
                                  ? product
                                  : of_array(fem::test::what_kernels_do(), kernel);  // arrays: "kernel.array"
      EXPECT_EQ(texts_of(step.fields), expected) << step.kernel;
    }
  }
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
  EXPECT_EQ(parts->arrays, (std::vector<std::string>{"ComputeSvdParts.gradients", "ComputeSvdParts.left",
                                                     "ComputeSvdParts.stretches"}));
  EXPECT_TRUE(parts->fields[0].whole_object) << "gradients.get(i)";
  const StepUse* differential = step(usage, "physgen::fem::ComputeForceDifferentials");
  ASSERT_NE(differential, nullptr);
  for (const FieldUse& use : differential->fields) {
    EXPECT_FALSE(use.whole_object) << use.field;
    if (use.field == "dx") {
      EXPECT_EQ(use.places.size(), 2U) << "of the node itself, and in the lambda over its edges";
    }
  }
}

// ---- Kernels that are hard to read ----------------------------------------------------------------------------------

TEST(UsageOfAwkwardKernels, is_what_the_compiler_registers) {
  EXPECT_GE(of_array(fem::test::what_is_found(), "awkward").size(), 25U);
  EXPECT_EQ(texts_of(all_fields(usage_of("awkward.cpp", Side::host))), of_array(fem::test::what_is_found(), "awkward"));
}

TEST(UsageOfAwkwardKernels, is_the_same_on_both_sides) {
  if (!has_device_side()) GTEST_SKIP() << "there is no CUDA toolkit";
  EXPECT_EQ(texts_of(all_fields(usage_of("awkward.cpp", Side::device))),
            without(texts_of(all_fields(usage_of("awkward.cpp", Side::host))), "awkward.over"));
}

TEST(UsageOfAwkwardKernels, is_given_to_the_steps_that_make_it) {
  const std::map<std::string, Fields> expected = {
      {"awkward::WholeObjects",
       {"awkward.whole.U R", "awkward.whole.V R", "awkward.whole.s R", "awkward.put.U RW", "awkward.put.V RW",
        "awkward.put.s RW", "awkward.copied.U W", "awkward.copied.V W", "awkward.copied.s W"}},
      {"awkward::Lambdas", {"awkward.lambda.volume R", "awkward.generic.dm_inverse W"}},
      {"awkward::InFunctionObject", {"awkward.function.x2121 R", "awkward.function.x2112 W"}},
      {"awkward::VirtualCall", {"awkward.virtual_call.volume R"}},
      {"awkward::FunctionPointer", {"awkward.pointer.volume R"}},
      {"awkward::InAlgorithm", {"awkward.algorithm.x3333 W"}},
      {"awkward::EitherView", {"awkward.either.x2211 W", "awkward.either.x3311 R", "awkward.either.x3322 R"}},
      {"awkward::EndOfScope", {"awkward.destroyed.volume W"}},
      {"awkward::TakesAnAddress", {"awkward.address.volume RW&"}},
      {"awkward::ByHelper", {"awkward.helper.volume RW"}},
      {"awkward::Discards", {"awkward.discarded.dm_inverse W"}},
      {"physgen::Over<lambda in awkward::program>", {"awkward.over.volume W"}},
      {"physgen::Fused<awkward::Copies, awkward::Copies>",
       {"awkward.fused_from.volume R", "awkward.fused_to.volume W"}},
      {"awkward::Term", {"awkward.terms.volume R", "awkward.total.volume W"}},
      {"awkward::IsSmall", {"awkward.predicate.volume R"}},
      {"value()", {"awkward.value.dm_inverse R", "awkward.value.volume R"}},
  };
  const Usage& usage = usage_of("awkward.cpp", Side::host);
  EXPECT_EQ(usage.steps.size(), expected.size());
  for (const auto& [kernel, fields] : expected) EXPECT_EQ(fields_of(usage, kernel), fields) << kernel;
  for (const StepUse& step : usage.steps)
    EXPECT_EQ(step.root, step.kernel == "awkward::IsSmall" || step.kernel == "value()") << step.kernel;
  EXPECT_EQ(texts_of(usage.unattributed), (Fields{"awkward.never_given.volume W", "awkward.outside.volume R"}));
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

// ---- Kernels that use what C++ seldom has ---------------------------------------------------------------------------

TEST(UsageOfUnusualKernels, is_what_the_compiler_registers) {
  EXPECT_EQ(texts_of(all_fields(usage_of("unusual.cpp", Side::host))), of_array(fem::test::what_is_found(), "unusual"));
}

TEST(UsageOfUnusualKernels, is_given_to_the_steps_that_make_it) {
  const std::map<std::string, Fields> expected = {
      {"Coroutine", {"coroutine.dm_inverse R", "coroutine.volume W"}},
      {"LambdaAsPointer", {"lambda_as_pointer.volume R"}},
      {"StaticLambda", {"static_lambda.volume W"}},
      {"BindsTuple", {"tuple_like.dm_inverse R", "tuple_like.volume R"}},
      {"ByFriend", {"by_friend.volume W"}},
      {"Comma", {"comma.dm_inverse R", "comma.volume W"}},
      {"Designated", {"designated.dm_inverse R", "designated.volume R"}},
      {"OverRanges", {"ranges.volume R"}},
      {"Invoked", {"invoked.volume W"}},
      {"Applied", {"applied.volume W"}},
      {"ByTable", {"table.volume RW"}},
      {"AddsToo", {"table.volume RW"}},
      {"Inherited", {"inherited.volume W"}},
      {"Compared", {"compared.dm_inverse R", "compared.volume R"}},
      {"Caught", {"caught.volume W"}},
      {"Jumped", {"jumped.dm_inverse W", "jumped.volume W"}},
      {"Mutual", {"mutual.volume W"}},
      {"Visited", {"visited.dm_inverse R", "visited.volume W"}},
      {"Allocated", {"allocated.volume W"}},
      {"Placed", {"placed.dm_inverse W", "placed.volume R"}},
  };
  const Usage& usage = usage_of("unusual.cpp", Side::host);
  EXPECT_EQ(usage.steps.size(), expected.size());
  for (const auto& [kernel, fields] : expected) {
    Fields named;
    for (const std::string& field : fields) named.insert("unusual." + field);
    EXPECT_EQ(fields_of(usage, "unusual::" + kernel), named) << kernel;
  }
  EXPECT_EQ(texts_of(usage.unattributed), Fields());
  EXPECT_TRUE(usage.unknown.empty());
}

}  // namespace
}  // namespace physgen::usage
