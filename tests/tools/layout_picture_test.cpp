// What `physgen layout` draws, and what it says of wrong words.
#include "layout_picture.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "layout_cases.h"

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

TEST(LayoutMaps, say_what_to_write_instead_of_a_wrong_word) {
  EXPECT_EQ(error_of({{"Strain"}, "both", "float", ""}),
            "there is no object 'Strain' in test.h; it declares Node, Stress");
  EXPECT_EQ(error_of({{}, "gpu", "float", ""}), "there is no space 'gpu'; write host, cuda or both");
  EXPECT_EQ(error_of({{}, "both", "half", ""}), "Real cannot be 'half'; write float or double");
  EXPECT_EQ(error_of({{}, "both", "float", "tiles"}),
            "there is no layout 'tiles'; write aos, aos_padded, soa, 'aosoa(32)' or all");
  for (const char* tile : {"0", "1", "12", "2048", "", "-2", "99999999999", "3x"})
    EXPECT_EQ(error_of({{}, "both", "float", std::string("aosoa(") + tile + ")"}),
              std::string("the tile of 'aosoa(") + tile +
                  ")' is not a power of two from 2 to 1024; write 'aosoa(16)' or 'aosoa(32)'");
}

TEST(LayoutText, draws_records_channels_and_costs) {
  EXPECT_EQ(layout_text(layout_maps(stress(), {{}, "cuda", "float", ""})),
            R"(model::Node on cuda, aos_padded, Real = float
  records of 16 bytes, 4 of them padding

    byte  object    +0          +12        sectors
       0       0  | x[0]..[2] | -- 4 -- |  0
      16       1  | x[0]..[2] | -- 4 -- |  0
      32       2  | x[0]..[2] | -- 4 -- |  1
      48       3  | x[0]..[2] | -- 4 -- |  1
     ...     ...
     496      31  | x[0]..[2] | -- 4 -- |  15

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
  expect(draw("aos"), {"points[0].d", "... 5 more ...", "k[0](0,0)..[4](99,99)"});
  expect(draw("aosoa(32)"), {"points[0].d", "points[999].d", "k[0](0,0)", "k[4](99,99)"});
}

/// Whether every tag is closed by its own name, and nothing but entities begins with an ampersand.
void expect_well_formed(const std::string& xml) {
  std::vector<std::string> open;
  std::size_t end = 0;
  for (std::size_t begin = xml.find('<'); begin != std::string::npos; begin = xml.find('<', end)) {
    end = xml.find('>', begin);
    ASSERT_NE(end, std::string::npos);
    const std::string tag = xml.substr(begin + 1, end - begin - 1);
    ASSERT_EQ(tag.find('<'), std::string::npos) << tag;
    ASSERT_EQ(std::count(tag.begin(), tag.end(), '"') % 2, 0) << tag;
    if (tag.front() == '?' || tag.back() == '/') continue;
    if (tag.front() == '/') {
      ASSERT_FALSE(open.empty());
      ASSERT_EQ(tag.substr(1), open.back());
      open.pop_back();
    } else {
      open.push_back(tag.substr(0, tag.find(' ')));
    }
  }
  EXPECT_TRUE(open.empty());
  for (std::size_t at = xml.find('&'); at != std::string::npos; at = xml.find('&', at + 1))
    EXPECT_NE(xml.substr(at, 6).find(';'), std::string::npos);
}

TEST(LayoutSvg, is_well_formed_and_names_every_object_field_and_layout) {
  for (const model::Schema& all : {stress(), random_schema(3), random_schema(5), large_schema()}) {
    const auto maps = layout_maps(all, {{}, "both", "double", "all"});
    const std::string svg = layout_svg(maps);
    expect_well_formed(svg);
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
    EXPECT_EQ(svg.find("href"), std::string::npos) << "needs another file";
    for (const LayoutMap& map : maps) {
      EXPECT_NE(svg.find(">" + map.object + "<"), std::string::npos);
      EXPECT_NE(svg.find(">" + layout_word(map.layout) + " on "), std::string::npos);
      for (const Accessor& accessor : map.accessors)
        EXPECT_NE(svg.find(">" + accessor.name.substr(0, 12)), std::string::npos) << accessor.name;
    }
  }
}

}  // namespace
}  // namespace physgen::command
