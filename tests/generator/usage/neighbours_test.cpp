// Which objects kernels mean: their own or others, as far as types tell; and the kernels of steps.
#include <gtest/gtest.h>

#include "analysed.h"

namespace physgen::usage {
namespace {

std::string source_of_neighbours() {
  std::ifstream in(PHYSGEN_USAGE_SOURCES "/neighbours.cpp");
  return {std::istreambuf_iterator<char>(in), {}};
}

/// "between own": which objects of each array.
Fields objects_of(const Usage& usage, const std::string& kernel) {
  Fields result;
  const StepUse* found = step(usage, kernel);
  EXPECT_NE(found, nullptr) << kernel;
  if (found == nullptr) return result;
  for (const FieldUse& use : found->fields)
    result.insert(use.array + (use.own ? " own" : "") + (use.gathered ? " gathered" : "") +
                  (use.added ? " added" : ""));
  return result;
}

TEST(UsageOfNeighbours, tells_own_objects_from_others_where_types_do) {
  const Usage& usage = usage_of("neighbours.cpp", Side::host);
  EXPECT_EQ(objects_of(usage, "neighbours::Copy"), (Fields{"from own", "to own"}));
  EXPECT_EQ(objects_of(usage, "neighbours::Shift"), (Fields{"from gathered", "to own"}));
  EXPECT_EQ(objects_of(usage, "neighbours::AddToNext"), (Fields{"from own", "sums added"}));
  EXPECT_EQ(objects_of(usage, "neighbours::OneByOne"), (Fields{"from", "to"}));
  EXPECT_EQ(objects_of(usage,
                       "physgen::Fused<neighbours::Copy, neighbours::Copy, neighbours::AddToNext, "
                       "neighbours::AddToNext>"),
            (Fields{"from own", "between own", "to own", "sums added"}));
  EXPECT_EQ(usage.races, std::vector<Race>());
}

TEST(UsageOfNeighbours, tells_own_objects_from_others_of_a_template_over_single_objects_on_both_sides) {
  for (const Side side : {Side::host, Side::device}) {
    if (side == Side::device && !has_device_side()) continue;
    const Usage& usage = usage_of("neighbours.cpp", side);
    EXPECT_EQ(objects_of(usage, "neighbours::Single"), (Fields{"from gathered", "between own", "to own"}));
    EXPECT_EQ(objects_of(usage, "physgen::InLanes<neighbours::Single>"),
              (Fields{"from gathered", "between own", "sums own"}));
  }
}

TEST(UsageOfNeighbours, are_own_objects_of_a_part_in_packs_and_yet_none_of_a_step_that_others_may_be_joined_with) {
  const Usage& usage = usage_of("neighbours.cpp", Side::host);
  const auto between = [&](const std::string& kernel) {
    const StepUse* found = step(usage, kernel);
    EXPECT_NE(found, nullptr) << kernel;
    return found == nullptr ? FieldUse() : found->fields.at(0);
  };
  const FieldUse own = between("neighbours::OfPart"), both = between("neighbours::OfPartAndNext");
  EXPECT_TRUE(own.array == "between" && own.reads_own && !own.reads_others && !own.own && own.gathered);
  EXPECT_TRUE(both.array == "between" && both.reads_own && both.reads_others && !both.own && both.gathered);
}

TEST(UsageOfNeighbours, has_the_kernels_of_steps_with_the_arrays_of_their_views_by_number) {
  const Usage& usage = usage_of("neighbours.cpp", Side::host);
  const StepUse* in_lanes = step(usage, "physgen::InLanes<neighbours::Single>");
  ASSERT_NE(in_lanes, nullptr);
  ASSERT_EQ(in_lanes->kernels.size(), 1U);
  EXPECT_EQ(in_lanes->kernels[0].name, "neighbours::Single");
  EXPECT_EQ(in_lanes->kernels[0].views.arrays, (std::vector<std::string>{"from", "between", "sums"}));
  const FieldUse& from = in_lanes->kernels[0].fields[1];
  EXPECT_TRUE(from.array == "from" && from.reads_others && !from.reads_own && !from.writes_others);
  const StepUse* fused =
      step(usage, "physgen::Fused<neighbours::Copy, neighbours::Copy, neighbours::AddToNext, neighbours::AddToNext>");
  ASSERT_NE(fused, nullptr);
  ASSERT_EQ(fused->kernels.size(), 4U);
  std::set<std::vector<std::string>> views;
  for (const KernelUse& kernel : fused->kernels) views.insert(kernel.views.arrays);
  EXPECT_EQ(views, (std::set<std::vector<std::string>>{
                       {"from", "between"}, {"between", "to"}, {"to", "sums"}, {"between", "sums"}}));
  const StepUse* sum = step(usage, "neighbours::SumOfOwn");
  ASSERT_NE(sum, nullptr);
  EXPECT_EQ(texts_of(sum->fields), (Fields{"from.volume R", "sums.volume W"}));
  ASSERT_EQ(sum->kernels.size(), 1U);
  EXPECT_EQ(texts_of(sum->kernels[0].fields), Fields{"from.volume R"}) << "without what becomes of the sum";
}

TEST(UsageOfNeighbours, tells_numbers_that_a_kernel_calculates_or_is_given_from_those_that_a_field_names) {
  for (const Side side : {Side::host, Side::device}) {
    if (side == Side::device && !has_device_side()) continue;
    const Usage& usage = usage_of("neighbours.cpp", side);
    using Arrays = std::set<std::string>;
    const auto calculated = [&](const std::string& kernel) {
      const StepUse* found = step(usage, kernel);
      return found == nullptr || found->kernels.size() != 1 ? Arrays{"none"} : found->kernels[0].calculated;
    };
    EXPECT_EQ(calculated("neighbours::Copy"), Arrays());
    EXPECT_EQ(calculated("neighbours::OfPart"), Arrays());
    EXPECT_EQ(calculated("neighbours::Shift"), Arrays{"from"});
    EXPECT_EQ(calculated("neighbours::Single"), Arrays{"from"});
    EXPECT_EQ(calculated("neighbours::OfPartAndNext"), Arrays{"between"});
    EXPECT_EQ(calculated("neighbours::ByNumbers"), (Arrays{"between", "sums", "to"}));
    EXPECT_EQ(calculated("neighbours::ByChangedNumbers"), (Arrays{"between", "to"}));
  }
}

TEST(UsageOfNeighbours, has_locals_of_fused_kernels_among_their_views) {
  const std::string step =
      "([&] { constexpr auto kept = local<elasticity::RestShapeObject, float>(); return fuse(locals(kept), "
      "Copy{a.from.view(), kept}, Copy{kept, a.to.view()}); }())";
  const Analysis analysis = analysed(
      "neighbours.cpp", "#define PHYSGEN_TEST_STEP " + step + "\n#line 1\n" + source_of_neighbours(), Side::host);
  ASSERT_TRUE(analysis.usage) << analysis.diagnostics.text;
  ASSERT_EQ(analysis.usage->steps.size(), 1U);
  std::set<std::vector<std::string>> views;
  for (const KernelUse& kernel : analysis.usage->steps[0].kernels) views.insert(kernel.views.arrays);
  EXPECT_EQ(views, (std::set<std::vector<std::string>>{{"from", ""}, {"", "to"}}));
}

TEST(UsageOfNeighbours, in_a_group_that_writes_them_is_a_race_in_either_order_and_on_both_sides) {
  const auto races = [](const std::string& steps, Side side) {
    const Analysis analysis =
        analysed("neighbours.cpp",
                 "#define PHYSGEN_TEST_STEP fuse(locals(), " + steps + ")\n#line 1\n" + source_of_neighbours(), side);
    EXPECT_TRUE(analysis.usage) << analysis.diagnostics.text;
    Fields result;
    if (analysis.usage)
      for (const Race& race : analysis.usage->races)
        result.insert(race.writer + ' ' + std::to_string(race.writer_place.line) + ", " + race.other + ' ' +
                      std::to_string(race.other_place.line) + ": " + race.array + '.' + race.field);
    return result;
  };
  const std::string copy = "Copy{a.from.view(), a.between.view()}", shift = "Shift{a.between.view(), a.to.view()}",
                    sum = "AddToNext{a.from.view(), a.sums.view()}", of_sums = "Copy{a.sums.view(), a.to.view()}";
  const Fields expected = {"neighbours::Copy 44, neighbours::Shift 58: between.volume"};
  EXPECT_EQ(races(copy + ", " + shift, Side::host), expected);
  EXPECT_EQ(races(sum + ", " + of_sums, Side::host),
            Fields{"neighbours::AddToNext 72, neighbours::Copy 44: sums.volume"});
  EXPECT_EQ(races(copy + ", NextPack{a.between.view(), a.to.view()}", Side::host),
            Fields{"neighbours::Copy 44, neighbours::NextPack 92: between.volume"});
  EXPECT_EQ(races(copy + ", OfPart{a.between.view(), a.to.view()}", Side::host).size(), 1U);
  if (!has_device_side()) GTEST_SKIP() << "there is no CUDA toolkit";
  EXPECT_EQ(races(shift + ", " + copy, Side::device), expected);
}

}  // namespace
}  // namespace physgen::usage
