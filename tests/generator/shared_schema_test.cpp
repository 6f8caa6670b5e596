// One program that links two targets of physgen_generate(), each of which has generated the schema that both include.
#include <first.physgen.h>
#include <gtest/gtest.h>
#include <second.physgen.h>

namespace {

TEST(SharedSchema, is_one_type_to_a_program_that_links_two_targets_with_it) {
  shared::FirstArray<float> first(2);
  shared::SecondArray<float> second(2);
  const shared::Base<float> base = first.view().get(1).base;
  EXPECT_EQ(base.x, 0x1p64F) << "the initial value";
  auto value = second.view().get(0);
  value.base[1] = base;
  value.base[1].x = 3;
  second.view().put(0, value);
  EXPECT_EQ(float(second.view()[0].base(1).x()), 3);
}

}  // namespace
