// Initial values of objects, on the host and by the backend.
#include <physgen/arrays/initial_values.h>
#include <physgen/detail/count_losses.h>
#include <physgen/detail/launch.h>
#include <physgen/device.h>
#include <physgen/error.h>

#include <algorithm>
#include <sstream>

#include "backend/objects.h"
#include "describe.h"
#include "strided.h"

namespace physgen {

namespace {

/// @throw Error where the field would begin as infinite, or at the end of its range, in place of a stated value. (A
/// range without zero is no error: where the schema states no value, what new objects hold is not meant to be read.)
void require_initial_value(const UntypedArray& array, const FieldInfo& field) {
  if (field.rotation || field.initial == 0 || field.own != nullptr) return;
  const detail::FieldFormat format(field);
  alignas(8) std::byte stored[8] = {};
  detail::encode(stored, format, field.initial);
  Losses losses;
  detail::count_loss(losses, format.type, format.scale, field.initial, detail::decode<double>(stored, format), 0, 0);
  if (losses.falsified() == 0) return;
  std::ostringstream message;
  message
      << detail::describe(array) << ": the initial value " << field.initial << " of " << field.name
      << " is beyond the range of its storage format; choose a format with a wider range, or state another value in "
         "the schema, initial(...)";
  throw Error(message.str());
}

enum class Memory : std::uint8_t { zero, any };

template <class T>
void set_strided(detail::StridedElements elements, T value, index_t count) {
  for (index_t l = 0; l < count; ++l) *reinterpret_cast<T*>(elements.first + l * elements.stride) = value;
}

void set_strided(detail::StridedElements elements, std::uint64_t bits, int size, index_t count) {
  if (size == 8) return set_strided(elements, bits, count);
  if (size == 4) return set_strided(elements, static_cast<std::uint32_t>(bits), count);
  if (size == 2) return set_strided(elements, static_cast<std::uint16_t>(bits), count);
  set_strided(elements, static_cast<std::uint8_t>(bits), count);
}

/// In blocks that stay in the cache, and in each element by element.
void fill_on_host(const UntypedArray& array, const detail::Fill& field, index_t begin, index_t end, Memory memory) {
  constexpr index_t block = 1024;
  const detail::Addressing addresses(array);
  detail::for_each_index<block>(0, (end - begin + block - 1) / block, [&](index_t b) {
    const index_t last = std::min(begin + (b + 1) * block, end);
    for (index_t i = begin + b * block, count = 0; i < last; i += count) {
      count = std::min(last - i, detail::evenly_spaced(addresses, i));
      for (int k = 0; k < field.count; ++k) {
        const std::uint64_t bits = field.bits(k);
        if (memory == Memory::zero && bits == 0) continue;
        set_strided(detail::strided(addresses, i, field.offset + k * field.size, field.size), bits, field.size, count);
      }
    }
  });
}

void fill(const UntypedArray& array, index_t begin, index_t end, Memory memory) {
  if (begin == end) return;
  detail::wait_for_host_work(array.space);
  for (const FieldInfo& field : array.fields) {
    if (!field.is_stored()) continue;
    require_initial_value(array, field);
    const detail::Fill fill(field);
    if (memory == Memory::zero && fill.is_zero()) continue;
    if (host_accessible(array.space)) {
      fill_on_host(array, fill, begin, end, memory);
    } else {
      backend::fill(array, fill, begin, end);
    }
  }
}

}  // namespace

void initialize(const UntypedArray& array, index_t begin, index_t end) { fill(array, begin, end, Memory::zero); }

void reset(const UntypedArray& array, index_t begin, index_t end) { fill(array, begin, end, Memory::any); }

}  // namespace physgen
