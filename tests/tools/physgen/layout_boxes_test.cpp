// The boxes that `physgen layout` shows, the text that is drawn of them, and messages about wrong words.
#include "layout_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "layout_cases.h"
#include "layout_request.h"

namespace physgen::command {
namespace {

model::Schema stress() {
  auto pressure = scalar("pressure");
  pressure.cuda_format.encoding = Encoding::half;
  auto all = schema({object("Node", {field("x", Shape::vector, 3)}, "model"),
                     object("Stress", {field("sigma", Shape::symmetric, 3, 3), pressure}, "model")});
  all.objects[0].host_layout = all.objects[0].cuda_layout = aos_padded;
  return all;
}

std::vector<std::string> titles(const std::vector<LayoutMap>& maps) {
  std::vector<std::string> all;
  for (const LayoutMap& map : maps) all.push_back(map.object + " " + layout_word(map.layout) + " " + space_words(map));
  return all;
}

std::string error_of(const LayoutRequest& request) {
  try {
    (void)layout_maps(stress(), request);
  } catch (const LayoutError& error) {
    return error.what();
  }
  return "";
}

TEST(LayoutMaps, are_the_objects_own_layouts_and_one_where_both_spaces_agree) {
  EXPECT_EQ(titles(layout_maps(stress(), {})),
            (std::vector<std::string>{"model::Node aos_padded host and cuda", "model::Stress aosoa(16) host",
                                      "model::Stress aosoa(32) cuda"}));
  EXPECT_EQ(titles(layout_maps(stress(), {{"Stress"}, "both", "float", "soa"})),
            (std::vector<std::string>{"model::Stress soa host", "model::Stress soa cuda"}))
      << "formats differ";
  EXPECT_EQ(titles(layout_maps(stress(), {{"model::Stress", "Stress"}, "cuda", "double", "all"})),
            (std::vector<std::string>{"model::Stress aos cuda", "model::Stress aos_padded cuda",
                                      "model::Stress aosoa(32) cuda", "model::Stress soa cuda"}));
}

TEST(LayoutMaps, of_tiles_without_their_size_have_the_standard_tiles_of_each_space) {
  EXPECT_EQ(titles(layout_maps(stress(), {{"Stress"}, "both", "float", "aosoa"})),
            (std::vector<std::string>{"model::Stress aosoa(16) host", "model::Stress aosoa(32) cuda"}));
}

TEST(LayoutMaps, say_what_to_write_instead_of_a_wrong_word) {
  EXPECT_EQ(error_of({{"Strain"}, "both", "float", ""}),
            "there is no object 'Strain' in test.h; it declares Node, Stress");
  EXPECT_EQ(error_of({{}, "gpu", "float", ""}), "there is no space 'gpu'; write host, cuda or both");
  EXPECT_EQ(error_of({{}, "both", "half", ""}), "Real cannot be 'half'; write float or double");
  EXPECT_EQ(error_of({{}, "both", "float", "tiles"}),
            "there is no layout 'tiles'; write aos, aos_padded, soa, 'aosoa(32)', aosoa or all");
  for (const char* tile : {"0", "1", "12", "2048", "", "-2", "99999999999", "3x"})
    EXPECT_EQ(error_of({{}, "both", "float", std::string("aosoa(") + tile + ")"}),
              std::string("the tile of 'aosoa(") + tile +
                  ")' is not a power of two from 2 to 1024; write 'aosoa(16)' or 'aosoa(32)'");
}

TEST(LayoutText, draws_records_channels_and_costs) {
  EXPECT_EQ(layout_text(layout_maps(stress(), {{}, "cuda", "float", ""})),
            R"(model::Node on cuda, aos_padded, Real = float
  records of 16 bytes, 4 of them padding

  byte  object  fields at their offsets, with a bar where a sector of 32 bytes begins
     0  0       | +0 x[0]..[2] : +12 -- 4 -- :
    16  1       : +0 x[0]..[2] : +12 -- 4 -- |
    32  2       | +0 x[0]..[2] : +12 -- 4 -- :
    48  3       : +0 x[0]..[2] : +12 -- 4 -- |
    64  4       | +0 x[0]..[2] : +12 -- 4 -- :
    80  5       : +0 x[0]..[2] : +12 -- 4 -- |
    96  6       | +0 x[0]..[2] : +12 -- 4 -- :
   112  7       : +0 x[0]..[2] : +12 -- 4 -- |
        ...
   496  31      : +0 x[0]..[2] : +12 -- 4 -- |

  field  elements  format  offset  bytes  sectors/request  of ideal  used of 32 B
  x             3  float        0     12               16     4.00x           8.0
  all 3 requests: 48 sectors, 4.00x the ideal 12; 16 different ones

model::Stress on cuda, aosoa(32), Real = float
  records of 26 bytes; tiles of 32 objects, 832 bytes

  byte  element     objects, with a bar where a sector of 32 bytes begins
     0  sigma(0,0)  | 0..7 | 8..15 | 16..23 | 24..31 |
   128  sigma(1,0)  | 0..7 | 8..15 | 16..23 | 24..31 |
   256  sigma(2,0)  | 0..7 | 8..15 | 16..23 | 24..31 |
   384  sigma(1,1)  | 0..7 | 8..15 | 16..23 | 24..31 |
   512  sigma(2,1)  | 0..7 | 8..15 | 16..23 | 24..31 |
   640  sigma(2,2)  | 0..7 | 8..15 | 16..23 | 24..31 |
   768  pressure    | 0..15 | 16..31 |
   832  sigma(0,0)  | 32..39 | 40..47 | 48..55 | 56..63 |
        ...

  field     elements  format  offset  bytes  sectors/request  of ideal  used of 32 B
  sigma            6  float        0     24                4     1.00x          32.0
  pressure         1  half        24      2                2     1.00x          32.0
  all 7 requests: 26 sectors, 1.00x the ideal 26; 26 different ones

A request is what a warp reads at once: one element of objects 0 to 31. Ideal: these elements side by side.
-- is padding. Offsets are those in the record; an element at offset B begins at byte B * pitch of its tile.
)");
}

/// Records of every size: hundreds of fields, long names, arrays of objects.
model::Schema large_schema() {
  std::vector<model::Field> fields;
  for (int i = 0; i < 300; ++i)
    fields.push_back(scalar(std::string(static_cast<std::size_t>(i % 60 + 1), 'm') + std::to_string(i)));
  fields.push_back(field(std::string(60, 'R'), Shape::rotation, 3, 3));
  fields.back().host_format = fields.back().cuda_format = {Encoding::bfloat16, true};
  return schema(
      {object("Wide", fields), object("Point", {field("x", Shape::vector, 3), scalar("d", Element::float64)}),
       object("Deep", {array(nested("points", "test::Point"), 1000), array(field("k", Shape::matrix, 100, 100), 5)})});
}

TEST(LayoutText, is_not_wider_than_110_columns) {
  std::vector<model::Schema> schemas{large_schema()};
  for (unsigned seed = 0; seed < 40; ++seed) schemas.push_back(random_schema(seed));
  for (const model::Schema& all : schemas)
    for (const char* layout : {"all", "aosoa(2)", "aosoa(1024)"}) {
      const std::string text = layout_text(layout_maps(all, {{}, "both", "double", layout}));
      for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end + 1) {
        end = text.find('\n', begin);
        ASSERT_LE(end - begin, 110U) << text.substr(begin, end - begin);
      }
    }
}

TEST(LayoutText, elides_the_middle_of_large_records) {
  const auto draw = [](const char* layout) {
    return layout_text(layout_maps(large_schema(), {{"Deep"}, "host", "float", layout}));
  };
  const auto expect = [](const std::string& text, const std::vector<std::string>& all) {
    EXPECT_LT(std::count(text.begin(), text.end(), '\n'), 40) << text;
    for (const std::string& shown : all)
      EXPECT_NE(text.find(shown), std::string::npos) << shown << " is not in\n" << text;
  };
  expect(draw("aos"), {"points[0].d", " more ... ", "k[0](0,0)..[4](99,99)"});
  expect(draw("aosoa(32)"), {"points[0].d", "points[999].d", "k[0](0,0)", "k[4](99,99)"});
}

/// Every element whose bytes a box claims lies there, by the law of addresses, and boxes of padding hold none.
void expect_true_boxes(const LayoutMap& map) {
  const std::vector<Row> rows = layout_rows(map);
  EXPECT_LE(rows.size(), 30U);
  long long end = 0;
  for (const Row& row : rows)
    for (const Box& box : row.boxes) {
      ASSERT_LT(box.begin, box.end) << box.text;
      ASSERT_LE(end, box.begin) << "boxes stand in the order of their bytes, and share none";
      end = box.end;
      if (box.field < 0) {
        for (const Accessor& accessor : map.accessors)
          for (int e = 0; e < accessor.elements(); ++e)
            for (const long long object : {0LL, 1LL, 7LL, 31LL, map.pitch - 1, plan::assumed_objects - 1}) {
              if (object >= plan::assumed_objects) continue;
              const long long begin = map.address(accessor.offset(e), accessor.bytes, object);
              ASSERT_TRUE(begin >= box.end || begin + accessor.bytes <= box.begin) << row.name << " " << box.text;
            }
        continue;
      }
      const Accessor& accessor = map.accessors[static_cast<std::size_t>(box.field)];
      ASSERT_TRUE(box.elements == 1 || box.objects == 1);
      long long begin = box.begin;
      for (long long object = box.object; object < box.object + box.objects; ++object)
        for (int e = box.element; e < box.element + box.elements; ++e, begin += accessor.bytes)
          ASSERT_EQ(begin, map.address(accessor.offset(e), accessor.bytes, object))
              << element_name(accessor, e) << " of object " << object;
      ASSERT_EQ(begin, box.end);
    }
}

TEST(LayoutBoxes, hold_the_elements_that_they_claim) {
  std::vector<model::Schema> schemas{stress(), large_schema()};
  for (unsigned seed = 0; seed < 20; ++seed) schemas.push_back(random_schema(seed));
  for (const model::Schema& all : schemas)
    for (const char* layout : {"all", "aosoa(2)", "aosoa(1024)"})
      for (const LayoutMap& map : layout_maps(all, {{}, "both", "double", layout})) {
        SCOPED_TRACE(map.object + " " + layout_word(map.layout));
        expect_true_boxes(map);
      }
}

TEST(LayoutJson, has_the_boxes_of_the_text_and_the_costs_of_every_field) {
  const std::string json = layout_json(layout_maps(stress(), {{"Node"}, "cuda", "float", ""}));
  for (const char* part : {R"("physgen_layout": 1)", R"("object": "model::Node")", R"("layout": "aos_padded")",
                           R"("record": "records of 16 bytes, 4 of them padding")", R"("sectors": 48)",
                           R"("ideal_sectors": 12)", R"("begin": 496)", R"("text": "+12 -- 4 --")"})
    EXPECT_NE(json.find(part), std::string::npos) << part << " is not in\n" << json;
  std::size_t boxes = 0;
  for (std::size_t at = json.find("\"begin\""); at != std::string::npos; at = json.find("\"begin\"", at + 1)) ++boxes;
  EXPECT_EQ(boxes, 18U) << "two of each of nine objects";
}

}  // namespace
}  // namespace physgen::command
