// The need report as text and as JSON, of uses that are written by hand.
#include "scenes/report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "by_hand.h"
#include "scenes/records.h"

namespace physgen::test {
namespace {

using scenes::find_needs;
using scenes::Needs;
using scenes::Scene;
using usage::Usage;

TEST(NeedReport, has_a_row_for_every_field_and_sums_for_every_set) {
  const std::string text = scenes::report_text(chain(), find_needs(chain(), chain_usage()));
  for (const char* line :
       {"body.x      x      12     kept      (input)     Svd\n", "body.svd    U      36     pruned    Svd         -\n",
        "            s      12     kept      Svd         Force\n",
        "body.f      f      12     kept      Force       (output)\n",
        "body.extra  a      4      left out  -           -\n", "per node: 24 of 24 bytes, 6 of 6 numbers\n",
        "per tet: 12 of 56 bytes, 3 of 14 numbers\n",
        "  body.svd.U is not kept: written by Svd(body.x, body.svd); nothing reads it\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << "in\n" << text;
}

TEST(NeedReport, names_kernels_without_namespaces_in_its_table_and_fused_ones_by_their_parts) {
  Usage usage = chain_usage();
  usage.steps[0].kernel = "physgen::Fused<physgen::fem::Svd, my_own::Turn_2>";
  const std::string text = scenes::report_text(chain(), find_needs(chain(), usage));
  EXPECT_NE(text.find("            s      12     kept      Fused<Svd, Turn_2>  Force\n"), std::string::npos) << text;
}

TEST(NeedReport, has_all_of_it_as_json_with_the_places_of_uses) {
  const auto json = nlohmann::json::parse(scenes::report_json(chain(), find_needs(chain(), chain_usage())));
  EXPECT_EQ(json.at("scene"), "scenes::chain");
  const auto& svd = json.at("arrays").at(1);
  EXPECT_EQ(svd.at("array"), "body.svd");
  EXPECT_EQ(svd.at("of"), "per tet");
  EXPECT_EQ(svd.at("read_only"), false);
  EXPECT_EQ(svd.at("fields").at(0).at("fate"), "pruned");
  EXPECT_EQ(svd.at("fields").at(1).at("fate"), "kept");
  EXPECT_EQ(svd.at("fields").at(1).at("read_by").at(0).at("places"), nlohmann::json({"force.h:6:1"}));
  EXPECT_EQ(json.at("sums").at(1).at("kept_bytes"), 12);
  EXPECT_EQ(json.at("sums").at(1).at("all_bytes"), 56);
}

TEST(NeedReport, says_what_pruning_saves_of_records_with_their_padding) {
  const Scene scene = chain();
  Needs needs = find_needs(scene, chain_usage());
  EXPECT_EQ(scenes::report_text(scene, needs).find("padding"), std::string::npos) << "nobody looked";
  const std::vector<scenes::Record> whole = {{"host", "soa", 12, 12}, {"cuda", "soa", 12, 12}};
  add_records({whole, {{"host", "aos_padded", 48, 48}, {"cuda", "aos", 12, 48}}, whole, whole}, needs);
  const std::string text = scenes::report_text(scene, needs);
  EXPECT_NE(text.find("\nBytes that records take without the fields that are pruned, padding included:\n"
                      "  array     layout             bytes  with all fields\n"
                      "  body.svd  aos_padded (host)  48     48               padding takes what pruning saves\n"
                      "  body.svd  aos (cuda)         12     48\n\n"),
            std::string::npos)
      << text;
  const auto json = nlohmann::json::parse(scenes::report_json(scene, needs));
  EXPECT_EQ(json.at("arrays").at(1).at("records").at(1),
            nlohmann::json({{"space", "cuda"}, {"layout", "aos"}, {"bytes", 12}, {"all_bytes", 48}}));
}

TEST(NeedReport, explains_a_field_by_every_name_that_it_has) {
  const Scene scene = chain();
  const Needs needs = find_needs(scene, chain_usage());
  const std::string expected =
      "body.svd.s of m::Svd is kept: written by Svd(body.x, body.svd); read by Force(body.svd, body.f)\n"
      "  written by Svd(body.x, body.svd)\n    at svd.h:5:9\n"
      "  read by Force(body.svd, body.f)\n    at force.h:6:1\n";
  for (const char* name : {"body.svd.s", "svd.s", "Svd.s", "m::Svd.s"})
    EXPECT_EQ(scenes::report_why(scene, needs, name), expected) << name;
  const std::string array = scenes::report_why(scene, needs, "svd");
  EXPECT_NE(array.find("body.svd.U of m::Svd is not kept"), std::string::npos);
  EXPECT_NE(array.find("body.svd.s of m::Svd is kept"), std::string::npos);
}

TEST(NeedReport, names_the_nearest_where_there_is_no_such_field) {
  const Scene scene = chain();
  const Needs needs = find_needs(scene, chain_usage());
  try {
    (void)scenes::report_why(scene, needs, "body.sdv.s");
    FAIL();
  } catch (const scenes::UnknownName& error) {
    EXPECT_STREQ(error.what(),
                 "in the scene chain there is no array or field 'body.sdv.s'; did you mean 'body.svd.s'?");
  }
}

}  // namespace
}  // namespace physgen::test
