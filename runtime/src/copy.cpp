// Copies between arrays without their types: who does which of them.
#include <physgen/arrays/array_losses.h>
#include <physgen/arrays/copy.h>
#include <physgen/device.h>

#include <algorithm>
#include <string>

#include "backend/transfer.h"
#include "convert.h"
#include "copied_fields.h"
#include "host_convert.h"
#include "plain_copy.h"

namespace physgen {

namespace {

using detail::describe;

bool overlap(const UntypedArray& a, const UntypedArray& b) {
  return a.bytes() > 0 && b.bytes() > 0 && a.base < b.base + b.bytes() && b.base < a.base + a.bytes();
}

bool has_no_memory(const UntypedArray& array) {
  return array.size > 0 && array.record_bytes > 0 && array.base == nullptr;
}

void require_two_arrays_of_one_type(const UntypedArray& to, const UntypedArray& from) {
  if (to.object != from.object) detail::refuse_copy(to, from, "the object types differ");
  if (has_no_memory(to) || has_no_memory(from)) detail::refuse_copy(to, from, "one of them has no memory (null)");
  if (overlap(to, from)) detail::refuse_copy(to, from, "they share memory; copy to an array of its own");
  detail::require_fields(to, from);
}

}  // namespace

index_t copy_range(const UntypedArray& to, const UntypedArray& from, index_t begin, index_t end, Stream stream) {
  require_two_arrays_of_one_type(to, from);
  if (begin < 0 || begin > end || end > std::min(to.size, from.size)) {
    throw Error("cannot copy objects " + std::to_string(begin) + " up to " + std::to_string(end) + " of " +
                describe(from) + " to " + describe(to));
  }
  if (begin == end || to.record_bytes == 0) return 0;
  const bool on_host = host_accessible(from.space) && host_accessible(to.space);
  if (on_host) {
    detail::wait_for_host_work(from.space, stream);
    detail::wait_for_host_work(to.space, stream);
  } else if (to.space == SpaceKind::host || from.space == SpaceKind::host) {
    detail::refuse_capture(stream, "a copy to or from host memory that is not pinned");
  }
  const FieldInfo* own = on_host ? nullptr : detail::changed_by_own_functions(to, from);
  if (own != nullptr && to.space == from.space) {
    detail::refuse_copy(to, from,
                        std::string(own->name) +
                            " is stored in a format of the program's own, whose functions are called on the host; copy "
                            "by way of a host array, or take format::Scaled");
  }
  if (checked_build && !detail::same_records(to, from))
    throw_if_falsified(detail::losses_of_range(to, from, begin, end, stream), to);
  if (detail::same_records(to, from) && detail::same_runs(to, from)) {
    // To the end of both arrays the last tile moves whole, padding included, which makes it one run with the others.
    const bool to_the_end = end == to.size && end == from.size && to.pitch == from.pitch;
    const bool whole_tiles = begin == 0 || to.pitch < to.padded;
    const index_t last = to_the_end && whole_tiles ? align_up(end, to.pitch) : end;
    return detail::copy_plain(to, begin, from, begin, last - begin, stream);
  }
  if (on_host) {
    detail::convert_on_host(to, 0, from, 0, begin, end);
    return (end - begin) * from.record_bytes;
  }
  return backend::convert(to, from, begin, end, stream);
}

void copy(const UntypedArray& to, const UntypedArray& from, Stream stream) {
  require_two_arrays_of_one_type(to, from);
  if (to.size != from.size) detail::refuse_copy(to, from, "resize the target, which comes first in copy(to, from)");
  copy_range(to, from, 0, from.size, stream);
}

}  // namespace physgen
