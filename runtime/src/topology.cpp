// Changes of topology over arrays without their types: objects picked by number as plain bytes, and indices renumbered.
#include "backend/topology.h"

#include <physgen/detail/host_loop.h>
#include <physgen/error.h>
#include <physgen/topology.h>

#include <algorithm>
#include <limits>

#include "backend/memory.h"
#include "describe.h"
#include "first_where.h"
#include "index_field.h"

namespace physgen {

namespace {

using detail::Addressing;
using detail::describe;
using detail::Picked;

void pick_on_host(const UntypedArray& to, index_t begin, const UntypedArray& from, const Picked& picked,
                  index_t count) {
  const Addressing to_address(to);
  const Addressing from_address(from);
  const bool whole_records = to_address.records() && from_address.records();
  // Blocks of objects keep what is written in the cache while field after field is moved.
  constexpr index_t block = 1024;
  const index_t blocks = (count + block - 1) / block;
  detail::for_each_index<block>(0, blocks, [&](index_t b) {
    const index_t first = b * block;
    const index_t last = std::min(first + block, count);
    if (whole_records) {
      const auto bytes = static_cast<std::size_t>(to.record_bytes);
      for (index_t i = first; i < last; ++i) {
        std::memcpy(to_address.record(begin + i), from_address.record(picked[i]), bytes);
      }
      return;
    }
    for (const FieldInfo& field : to.fields) {
      if (!field.is_stored()) continue;
      const detail::Elements elements(field);
      for (int k = 0; k < elements.count; ++k) {
        const int offset = elements.offset + k * elements.bytes;
        for (index_t i = first; i < last; ++i) {
          detail::move_bits(to_address.address(begin + i, offset, elements.bytes),
                            from_address.address(picked[i], offset, elements.bytes), elements.bytes);
        }
      }
    }
  });
}

// Names the index of object i that has no new number.
[[noreturn]] void refuse_index(const UntypedArray& array, const FieldInfo& field, index_t i,
                               std::span<const index_t> new_number) {
  const detail::NewNumbers numbers{new_number.data(), static_cast<index_t>(new_number.size())};
  int k = 0;
  std::int32_t index = 0;
  constexpr int size = sizeof index;
  do {
    copy_memory(reinterpret_cast<std::byte*>(&index), SpaceKind::host, array.address(i, field.offset + k * size, size),
                array.space, size);
  } while (numbers.has(index) && ++k < field.count);
  std::string why = "there are new numbers for " + std::to_string(numbers.count) + " objects only";
  if (index >= 0 && index < numbers.count) {
    const index_t number = numbers.numbers[index];
    why = number < 0 ? "that object is gone; erase or change what refers to it first"
                     : "its new number " + std::to_string(number) + " is more than an index can hold";
  }
  throw Error(describe(array) + ": cannot renumber " + std::string(field.name) + ": object " + std::to_string(i) +
              " has the index " + std::to_string(index) + " as element " + std::to_string(k) + " of " +
              std::to_string(field.count) + ": " + why);
}

}  // namespace

namespace detail {

std::string names(std::span<const UntypedArray> arrays) {
  std::string all;
  for (const UntypedArray& array : arrays) all += (all.empty() ? "" : ", ") + describe(array);
  return all;
}

index_t common_size(std::span<const UntypedArray> arrays) {
  for (const UntypedArray& array : arrays) {
    if (array.size != arrays.front().size) {
      throw Error(names(arrays) + ": arrays of one element set have the same size");
    }
  }
  return arrays.front().size;
}

index_t grown_size(std::span<const UntypedArray> arrays, index_t count) {
  const index_t size = arrays.front().size;
  if (count < 0 || count > std::numeric_limits<index_t>::max() - size) {
    throw Error(names(arrays) + ": cannot append " + std::to_string(count) + " objects");
  }
  return size + count;
}

void wait_for(std::span<const UntypedArray> arrays) {
  const auto may_be_worked_on = [](const UntypedArray& array) {
    return device_accessible(array.space) && array.size > 0;
  };
  if (std::any_of(arrays.begin(), arrays.end(), may_be_worked_on)) synchronize();
}

Numbers::Numbers(std::span<const index_t> numbers, std::span<const UntypedArray> arrays) : on_host(numbers) {
  const auto on_cuda = [](const UntypedArray& array) { return array.space == SpaceKind::cuda; };
  if (numbers.empty() || std::none_of(arrays.begin(), arrays.end(), on_cuda)) return;
  const auto bytes = static_cast<index_t>(numbers.size_bytes());
  on_device = Buffer(SpaceKind::cuda, bytes, "a list of " + std::to_string(numbers.size()) + " object numbers");
  backend::copy_bytes(on_device.data(), reinterpret_cast<const std::byte*>(numbers.data()), bytes, nullptr);
}

const index_t* Numbers::in(SpaceKind space) const {
  return space == SpaceKind::cuda ? reinterpret_cast<const index_t*>(on_device.data()) : on_host.data();
}

void pick(const UntypedArray& to, index_t begin, const UntypedArray& from, const Numbers* order) {
  const index_t count = order != nullptr ? static_cast<index_t>(order->on_host.size()) : from.size;
  if (count == 0 || to.record_bytes == 0) return;
  const Picked picked{order != nullptr ? order->in(to.space) : nullptr};
  if (to.space == SpaceKind::cuda) return backend::pick(to, begin, from, picked, count, nullptr);
  pick_on_host(to, begin, from, picked, count);
}

}  // namespace detail

void renumber(const UntypedArray& array, std::string_view field_name, std::span<const index_t> new_number) {
  const FieldInfo& field = detail::find_index_field(array, field_name);
  if (array.size == 0) return;
  detail::wait_for(std::span(&array, 1));
  const bool on_host = host_accessible(array.space);
  const detail::Numbers uploaded(new_number, std::span(&array, 1));
  const detail::Renumbering renumbering{detail::Indices(array, field),
                                        {uploaded.in(array.space), static_cast<index_t>(new_number.size())}};
  const index_t first = on_host
                            ? detail::first_where(array.size, [&](index_t i) { return !renumbering.can_renumber(i); })
                            : backend::first_not_renumbered(renumbering, array.size);
  if (first < array.size) refuse_index(array, field, first, new_number);
  if (on_host) {
    detail::host_loop(array.size, renumbering);
  } else {
    backend::renumber(renumbering, array.size);
  }
}

}  // namespace physgen
