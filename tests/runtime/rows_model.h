// Rows of random entries, and the vectors of vectors that they are held against.
#pragma once

#include <physgen/kernels/math.h>
#include <physgen/launch/in_lanes.h>
#include <physgen/row_arrays.h>

#include <limits>

#include "array_model.h"

namespace physgen::test {

/// @tparam kLanes as lanes<W>() takes it
template <class Real_, class Space_, class Layout, int kLanes_ = 0>
struct RowsCase {
  using Real = Real_;
  using Space = Space_;
  static constexpr int lanes = kLanes_;
  template <class Object>
  using Array = physgen::Array<Object, Real, Space, Layout>;
  using Rows = RowArrays<Array<elasticity::IncidenceRangeObject>, Array<elasticity::IncidenceObject>>;
  using Entry = typename Rows::Value;
};

template <class Entry>
using RowModel = std::vector<std::vector<Entry>>;

/// Rows of 0 to `longest` entries that name `targets` objects; `local` numbers the entries.
template <class Entry>
RowModel<Entry> random_rows(index_t n, int longest, index_t targets, std::mt19937& random) {
  RowModel<Entry> rows(static_cast<std::size_t>(n));
  std::int32_t number = 0;
  for (auto& row : rows) {
    const int length = std::uniform_int_distribution<int>(0, longest)(random);
    for (int k = 0; k < length; ++k) {
      row.push_back(
          {std::uniform_int_distribution<std::int32_t>(0, static_cast<std::int32_t>(targets) - 1)(random), number++});
    }
  }
  return rows;
}

template <class Rows>
auto objects_of_rows(const Rows& rows) {
  const RowArrays<elasticity::IncidenceRangeArray<float>, elasticity::IncidenceArray<float>> host(rows);
  RowModel<typename Rows::Value> model(static_cast<std::size_t>(host.size()));
  for (index_t i = 0; i < host.size(); ++i) {
    const auto range = host.ranges().view().get(i);
    for (index_t k = range.begin; k < range.end; ++k) {
      const auto entry = host.entries().view().get(k);
      model[static_cast<std::size_t>(i)].push_back({entry.element, entry.local});
    }
  }
  return model;
}

template <class Rows>
void expect_rows(const Rows& rows, const RowModel<typename Rows::Value>& expected) {
  const auto found = objects_of_rows(rows);
  ASSERT_EQ(found.size(), expected.size());
  std::size_t entries = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    entries += expected[i].size();
    ASSERT_EQ(found[i].size(), expected[i].size()) << "row " << i;
    for (std::size_t k = 0; k < expected[i].size(); ++k) {
      ASSERT_EQ(found[i][k].element, expected[i][k].element) << "entry " << k << " of row " << i;
      ASSERT_EQ(found[i][k].local, expected[i][k].local) << "entry " << k << " of row " << i;
    }
  }
  ASSERT_EQ(rows.entries().size(), static_cast<index_t>(entries)) << "no entry outlives its row";
  rows.check();
}

/// Puts what no kernel may see into the memory behind the last object.
template <class Array>
void plant_garbage(Array& array) {
  const UntypedArray untyped = array.untyped();
  for (index_t i = untyped.size; i < untyped.padded; ++i) {
    for (const FieldInfo& field : untyped.fields) {
      const int size = element_bytes(field.type);
      for (int k = 0; k < field.count; ++k) {
        std::byte* at =
            untyped.base + address_by_law(field.offset + k * size, i, untyped.pitch, untyped.record_bytes, size);
        const std::uint64_t bits = field.type == ElementType::int32     ? 0x7fffffff
                                   : field.type == ElementType::float64 ? 0x7ff4000000000000
                                                                        : 0x7fa00000;
        std::memcpy(at, &bits, static_cast<std::size_t>(size));
      }
    }
  }
}

}  // namespace physgen::test
