// Initial values of objects, on the host and by the backend.
#include <physgen/arrays/initial_values.h>
#include <physgen/detail/count_losses.h>
#include <physgen/detail/launch.h>
#include <physgen/device.h>
#include <physgen/error.h>

#include <sstream>

#include "backend/objects.h"
#include "describe.h"

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

void fill(const UntypedArray& array, index_t begin, index_t end, Memory memory) {
  if (begin == end) return;
  detail::wait_for_host_work(array.space);
  for (const FieldInfo& field : array.fields) {
    if (!field.is_stored()) continue;
    require_initial_value(array, field);
    const detail::Fill fill(field);
    if (memory == Memory::zero && fill.is_zero()) continue;
    if (host_accessible(array.space)) {
      const detail::Addressing addresses(array);
      detail::for_each_index(begin, end, [&](index_t i) { fill.apply(addresses, i); });
    } else {
      backend::fill(array, fill, begin, end);
    }
  }
}

}  // namespace

void initialize(const UntypedArray& array, index_t begin, index_t end) { fill(array, begin, end, Memory::zero); }

void reset(const UntypedArray& array, index_t begin, index_t end) { fill(array, begin, end, Memory::any); }

}  // namespace physgen
