// Objects of arrays as the bytes that are stored of each, and random numbers in arrays of any type.
#pragma once

#include "topology_checks.h"

namespace physgen::test {

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

// Code that can do without the arrays' types does: it is compiled once, not for each of the many pairs.

/// The stored bytes of one object, element by element, without padding.
using Record = std::vector<std::byte>;
using Records = std::vector<Record>;

inline Record record_at(const UntypedArray& untyped, index_t i) {
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

inline Records records_of(const UntypedArray& untyped) {
  Records records;
  for (index_t i = 0; i < untyped.size; ++i) records.push_back(record_at(untyped, i));
  return records;
}

/// How many objects differ from those that the array must hold.
inline index_t count_wrong(const UntypedArray& untyped, const Records& model) {
  if (untyped.size != static_cast<index_t>(model.size())) return untyped.size + 1;
  index_t count = 0;
  for (index_t i = 0; i < untyped.size; ++i) count += record_at(untyped, i) != model[static_cast<std::size_t>(i)];
  return count;
}

inline void expect_records(const UntypedArray& untyped, const Records& model, const std::string& after) {
  ASSERT_EQ(count_wrong(untyped, model), 0) << "after " << after;
}

/// Random numbers: rotations, and numbers of which indices and halves hold some exactly.
inline void put_random_numbers(const UntypedArray& untyped, std::mt19937& random) {
  std::uniform_real_distribution<double> value(-0.99, 0.99);
  for (index_t i = 0; i < untyped.size; ++i) {
    int k = 0;
    for (const FieldInfo& field : untyped.fields) {
      Eigen::Matrix3d R;
      for (int e = 0; e < field.visible_count(); ++e, ++k) {
        if (field.rotation && e % 9 == 0) R = random_rotation(random);
        if (field.quaternion) continue;
        const double drawn = field.type == ElementType::int32     ? static_cast<double>(random() % 1000)
                             : field.type == ElementType::boolean ? static_cast<double>(random() % 2)
                             : is_whole(field.type)               ? std::ldexp(static_cast<double>(random()), 31)
                             : field.rotation                     ? R(e % 9 % 3, e % 9 / 3)
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

}  // namespace physgen::test
