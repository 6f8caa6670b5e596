// Arrays of many types, layouts and sizes under random copies and changes, held against the bytes of their objects.
#include <physgen/simd_access.h>

#include <array>
#include <fstream>
#include <thread>

#include "topology_checks.h"

namespace physgen::test {
namespace {

/// Records of 2 and of 6 bytes.
template <int kElements>
struct HalvesObject : WithoutAccessors {
  static constexpr std::string_view name = "test::Halves";
  template <class Real, class Formats>
  struct Record {
    static constexpr int bytes = 2 * kElements;
    static constexpr int alignment = 2;
  };
  template <class Real, class Formats>
  static constexpr std::array<FieldInfo, 1> fields = {
      {field_info<shape::Vector<kElements>, format::Half<>, Real>("h", "", 0, 1, kElements == 1 ? 0 : 0.5)}};
};

/// 2 bytes in a record of 256.
struct AlignedObject : HalvesObject<1> {
  template <class Real, class Formats>
  struct Record {
    static constexpr int bytes = 2;
    static constexpr int alignment = 256;
  };
};

struct CompactTurns : elasticity::DeformationSvdFormats<Host> {
  using U = format::Quaternion<format::Half<>>;
  using V = format::Quaternion16;
  using s = format::Bfloat16;
};

// What can do without the arrays' types does: it is compiled once, not for each of the many pairs.

/// The stored bytes of one object, element by element, without padding.
using Record = std::vector<std::byte>;
using Records = std::vector<Record>;

Record record_at(const UntypedArray& untyped, index_t i) {
  Record record;
  for (const FieldInfo& field : untyped.fields) {
    const int size = element_bytes(field.type);
    for (int k = 0; k < field.count; ++k) {
      const std::byte* element =
          untyped.base + address_by_law(field.offset + k * size, i, untyped.pitch, untyped.record_bytes, size);
      record.insert(record.end(), element, element + size);
    }
  }
  return record;
}

Records records_of(const UntypedArray& untyped) {
  Records records;
  for (index_t i = 0; i < untyped.size; ++i) records.push_back(record_at(untyped, i));
  return records;
}

/// How many objects differ from those that the array must hold.
index_t count_wrong(const UntypedArray& untyped, const Records& model) {
  if (untyped.size != static_cast<index_t>(model.size())) return untyped.size + 1;
  index_t count = 0;
  for (index_t i = 0; i < untyped.size; ++i) count += record_at(untyped, i) != model[static_cast<std::size_t>(i)];
  return count;
}

void expect_records(const UntypedArray& untyped, const Records& model, const std::string& after) {
  ASSERT_EQ(count_wrong(untyped, model), 0) << "after " << after;
}

/// Random numbers: rotations, and numbers of which indices and halves hold some exactly.
void put_random_numbers(const UntypedArray& untyped, std::mt19937& random) {
  std::uniform_real_distribution<double> value(-0.99, 0.99);
  for (index_t i = 0; i < untyped.size; ++i) {
    int k = 0;
    for (const FieldInfo& field : untyped.fields) {
      Eigen::Matrix3d R;
      for (int e = 0; e < field.visible_count(); ++e, ++k) {
        if (field.rotation && e % 9 == 0) R = random_rotation(random);
        if (field.quaternion) continue;
        const double drawn = field.type == ElementType::int32 ? static_cast<double>(random() % 1000)
                             : field.rotation                 ? R(e % 9 % 3, e % 9 / 3)
                                                              : value(random);
        putdata(untyped, i, k, drawn);
      }
    }
  }
}

template <class Object>
Array<Object, double, Host, Aos> random_objects(index_t n, std::mt19937& random) {
  Array<Object, double, Host, Aos> objects(n);
  put_random_numbers(objects.untyped(), random);
  return objects;
}

/// Objects of one array in the form of another, each by a copy of its own: what a copy of all must give.
/// @param one, converted an AoS record in the form of each
Records converted_one_by_one(const UntypedArray& from, index_t begin, index_t end, const UntypedArray& one,
                             const UntypedArray& converted) {
  Records records;
  for (index_t i = begin; i < end; ++i) {
    const Record record = record_at(from, i);
    std::size_t read = 0;
    for (const FieldInfo& field : one.fields) {
      const auto bytes = static_cast<std::size_t>(field.count * element_bytes(field.type));
      std::memcpy(one.base + field.offset, record.data() + read, bytes);
      read += bytes;
    }
    copy(converted, one);
    records.push_back(record_at(converted, 0));
  }
  return records;
}
template <class To, class From>
Records converted_one_by_one(const From& from, index_t begin, index_t end) {
  const Array<typename From::Object, typename From::View::Precision, Host, Aos, typename From::Formats> one(1);
  const Array<typename To::Object, typename To::View::Precision, Host, Aos, typename To::Formats> converted(1);
  return converted_one_by_one(from.untyped(), begin, end, one.untyped(), converted.untyped());
}

/// Renumbers the field of indices to numbers in random order, and expects all other elements as before.
void renumber_field(const UntypedArray& untyped, const FieldInfo& field, std::mt19937& random) {
  const std::vector<index_t> numbers = random_order(1000, random);
  int first = 0;  // the field's first element, as code counts them
  for (const FieldInfo& other : untyped.fields) {
    if (other.offset == field.offset) break;
    first += other.visible_count();
  }
  const int last = first + field.visible_count();
  for (index_t i = 0; i < untyped.size; ++i) {
    for (int k = first; k < last; ++k) {  // initial values may name no object
      if (getdata(untyped, i, k) < 0) putdata(untyped, i, k, 0);
    }
  }
  const Model before = elements_of(untyped);
  renumber(untyped, field.name, numbers);
  const Model after = elements_of(untyped);
  for (std::size_t i = 0; i < before.size(); i += 7) {
    Model::value_type expected = before[i];
    for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(last); ++k) {
      expected[k] = static_cast<double>(numbers[static_cast<std::size_t>(expected[k])]);
    }
    ASSERT_EQ(after[i], expected) << "renumber " << field.name;
  }
}

template <class A, class B>
void fuzz_pair_of_size(index_t n, std::mt19937& random) {
  using Object = typename A::Object;
  A a(n);
  B b(n);
  copy(a, random_objects<Object>(n, random));
  copy(b, a);
  Records model = converted_one_by_one<B>(a, 0, n);
  expect_records(b.untyped(), model, "a copy");
  copy(a, b);
  expect_records(a.untyped(), converted_one_by_one<A>(b, 0, n), "a copy back");

  for (int repeat = 0; repeat < 3; ++repeat) {
    const auto begin = static_cast<index_t>(random() % static_cast<unsigned>(n + 1));
    const auto end = begin + static_cast<index_t>(random() % static_cast<unsigned>(n - begin + 1));
    copy(a, random_objects<Object>(n, random));
    copy_range(b.untyped(), a.untyped(), begin, end);
    const Records part = converted_one_by_one<B>(a, begin, end);
    std::copy(part.begin(), part.end(), model.begin() + begin);
    expect_records(b.untyped(), model, "a copy of " + std::to_string(begin) + " to " + std::to_string(end));
  }

  const std::vector<index_t> erased = random_part(n, random);
  Records kept;
  for (const index_t i : remaining(n, erased)) kept.push_back(model[static_cast<std::size_t>(i)]);
  erase(b, erased);
  model = kept;
  expect_records(b.untyped(), model, "erasing");

  append(b, a);
  const Records added = converted_one_by_one<B>(a, 0, n);
  model.insert(model.end(), added.begin(), added.end());
  expect_records(b.untyped(), model, "appending objects of another form");

  const B fresh(1);
  const Record initial = record_at(fresh.untyped(), 0);
  append(b, 37);
  model.insert(model.end(), 37, initial);
  expect_records(b.untyped(), model, "appending new ones");

  const index_t less = b.size() / 3;
  b.resize(less);
  b.resize(less + 70);
  model.resize(static_cast<std::size_t>(less));
  model.resize(static_cast<std::size_t>(less + 70), initial);
  expect_records(b.untyped(), model, "shrinking and growing");

  for (const FieldInfo& field : b.untyped().fields) {
    if (field.type == ElementType::int32) renumber_field(b.untyped(), field, random);
  }
}

template <class A, class B>
struct Pair {
  static void fuzz() {
    std::mt19937 random(seed());
    for (const index_t n : {0, 1, 2, 3, 31, 32, 33, 63, 64, 65, 127, 1023, 1025, 2049}) {
      // Few objects in most runs: one conversion for each is the slow part.
      fuzz_pair_of_size<A, B>(n, random);
      if (::testing::Test::HasFatalFailure()) FAIL() << A::Object::name << " of " << n << " objects";
    }
  }
};

using namespace elasticity;
using Shapes = tissue::model::ShapesObject;
using Patch = tissue::other::PatchObject;

TEST(ArrayFuzz, of_vectors) {
  Pair<Array<NodePositionObject, float, Host, Aos>, Array<NodePositionObject, float, Host, Soa>>::fuzz();
  Pair<Array<NodePositionObject, float, Host, Aosoa<2>>, Array<NodePositionObject, double, Host, Aosoa<64>>>::fuzz();
  Pair<Array<NodePositionObject, double, Host, AosPadded>, Array<NodePositionObject, float, Host, Aosoa<1024>>>::fuzz();
}
TEST(ArrayFuzz, of_indices) {
  Pair<Array<TetObject, float, Host, Soa>, Array<TetObject, float, Host, Aosoa<4>>>::fuzz();
  Pair<Array<TetObject, float, Host, AosPadded>, Array<TetObject, double, Host, Aosoa<64>>>::fuzz();
}
TEST(ArrayFuzz, of_rotations_and_quaternions) {
  using Svd = DeformationSvdObject;
  Pair<Array<Svd, float, Host, Aos>, Array<Svd, float, Host, Soa, CompactTurns>>::fuzz();
  Pair<Array<Svd, float, Host, Aosoa<64>, CompactTurns>, Array<Svd, double, Host, AosPadded>>::fuzz();
  Pair<Array<Svd, float, Host, Aos, CompactTurns>, Array<Svd, double, Host, Aosoa<4>, CompactTurns>>::fuzz();
  Pair<Array<IndexedFrameObject, float, Host, Aosoa<8>>, Array<IndexedFrameObject, float, Host, Soa>>::fuzz();
}
TEST(ArrayFuzz, of_elements_of_mixed_sizes) {
  using Derivative = StressDerivativeObject;
  Pair<Array<Derivative, float, Host, Aosoa<16>, MixedDerivative>, Array<Derivative, float, Host, Soa>>::fuzz();
  Pair<Array<Derivative, double, Host, Aos>, Array<Derivative, float, Host, Aosoa<2>, MixedDerivative>>::fuzz();
  Pair<Array<Derivative, float, Host, AosPadded, MixedDerivative>,
       Array<Derivative, double, Host, Aosoa<1024>, MixedDerivative>>::fuzz();
}
TEST(ArrayFuzz, of_nested_objects_and_every_shape) {
  Pair<Array<Shapes, float, Host, Aos>, Array<Shapes, float, Host, Soa>>::fuzz();
  Pair<Array<Shapes, double, Host, Aosoa<64>>, Array<Shapes, float, Host, Aosoa<4>>>::fuzz();
  Pair<Array<Patch, float, Host, AosPadded>, Array<Patch, float, Host, Aosoa<32>>>::fuzz();
  Pair<Array<Patch, float, Host, Soa>, Array<Patch, double, Host, Aos>>::fuzz();
}
TEST(ArrayFuzz, of_records_of_two_and_six_bytes) {
  Pair<Array<HalvesObject<1>, float, Host, Aos>, Array<HalvesObject<1>, float, Host, Aosoa<64>>>::fuzz();
  Pair<Array<HalvesObject<1>, float, Host, AosPadded>, Array<HalvesObject<1>, double, Host, Soa>>::fuzz();
  Pair<Array<HalvesObject<3>, float, Host, Aosoa<2>>, Array<HalvesObject<3>, float, Host, AosPadded>>::fuzz();
  Pair<Array<HalvesObject<3>, double, Host, Soa>, Array<HalvesObject<3>, float, Host, Aos>>::fuzz();
}

/// Bytes that this process can have: of the machine, and of its control group where that has a limit.
index_t free_memory() {
  index_t free = 0;
  std::ifstream machine("/proc/meminfo");
  for (std::string name, unit; machine >> name;) {
    if (name == "MemAvailable:" && machine >> free) break;
  }
  free *= 1024;
  index_t limit = 0, used = 0;
  if (std::ifstream("/sys/fs/cgroup/memory.max") >> limit && std::ifstream("/sys/fs/cgroup/memory.current") >> used) {
    free = std::min(free, limit - used);
  }
  return free;
}

TEST(Arrays, of_more_than_two_to_the_31_objects_are_ordinary) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "left out: a sanitizer makes minutes of it";
#endif
  using Two = HalvesObject<1>;
  constexpr index_t n = (index_t{1} << 31) + 100;
  constexpr index_t needed = 2 * 2 * n + (index_t{1} << 30);  // both arrays, and something to spare
  const index_t free = free_memory();
  if (free < needed) GTEST_SKIP() << "left out: " << free << " bytes of memory are free, and it takes " << needed;
  Array<Two, float, Host, Soa> channels(n);
  for (const index_t i : {index_t{0}, index_t{1} << 31, n - 1}) channels.putdata(i, 0, static_cast<double>(i % 1021));
  Array<Two, float, Host, Aosoa<64>> tiles(n);
  copy(tiles, channels);
  for (const index_t i : {index_t{0}, index_t{1} << 31, n - 1}) {
    EXPECT_EQ(tiles.getdata(i, 0), static_cast<double>(i % 1021)) << i;
  }
  EXPECT_EQ(tiles.getdata((index_t{1} << 31) - 1, 0), 0) << "the initial value";

  // In packs, too: the whole one at 2^31, and the last of the array.
  constexpr int W = native_lanes<float>;
  const auto lanes_of = [](const auto& array, const auto& pack) {
    const auto view = array.const_view();
    using At = typename std::remove_cvref_t<decltype(view)>::template CursorAt<std::remove_cvref_t<decltype(pack)>>;
    using Pitch = typename std::remove_cvref_t<decltype(view)>::Layout::Pitch;
    const At cursor(view.data(), Pitch(view.pitch()), pack, nullptr);
    std::array<float, W> lanes;
    const batch_t<float, W> batch = cursor.template element<format::Half<>, float>(0);
    batch.store_unaligned(lanes.data());
    return lanes;
  };
  const index_t at = (n - 1) / W * W;
  const auto expect_lanes = [&](const auto& array) {
    EXPECT_EQ(lanes_of(array, Pack<W>{index_t{1} << 31})[0], static_cast<float>((index_t{1} << 31) % 1021));
    const auto last = lanes_of(array, PartialPack<W>{at, 0, static_cast<int>(n - at)});
    EXPECT_EQ(last[static_cast<std::size_t>(n - 1 - at)], static_cast<float>((n - 1) % 1021));
  };
  expect_lanes(channels);
  expect_lanes(tiles);
}

TEST(Arrays, whose_padded_records_no_memory_can_count_are_refused) {
  using Aligned = Array<AlignedObject, float, Host, Aos>;
  static_assert(Aligned::record_bytes == 256);
  const std::string message = message_of([] { const Aligned array(50'000'000'000'000'000); });
  EXPECT_NE(message.find("an array of 50000000000000000 objects of 256 bytes cannot exist"), std::string::npos)
      << message;
  const std::string possible = message_of([] { const Aligned array(9'000'000'000'000'000); });
  EXPECT_NE(possible.find("cannot allocate 2304000000000000"), std::string::npos) << possible;
}

TEST(Arrays, are_copied_by_eight_threads_at_once) {
  std::mt19937 random(seed());
  const index_t n = 5000;
  const auto objects = random_objects<Shapes>(n, random);
  Array<Shapes, float, Host, Soa> source(n);
  copy(source, objects);
  Array<Shapes, float, Host, Aosoa<64>> expected(n);
  copy(expected, source);
  const Records model = records_of(expected.untyped());
  std::array<index_t, 8> wrong{};
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < wrong.size(); ++t) {
    threads.emplace_back([&, t] {
      for (int repeat = 0; repeat < 5; ++repeat) {
        Array<Shapes, float, Host, Aosoa<64>> own(n);
        copy(own, source);
        wrong[t] += count_wrong(own.untyped(), model);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const index_t count : wrong) EXPECT_EQ(count, 0);
}

}  // namespace
}  // namespace physgen::test
