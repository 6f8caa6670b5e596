// Counts values of whole arrays that formats cannot hold, and keeps the counters of arrays.
#include <physgen/arrays/array_losses.h>
#include <physgen/arrays/chunked_transfer.h>
#include <physgen/device.h>
#include <physgen/memory/buffer.h>

#include <sstream>
#include <string>

#include "backend/memory.h"
#include "backend/objects.h"
#include "convert.h"
#include "copied_fields.h"
#include "host_convert.h"

namespace physgen {

namespace {

Losses read_losses(const Losses& counters, SpaceKind space) {
  if (space != SpaceKind::host) backend::synchronize_device();
  Losses read;
  copy_memory(reinterpret_cast<std::byte*>(&read), SpaceKind::host, reinterpret_cast<const std::byte*>(&counters),
              space, sizeof read);
  return read;
}

}  // namespace

Losses detail::losses_of_range(const UntypedArray& to, const UntypedArray& from, index_t begin, index_t end,
                               Stream stream) {
  if (begin == end || to.record_bytes == 0) return {};
  if (host_accessible(from.space)) {
    detail::wait_for_host_work(from.space, stream);
    return detail::count_on_host(to, from, begin, end);
  }
  if (detail::changed_by_own_functions(to, from) == nullptr) return backend::count_losses(to, from, begin, end, stream);
  Losses losses;
  ChunkedDownload chunks(from, begin, end, stream);
  while (chunks.next()) losses.add(detail::count_on_host(to, chunks.chunk(), 0, chunks.chunk().size), chunks.begin());
  return losses;
}

Losses losses_of_copy(const UntypedArray& to, const UntypedArray& from, Stream stream) {
  detail::require_fields(to, from);
  return detail::losses_of_range(to, from, 0, from.size, stream);
}

void throw_if_falsified(const Losses& losses, const UntypedArray& array) {
  if (losses.falsified() == 0) return;
  std::string field = "byte " + std::to_string(losses.first.offset), unit;
  for (const FieldInfo& candidate : array.fields) {
    const int at = losses.first.offset - candidate.offset, size = element_bytes(candidate.type);
    if (at >= 0 && at < candidate.count * size) {
      field = std::string(candidate.name) + (candidate.count > 1 ? "[" + std::to_string(at / size) + "]" : "");
      if (!candidate.unit.empty()) unit = " " + std::string(candidate.unit);
    }
  }
  std::ostringstream message;
  message << detail::describe(array) << ": its storage formats cannot hold " << losses.falsified() << " values ("
          << losses.out_of_range << " out of range, " << losses.not_a_number << " NaN or infinite, "
          << losses.not_a_rotation << " not rotations); the first is " << losses.first.value << unit << " in " << field
          << " of object " << losses.first.object
          << "; choose a format with a wider range, or state the range in the schema";
  throw Error(message.str());
}

Losses take_losses(Losses& counters, index_t objects, SpaceKind space) {
  const Losses taken = read_losses(counters, space);
  start_losses(counters, nullptr, objects, space);
  return taken;
}

void start_losses(Losses& counters, const Losses* old, index_t objects, SpaceKind space) {
  Losses fresh;
  if (old != nullptr) fresh = read_losses(*old, space);
  fresh.objects = objects;
  copy_memory(reinterpret_cast<std::byte*>(&counters), space, reinterpret_cast<const std::byte*>(&fresh),
              SpaceKind::host, sizeof fresh);
}

}  // namespace physgen
