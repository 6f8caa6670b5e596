// The proof: that it refuses every record that is wrong, and that what it says of all pitches and all numbers of
// objects is what counting bytes finds.
#include "plan/proof.h"

#include <gtest/gtest.h>
#include <physgen/layout.h>

#include <random>
#include <stdexcept>

#include "models.h"

namespace physgen::plan {
namespace {

using namespace model;  // enumerations of schemas
using namespace test;   // models.h

class Fault : public testing::Test {
 protected:
  // The first complaint about the record as it has been changed; the emitter would have stopped with it.
  [[nodiscard]] std::string first() const { return first_of(record); }
  [[nodiscard]] static std::string first_of(const Record& changed) {
    const auto found = violations(changed);
    std::string refused = "none";
    try {
      require_sound(changed);
    } catch (const std::logic_error& error) {
      refused = error.what();
    }
    EXPECT_EQ(refused, found.empty() ? "none" : "physgen planned a record that is not sound: " + found.front());
    return found.empty() ? "none" : found.front();
  }

  model::Object declared = object("A", {scalar("d", Element::float64), field("v", Shape::vector, 3), scalar("x"),
                                        stored(field("h", Shape::vector, 5), Encoding::half)});
  Record record = plan_record(declared, Space::host, no_objects);
};

TEST_F(Fault, none_is_found_in_a_sound_record) { EXPECT_EQ(first(), "none"); }

TEST_F(Fault, an_overlap_is_refused_with_both_names) {
  record.slots[2].offset.with_float -= 4;
  EXPECT_EQ(first(), "test::A on the host with Real = float: v and x share byte 16");
}

TEST_F(Fault, an_overlap_in_one_precision_only_is_refused) {
  record.slots[2].offset.with_double = 8;
  EXPECT_EQ(first(), "test::A on the host with Real = double: v and x share byte 8");
}

TEST_F(Fault, a_misaligned_element_is_refused) {
  record.bytes = {100, 100};
  record.slots[2].offset.with_double = 52;
  EXPECT_EQ(first(), "test::A on the host with Real = double: x at byte 52 is not aligned to its 8 bytes");
}

TEST_F(Fault, a_misaligned_half_on_cuda_is_refused) {
  record = plan_record(declared, Space::cuda, no_objects);
  record.bytes = {100, 100};
  record.slots[3].offset.with_float = 51;
  EXPECT_EQ(first(), "test::A on CUDA with Real = float: h at byte 51 is not aligned to its 2 bytes");
}

TEST_F(Fault, an_element_behind_the_end_is_refused) {
  record.bytes.with_float -= 2;
  EXPECT_EQ(first(), "test::A on the host with Real = float: h at byte 24 ends at byte 34 of a record of 32");
}

TEST_F(Fault, an_element_before_the_beginning_is_refused) {
  record.slots[0].offset = {-8, -8};
  EXPECT_NE(first(), "none");
}

TEST_F(Fault, records_aligned_to_less_than_an_element_are_refused) {
  record.alignment.with_float = 4;
  EXPECT_EQ(first(), "test::A on the host with Real = float: records are aligned to 4 bytes, d needs 8");
}

TEST_F(Fault, a_wrong_stride_of_nested_objects_is_refused) {
  const auto outer = object("Outer", {array(nested("a", "test::A"), 3)});
  Record wrong = plan_record(outer, Space::host, [this](const std::string&) -> const Record& { return record; });
  ASSERT_EQ(first_of(wrong), "none");
  wrong.slots[0].stride.with_float -= 16;
  EXPECT_EQ(first_of(wrong), "test::Outer on the host with Real = float: a[0].h and a[1].d share byte 24");
}

TEST_F(Fault, any_offset_that_is_moved_by_a_byte_is_refused) {
  const Record sound = record;
  for (const auto precision : precisions) {
    for (std::size_t f = 0; f < sound.slots.size(); ++f) {
      for (const int by : {-1, 1}) {
        record = sound;
        record.slots[f].offset.of(precision) += by;
        EXPECT_NE(first(), "none") << declared.fields[f].name << " moved by " << by;
      }
    }
  }
}

TEST_F(Fault, any_two_fields_at_one_offset_are_refused) {
  const Record sound = record;
  for (const auto precision : precisions) {
    for (std::size_t f = 0; f < sound.slots.size(); ++f) {
      for (std::size_t other = 0; other < sound.slots.size(); ++other) {
        if (f == other) continue;
        record = sound;
        record.slots[f].offset.of(precision) = sound.slots[other].offset.of(precision);
        EXPECT_NE(first(), "none") << declared.fields[f].name << " at " << declared.fields[other].name;
      }
    }
  }
}

TEST_F(Fault, a_record_without_its_last_byte_is_refused) {
  for (const auto precision : precisions) {
    record.bytes.of(precision) -= 1;
    EXPECT_NE(first(), "none");
    record.bytes.of(precision) += 1;
  }
  EXPECT_EQ(first(), "none");
}

// ---- Random objects -------------------------------------------------------------------------------------------------

constexpr unsigned seed = 20240917;

// Objects of random fields in random formats, which nest each other.
model::Schema random_schema(int objects) {
  std::mt19937 random(seed);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  constexpr Element elements[] = {Element::real, Element::index, Element::float32, Element::float64, Element::int32};
  const auto format = [&] { return model::Format{static_cast<Encoding>(below(6)), false}; };
  model::Schema all = schema({});
  for (int o = 0; o < objects; ++o) {
    std::vector<model::Field> fields;
    for (int f = 1 + below(8); f > 0; --f) {
      const std::string name = "f" + std::to_string(f);
      model::Field made = field(name, Shape::matrix, 1 + below(4), 1 + below(4), elements[below(5)]);
      if (made.element != Element::index && made.element != Element::int32) {
        made.host_format = format();
        made.cuda_format = format();
      }
      if (below(6) == 0) {
        made = rotation(name);
        made.host_format.quaternion = below(2) == 0;
        made.cuda_format = {static_cast<Encoding>(below(6)), true};
      }
      if (o > 0 && below(4) == 0) made = nested(name, "test::O" + std::to_string(o - 1 - below(std::min(o, 3))));
      if (below(3) == 0) made.array_extent = 1 + below(2);
      fields.push_back(made);
    }
    all.objects.push_back(object("O" + std::to_string(o), fields));
    if (o % 10 == 0) all.objects.back().fields = {scalar("d", elements[below(5)])};  // keeps nesting from exploding
  }
  return all;
}

TEST(Proof, finds_random_objects_sound) {
  const model::Schema all = random_schema(200);
  for (const Space space : {Space::host, Space::cuda}) {
    const Records records(all, space);
    for (const model::Object& o : all.objects) {
      ASSERT_EQ(violations(records.of(o.qualified_name())), std::vector<std::string>{}) << "seed " << seed;
    }
  }
}

// Whether every element of `objects` objects lies in the memory held for them, aligned to its size, on bytes of its
// own; what is wrong with the first that does not.
std::string addresses(const Record& record, Precision precision, index_t objects, index_t padded, index_t pitch,
                      index_t record_bytes) {
  std::vector<bool> taken(static_cast<std::size_t>(padded * record_bytes));
  for (const Run& run : runs(record)) {
    const index_t size = element_bytes(run.field(), record.space).of(precision);
    for (index_t i = 0; i < objects; ++i) {
      for (index_t k = 0; k < run.count; ++k) {
        const index_t offset = run.offset.of(precision) + k * size;
        const index_t address = i / pitch * pitch * record_bytes + offset * pitch + i % pitch * size;
        const std::string at = run.name() + " of object " + std::to_string(i) + " at " + std::to_string(address);
        if (address % size != 0) return at + " is misaligned";
        if (address < 0 || address + size > padded * record_bytes) return at + " lies outside";
        for (index_t b = address; b < address + size; ++b) {
          if (taken[static_cast<std::size_t>(b)]) return at + " is another's";
          taken[static_cast<std::size_t>(b)] = true;
        }
      }
    }
  }
  return "sound";
}

// As the layouts of the runtime would place them, in numbers of objects around those of tiles.
template <class Layout>
void addresses_are_sound(const model::Schema& all) {
  for (const Space space : {Space::host, Space::cuda}) {
    const Records records(all, space);
    for (const model::Object& o : all.objects) {
      const Record& record = records.of(o.qualified_name());
      if (record.bytes.with_double > 4000) continue;  // nested many times; others have all that it has
      for (const auto precision : precisions) {
        const int bytes = Layout::record_bytes(record.bytes.of(precision), record.alignment.of(precision));
        for (const index_t objects : {1, 2, 9, 33, 96}) {
          ASSERT_EQ(addresses(record, precision, objects, Layout::padded(objects), Layout::pitch(objects), bytes),
                    "sound")
              << o.name << ", " << objects << " objects, records of " << bytes << " bytes, seed " << seed;
        }
      }
    }
  }
}

template <class Layout>
class LawOfAddresses : public testing::Test {};
using Layouts = testing::Types<Aos, AosPadded, Aosoa<2>, Aosoa<4>, Aosoa<8>, Aosoa<32>, Soa>;
TYPED_TEST_SUITE(LawOfAddresses, Layouts);

TYPED_TEST(LawOfAddresses, gives_every_element_aligned_bytes_of_its_own) {
  model::Schema all = random_schema(40);
  // The record that asks most of a tile of two: eight bytes, and two.
  all.objects.push_back(object("Wide", {scalar("d", Element::float64), stored(scalar("h"), Encoding::half)}));
  addresses_are_sound<TypeParam>(all);
}

}  // namespace
}  // namespace physgen::plan
