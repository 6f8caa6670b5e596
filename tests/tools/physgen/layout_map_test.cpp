// Where `physgen layout` says that elements lie: compared with the runtime's law of addresses byte by byte, for random
// records in all layouts, and counts of sectors with brute force and with numbers worked out by hand.
#include "plan/layout_map.h"

#include <gtest/gtest.h>
#include <physgen/layout.h>

#include <algorithm>
#include <functional>
#include <set>

#include "layout_boxes.h"
#include "layout_cases.h"

namespace physgen::command {
namespace {

using plan::assumed_objects;
using plan::Precision;
using plan::Segment;

/// The addresses that the runtime gives for a layout.
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

TEST(LayoutMap, has_segments_that_fill_the_record) {
  for_random_records([](const plan::Record& record, Precision precision) {
    for (const Law& law : laws()) {
      const LayoutMap map = map_layout(record, law.layout, precision);
      std::vector<std::string> bytes(static_cast<std::size_t>(map.record_bytes), "--");
      for (const Planned& element : planned_elements(record, precision))
        for (int b = 0; b < element.bytes; ++b) bytes[static_cast<std::size_t>(element.offset + b)] = element.name;
      int end = 0;
      for (const Segment& segment : map.segments) {
        ASSERT_EQ(segment.offset, end);
        for (; end < segment.offset + segment.bytes; ++end) {
          std::string name = "--";
          if (segment.accessor >= 0) {
            const Accessor& accessor = map.accessors[static_cast<std::size_t>(segment.accessor)];
            name = accessor.runs[static_cast<std::size_t>(segment.run)].name + "#" +
                   std::to_string((end - segment.offset) / accessor.bytes);
          }
          ASSERT_EQ(name, bytes[static_cast<std::size_t>(end)]) << model::layout_word(law.layout) << ", byte " << end;
        }
      }
      ASSERT_EQ(end, map.record_bytes);
      ASSERT_EQ(std::count(bytes.begin(), bytes.end(), "--"), map.padding_bytes());
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
  const plan::Sectors sectors = map_layout(records.of(object.qualified_name()), layout, precision).accessors[0].sectors;
  EXPECT_EQ(sectors.fewest, sectors.most);
  return std::to_string(sectors.most);
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

}  // namespace
}  // namespace physgen::command
