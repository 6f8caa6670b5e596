// Where `physgen layout` says that elements lie: compared with the runtime's law of addresses byte by byte, for random
// records in all layouts, and counts of sectors with brute force and with numbers worked out by hand.
#include <gtest/gtest.h>
#include <physgen/layout.h>

#include <algorithm>
#include <functional>
#include <random>
#include <set>

#include "plan/layout_map.h"
#include "layout_picture.h"
#include "models.h"

namespace physgen::command {
namespace {

using model::Element;
using model::Encoding;
using model::Format;
using model::LayoutKind;
using model::Shape;
using model::Space;
using test::array;
using test::field;
using test::nested;
using test::object;
using test::scalar;
using test::schema;

constexpr model::Layout aos{LayoutKind::aos, 0}, aos_padded{LayoutKind::aos_padded, 0}, soa{LayoutKind::soa, 0};
constexpr model::Layout aosoa(int tile) { return {LayoutKind::aosoa, tile}; }

/// What the runtime says of a layout.
struct Law {
  model::Layout layout;
  index_t pitch;
  std::function<int(int bytes, int alignment)> record_bytes;
};

template <class Layout>
Law law(model::Layout layout) {
  return {layout, Layout::pitch(assumed_objects), [](int b, int a) { return Layout::record_bytes(b, a); }};
}

std::vector<Law> laws() {
  return {law<Aos>(aos),
          law<AosPadded>(aos_padded),
          law<Soa>(soa),
          law<Aosoa<2>>(aosoa(2)),
          law<Aosoa<4>>(aosoa(4)),
          law<Aosoa<16>>(aosoa(16)),
          law<Aosoa<32>>(aosoa(32)),
          law<Aosoa<1024>>(aosoa(1024))};
}

/// Random object types; later ones nest earlier ones.
model::Schema random_schema(unsigned seed) {
  std::mt19937 random(seed);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  std::vector<model::Object> objects;
  for (int o = 0; o < 4; ++o) {
    std::vector<model::Field> fields;
    const int count = 1 + below(6);
    for (int f = 0; f < count; ++f) {
      const std::string name = "f" + std::to_string(f);
      if (o > 0 && below(4) == 0) {
        fields.push_back(nested(name, "test::O" + std::to_string(below(o))));
      } else {
        constexpr Shape shapes[] = {Shape::scalar,   Shape::vector, Shape::matrix,  Shape::symmetric,
                                    Shape::diagonal, Shape::skew,   Shape::rotation};
        constexpr Element elements[] = {Element::real, Element::index, Element::float32, Element::float64};
        const Shape shape = shapes[below(7)];
        const int n = shape == Shape::scalar ? 1 : 3;
        fields.push_back(field(name, shape, n, shape == Shape::scalar || shape == Shape::vector ? 1 : n));
        if (shape != Shape::rotation) fields.back().element = elements[below(4)];
        for (Format* format : {&fields.back().host_format, &fields.back().cuda_format})
          if (fields.back().element != Element::index)
            *format = {static_cast<Encoding>(below(6)), shape == Shape::rotation && below(2) == 0};
      }
      if (below(4) == 0) fields.back().array_extent = 1 + below(4);
    }
    objects.push_back(object("O" + std::to_string(o), fields));
    if (below(4) == 0) objects.back().alignment = 32;
  }
  return schema(objects);
}

/// Calls check(record, precision) for objects of every kind.
void for_random_records(const std::function<void(const plan::Record&, Precision)>& check) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    const model::Schema all = random_schema(seed);
    for (const Space space : {Space::host, Space::cuda}) {
      const plan::Records records(all, space);
      for (const model::Object& object : all.objects)
        for (const Precision precision : {Precision::with_float, Precision::with_double}) {
          SCOPED_TRACE("seed " + std::to_string(seed) + ", " + object.name);
          check(records.of(object.qualified_name()), precision);
        }
    }
  }
}

/// The planned place of one element.
struct Planned {
  std::string name;
  int offset;
  int bytes;
};

std::vector<Planned> planned_elements(const plan::Record& record, Precision precision) {
  const auto of = [&](plan::Bytes b) { return precision == Precision::with_float ? b.with_float : b.with_double; };
  std::vector<Planned> all;
  for (const plan::Run& run : plan::runs(record)) {
    const int bytes = of(plan::element_bytes(run.field(), record.space));
    for (int k = 0; k < run.count; ++k)
      all.push_back({run.name() + "#" + std::to_string(k), of(run.offset) + k * bytes, bytes});
  }
  return all;
}

int record_bytes(const Law& law, const plan::Record& record, Precision precision) {
  return precision == Precision::with_float ? law.record_bytes(record.bytes.with_float, record.alignment.with_float)
                                            : law.record_bytes(record.bytes.with_double, record.alignment.with_double);
}

index_t address(const Law& law, index_t record, const Planned& element, index_t i) {
  return i / law.pitch * law.pitch * record + element.offset * law.pitch + i % law.pitch * element.bytes;
}

TEST(LayoutMap, places_every_element_where_the_runtime_does) {
  for_random_records([](const plan::Record& record, Precision precision) {
    for (const Law& law : laws()) {
      const LayoutMap map = map_layout(record, law.layout, precision);
      ASSERT_EQ(map.pitch, law.pitch);
      ASSERT_EQ(map.record_bytes, record_bytes(law, record, precision));
      std::size_t elements = 0;
      const auto planned = planned_elements(record, precision);
      for (const Accessor& accessor : map.accessors) {
        for (int e = 0; e < accessor.elements(); ++e, ++elements) {
          const std::string name = accessor.runs[static_cast<std::size_t>(e / accessor.run_elements)].name + "#" +
                                   std::to_string(e % accessor.run_elements);
          const auto same = std::ranges::find_if(planned, [&](const Planned& p) { return p.name == name; });
          ASSERT_NE(same, planned.end()) << name;
          ASSERT_EQ(accessor.bytes, same->bytes);
          for (const long long i : {0LL, 1LL, 31LL, 1023LL, 1024LL, 777777LL})
            ASSERT_EQ(map.address(accessor.offset(e), accessor.bytes, i), address(law, map.record_bytes, *same, i))
                << name << " of object " << i;
        }
      }
      ASSERT_EQ(elements, planned.size());
    }
  });
}

TEST(LayoutMap, knows_what_stands_at_every_byte) {
  for_random_records([](const plan::Record& record, Precision precision) {
    for (const Law& law : laws()) {
      if (law.pitch > 64) continue;  // the bytes of whole tiles are visited
      const LayoutMap map = map_layout(record, law.layout, precision);
      std::vector<std::string> bytes(static_cast<std::size_t>(2 * law.pitch * map.record_bytes), "--");
      for (const Planned& element : planned_elements(record, precision))
        for (index_t i = 0; i < 2 * law.pitch; ++i)
          for (int b = 0; b < element.bytes; ++b) {
            std::string& byte = bytes[static_cast<std::size_t>(address(law, map.record_bytes, element, i) + b)];
            ASSERT_EQ(byte, "--") << "taken twice";
            byte = element.name + " of " + std::to_string(i);
          }
      for (std::size_t b = 0; b < bytes.size(); ++b) {
        const auto at = static_cast<long long>(b);
        const Cell cell = map.at(at);
        ASSERT_LE(cell.begin, at);
        ASSERT_GT(cell.end, at);
        std::string name = "--";
        if (cell.accessor >= 0) {
          const Accessor& accessor = map.accessors[static_cast<std::size_t>(cell.accessor)];
          name = accessor.runs[static_cast<std::size_t>(cell.element / accessor.run_elements)].name + "#" +
                 std::to_string(cell.element % accessor.run_elements) + " of " + std::to_string(cell.object);
          ASSERT_EQ(cell.begin, map.address(accessor.offset(cell.element), accessor.bytes, cell.object));
        }
        ASSERT_EQ(name, bytes[b]) << model::layout_word(law.layout) << ", byte " << b;
      }
      const auto padding = std::count(bytes.begin(), bytes.end(), "--");
      ASSERT_EQ(padding, 2 * law.pitch * map.padding_bytes());
    }
  });
}

TEST(LayoutMap, counts_the_sectors_that_brute_force_counts) {
  for_random_records([](const plan::Record& record, Precision precision) {
    for (const Law& law : laws()) {
      const LayoutMap map = map_layout(record, law.layout, precision);
      std::set<index_t> all;
      const auto planned = planned_elements(record, precision);
      long long total = 0;
      long long counted = 0;
      for (const Planned& element : planned) {
        std::set<index_t> request;
        for (index_t i = 0; i < 32; ++i)
          for (int b = 0; b < element.bytes; ++b) request.insert((address(law, map.record_bytes, element, i) + b) / 32);
        total += static_cast<long long>(request.size());
        all.insert(request.begin(), request.end());
        const auto own = std::ranges::find_if(map.accessors, [&](const Accessor& a) {
          return std::ranges::any_of(a.runs, [&](const auto& r) { return element.name.starts_with(r.name + "#"); });
        });
        ASSERT_NE(own, map.accessors.end());
        ASSERT_LE(own->sectors.fewest, static_cast<int>(request.size()));
        ASSERT_GE(own->sectors.most, static_cast<int>(request.size()));
        ASSERT_EQ(own->sectors.ideal, element.bytes);
      }
      for (const Accessor& accessor : map.accessors) counted += accessor.sectors.total;
      ASSERT_EQ(counted, total);
      ASSERT_EQ(sectors_of_warp(map), static_cast<long long>(all.size()));
    }
  });
}

/// Sectors per request of the first field.
std::string sectors(const model::Object& object, model::Layout layout, Precision precision = Precision::with_float) {
  const model::Schema all = schema({object});
  const plan::Records records(all, Space::host);
  return sectors_words(map_layout(records.of(object.qualified_name()), layout, precision).accessors[0].sectors);
}

TEST(LayoutMap, counts_the_known_sectors_of_common_records) {
  const auto matrix = object("F", {field("F", Shape::matrix, 3, 3)});  // 36 bytes
  EXPECT_EQ(sectors(matrix, aos), "32");
  EXPECT_EQ(sectors(matrix, aosoa(32)), "4");
  EXPECT_EQ(sectors(matrix, aosoa(16)), "4");
  EXPECT_EQ(sectors(matrix, aosoa(8)), "4");
  EXPECT_EQ(sectors(matrix, aosoa(4)), "8");
  EXPECT_EQ(sectors(matrix, soa), "4");
  EXPECT_EQ(sectors(matrix, soa, Precision::with_double), "8");
  const auto node = object("Node", {field("x", Shape::vector, 3)});
  EXPECT_EQ(sectors(node, aos), "12");
  EXPECT_EQ(sectors(node, aos_padded), "16");  // 32 times float4
  auto small = object("Small", {field("F", Shape::matrix, 3, 3)});
  small.fields[0].host_format.encoding = Encoding::half;
  EXPECT_EQ(sectors(small, aosoa(32)), "2");
  EXPECT_EQ(sectors(small, soa), "2");
  EXPECT_EQ(sectors(small, aos), "18");  // 18 bytes
}

TEST(LayoutMap, gives_the_fields_of_an_array_of_objects_one_accessor_each) {
  const auto all = schema({object("Point", {field("x", Shape::vector, 3), scalar("d", Element::float64)}),
                           object("Shape", {array(nested("points", "test::Point"), 10)})});
  const plan::Records records(all, Space::host);
  const LayoutMap map = map_layout(records.of("test::Shape"), aosoa(32), Precision::with_float);
  ASSERT_EQ(map.accessors.size(), 2U);
  EXPECT_EQ(map.accessors[0].name, "points[0..9].x");
  EXPECT_EQ(map.accessors[0].elements(), 30);
  EXPECT_EQ(element_name(map.accessors[0], 29), "points[9].x[2]");
  EXPECT_EQ(map.accessors[0].offset(29), 9 * 24 + 8 + 8);
  EXPECT_EQ(map.padding_bytes(), 10 * 4);
  EXPECT_EQ(shown_segments(map), (std::vector<int>{0, 1, 2, -1, 27, 28, 29}));
}

TEST(LayoutWords, name_elements_as_values_index_them) {
  auto rotation = field("R", Shape::rotation, 3, 3);
  rotation.cuda_format = {Encoding::half, true};
  const auto all =
      schema({object("A", {scalar("p"), field("v", Shape::vector, 3), field("s", Shape::diagonal, 3, 3),
                           field("F", Shape::matrix, 2, 3), field("S", Shape::symmetric, 3, 3),
                           field("W", Shape::skew, 3, 3), rotation, array(field("k", Shape::symmetric, 3, 3), 4)})});
  const plan::Records records(all, Space::cuda);
  const LayoutMap map = map_layout(records.of("test::A"), aos, Precision::with_double);
  std::string names;
  for (const Accessor& accessor : map.accessors) {
    names += run_name(accessor, 0) + " " + element_name(accessor, std::min(2, accessor.elements() - 1)) + " " +
             format_word(accessor, map.precision) + "\n";
  }
  EXPECT_EQ(names,
            "p p double\nv[0]..[2] v[2] double\ns[0]..[2] s[2] double\nF(0,0)..(1,2) F(0,1) double\n"
            "S(0,0)..(2,2) S(2,0) double\nW(1,0)..(2,1) W(2,1) double\nR.w..z R.y quaternion(half)\n"
            "k[0](0,0)..[3](2,2) k[0](2,0) double\n");
}

// ---- What is drawn
// ---------------------------------------------------------------------------------------------------

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
