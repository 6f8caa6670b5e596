// Copies between arrays, initial values and single elements, over arrays without their types.
#include <physgen/error.h>
#include <physgen/storage.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <vector>

#include "backend.h"
#include "convert.h"

namespace physgen {

namespace {

std::string describe(const Storage& storage) {
  return std::string(storage.object) + "[" + std::to_string(storage.size) + "] in " + name(storage.space) + " memory";
}

// Whether a tile of `a` and one of `b` hold the same bytes for the same objects.
bool same_tiles(const Storage& a, const Storage& b) {
  if (a.pitch != b.pitch || a.record_bytes != b.record_bytes) return false;
  for (std::size_t f = 0; f < a.fields.size(); ++f) {
    if (a.fields[f].type != b.fields[f].type || a.fields[f].offset != b.fields[f].offset) return false;
  }
  return true;
}

void convert_on_host(const Storage& to, const Storage& from, index_t begin, index_t end) {
  const detail::Addressing to_address(to);
  const detail::Addressing from_address(from);
  // Blocks of objects keep the records of both sides in the cache while field after field is converted.
  constexpr index_t block = 1024;
  const index_t blocks = (end - begin + block - 1) / block;
#pragma omp parallel for if (blocks > 8)
  for (index_t b = 0; b < blocks; ++b) {
    const index_t first = begin + b * block;
    const index_t last = first + block < end ? first + block : end;
    for (std::size_t f = 0; f < to.fields.size(); ++f) {
      const detail::FieldConversion field{to.fields[f].offset, from.fields[f].offset, to.fields[f].type,
                                          from.fields[f].type, to.fields[f].count};
      for (index_t i = first; i < last; ++i) detail::convert_field(to_address, from_address, field, i);
    }
  }
}

ElementInfo find_element(const Storage& storage, index_t i, int k) {
  if (i < 0 || i >= storage.size) {
    throw Error(describe(storage) + ": there is no object " + std::to_string(i));
  }
  int rest = k;
  for (const FieldInfo& field : storage.fields) {
    if (rest >= 0 && rest < field.count) return {field.type, field.offset + rest * element_bytes(field.type)};
    rest -= field.count;
  }
  throw Error(describe(storage) + ": there is no element " + std::to_string(k));
}

}  // namespace

void copy_first(const Storage& to, const Storage& from, index_t count, Stream stream) {
  if (count == 0) return;
  const bool on_host = host_accessible(to.space) && host_accessible(from.space);
  index_t whole = 0;  // objects that move as plain bytes: all, or those in whole tiles
  if (same_tiles(to, from)) {
    whole = count == from.size && count == to.size ? std::min(to.padded, from.padded) : count / to.pitch * to.pitch;
  }
  if (whole > 0) {
    const index_t bytes = whole * to.record_bytes;
    if (on_host) {
      std::memcpy(to.base, from.base, static_cast<std::size_t>(bytes));
    } else {
      backend::copy_bytes(to.base, from.base, bytes, stream);
    }
  }
  if (whole >= count) return;
  if (on_host) {
    convert_on_host(to, from, whole, count);
  } else {
    backend::convert(to, from, whole, count, stream);
  }
}

void copy(const Storage& to, const Storage& from, Stream stream) {
  if (to.object != from.object) {
    throw Error("cannot copy " + describe(from) + " to " + describe(to) + ": the object types differ");
  }
  if (to.size != from.size) {
    throw Error("cannot copy " + describe(from) + " to " + describe(to) + ": resize the target first");
  }
  if (to.base == from.base && to.base != nullptr) {
    throw Error("cannot copy " + describe(from) + " to itself");
  }
  copy_first(to, from, from.size, stream);
}

void initialize(const Storage& storage, index_t begin, index_t end) {
  if (begin == end) return;
  for (const FieldInfo& field : storage.fields) {
    if (field.initial == 0) continue;  // buffers come zeroed
    if (host_accessible(storage.space)) {
      const detail::Addressing address(storage);
      for (index_t i = begin; i < end; ++i)
        detail::fill_field(address, field.offset, field.type, field.count, field.initial, i);
    } else {
      backend::fill(storage, field, begin, end);
    }
  }
}

double getdata(const Storage& storage, index_t i, int k) {
  const ElementInfo element = find_element(storage, i, k);
  const int size = element_bytes(element.type);
  const std::byte* from = detail::Addressing(storage).address(i, element.offset, size);
  alignas(8) std::array<std::byte, 8> bytes{};
  if (host_accessible(storage.space)) {
    std::memcpy(bytes.data(), from, static_cast<std::size_t>(size));
  } else {
    backend::copy_bytes(bytes.data(), from, size, nullptr);
    synchronize();
  }
  if (element.type == ElementType::int32) {
    std::int32_t value = 0;
    std::memcpy(&value, bytes.data(), sizeof value);
    return value;
  }
  double value = 0;
  detail::convert_element(reinterpret_cast<std::byte*>(&value), ElementType::float64, bytes.data(), element.type);
  return value;
}

void putdata(const Storage& storage, index_t i, int k, double value) {
  const ElementInfo element = find_element(storage, i, k);
  const int size = element_bytes(element.type);
  std::byte* to = detail::Addressing(storage).address(i, element.offset, size);
  alignas(8) std::array<std::byte, 8> bytes{};
  if (element.type == ElementType::int32) {
    const auto integer = static_cast<std::int32_t>(value);
    std::memcpy(bytes.data(), &integer, sizeof integer);
  } else {
    detail::convert_element(bytes.data(), element.type, reinterpret_cast<const std::byte*>(&value),
                            ElementType::float64);
  }
  if (host_accessible(storage.space)) {
    std::memcpy(to, bytes.data(), static_cast<std::size_t>(size));
  } else {
    backend::copy_bytes(to, bytes.data(), size, nullptr);
    synchronize();
  }
}

}  // namespace physgen
