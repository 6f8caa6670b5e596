// Compares digests of scenes whose uses are written by hand.
#include "scenes/digest.h"

#include <gtest/gtest.h>

#include "by_hand.h"
#include "scenes/records.h"

namespace physgen::test {
namespace {

using scenes::digest;
using scenes::find_needs;
using scenes::Needs;
using usage::Usage;

TEST(Digest, has_every_array_field_step_and_use_and_no_place) {
  Needs needs = find_needs(chain(), chain_usage());
  const std::vector<scenes::Record> whole = {{"host", "soa", 12, 12}, {"cuda", "soa", 12, 12}};
  add_records({whole, {{"host", "aos_padded", 48, 48}, {"cuda", "aos", 12, 48}}, whole, whole}, needs);
  EXPECT_EQ(
      digest(chain(), needs, chain_usage()),
      "# What the scene scenes::chain needs, without places. Written by physgen from scenes/chain.h: change that, not "
      "this file.\n"
      "format 1\n"
      "array body.x of m::Position<float> per node; soa 12 of 12 bytes; read only\n"
      "  field x float32 3 kept input read\n"
      "array body.svd of m::Svd<float> per tet; host aos_padded 48 of 48 bytes, cuda aos 12 of 48 bytes\n"
      "  field U float32 9 pruned written\n"
      "  field s float32 3 kept read written\n"
      "array body.f of m::Force<float> per node; soa 12 of 12 bytes\n"
      "  field f float32 3 kept written output\n"
      "array body.extra of m::Extra<float> per tet; soa 12 of 12 bytes; read only\n"
      "  field a float32 1 left_out\n"
      "  field b int32 1 left_out\n"
      "step Force(body.svd, body.f)\n"
      "  read: body.svd.s\n"
      "  written: body.f.f\n"
      "step Svd(body.x, body.svd)\n"
      "  read: body.x.x\n"
      "  written: body.svd.U body.svd.s\n");
}

TEST(Digest, says_in_which_way_a_step_uses_a_field) {
  Usage usage = chain_usage();
  usage.steps[0].fields[0].gathered = true;
  usage.steps[0].fields[1].own = usage.steps[0].fields[1].whole_object = true;
  usage.steps[1].root = true;
  usage.steps[1].fields[1].added = usage.steps[1].fields[1].address_taken = true;
  usage.unattributed.push_back(reads("body.extra", "b"));
  const std::string text = digest(chain(), find_needs(chain(), usage), usage);
  for (const char* lines :
       {"step Svd(body.x, body.svd)\n  read gathered: body.x.x\n  written: body.svd.s\n  written own whole: "
        "body.svd.U\n",
        "step Force(body.svd, body.f); wanted\n  read: body.svd.s\n  written added by_address: body.f.f\n",
        "outside of steps\n  read: body.extra.b\n"})
    EXPECT_NE(text.find(lines), std::string::npos) << lines << "in\n" << text;
}

TEST(Digest, is_the_same_when_lines_move) {
  Usage moved = chain_usage();
  for (auto& step : moved.steps) {
    step.place.line += 7;
    for (auto& use : step.fields)
      for (auto* places : {&use.places, &use.read_places, &use.written_places})
        for (auto& place : *places) place.line += 7;
  }
  ASSERT_NE(moved, chain_usage());
  EXPECT_EQ(digest(chain(), find_needs(chain(), moved), moved),
            digest(chain(), find_needs(chain(), chain_usage()), chain_usage()));
}

TEST(Digest, has_one_step_of_those_that_places_alone_tell_apart) {
  Usage usage = chain_usage();
  usage.steps.push_back(usage.steps.back());
  usage.steps.back().place.line = 90;
  usage.steps.back().fields = {reads("body.svd", "U")};
  const std::string text = digest(chain(), find_needs(chain(), usage), usage);
  EXPECT_NE(text.find("step Force(body.svd, body.f)\n  read: body.svd.U body.svd.s\n  written: body.f.f\nstep Svd"),
            std::string::npos)
      << text;
}

TEST(Digest, has_what_is_read_too_early_and_joined_steps) {
  Needs needs = find_needs(chain(), chain_usage());
  needs.read_too_early.push_back({"body.svd", {"U", "s"}, "Force(body.svd, body.f)", {"force.h", 6, 1}});
  needs.groups.push_back({0, 0, 1, {"Svd(body.x, body.svd)", "Force(body.svd, body.f)"}, {}, {"body.svd"}});
  needs.arrays[1].group = 0;
  const std::string text = digest(chain(), needs, chain_usage());
  for (const char* line : {"  field s float32 3 local read written\n",
                           "\nread before written: body.svd.U, body.svd.s by Force(body.svd, body.f)\n",
                           "\njoined: Svd(body.x, body.svd), Force(body.svd, body.f); local body.svd\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << "in\n" << text;
}

}  // namespace
}  // namespace physgen::test
