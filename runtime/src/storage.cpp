// Copies between arrays and initial values, over arrays without their types.
#include <physgen/chunked_transfer.h>
#include <physgen/copy_fields.h>
#include <physgen/error.h>
#include <physgen/untyped_array.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "backend.h"
#include "convert.h"
#include "describe.h"
#include "host_convert.h"
#include "plain_copy.h"

namespace physgen {

namespace {

using detail::describe;

// Whether all that `to` stores is there, and nothing is lost that `to` was not told to leave out.
void require_fields(const UntypedArray& to, const UntypedArray& from) {
  const auto refuse = [&](int f, const std::string& why) {
    const std::string field(to.fields[static_cast<std::size_t>(f)].name);
    throw Error("cannot copy " + describe(from) + " to " + describe(to) + ": " + field + why);
  };
  if (const int f = detail::first_not_given(to.fields, from.fields); f >= 0) {
    refuse(f,
           " is stored in the array that is copied to, and nothing is stored of it (format::Nothing or Pruned) in "
           "the one that is copied from; prune it in both, or in none");
  }
  if (const int f = detail::first_not_taken(to.fields, from.fields); f >= 0) {
    refuse(f,
           " would be lost: the array that is copied to stores nothing of it (format::Nothing); give it the format "
           "Pruned<scene, array, field> there, which says that this is meant");
  }
}

bool overlap(const UntypedArray& a, const UntypedArray& b) {
  return a.bytes() > 0 && b.bytes() > 0 && a.base < b.base + b.bytes() && b.base < a.base + a.bytes();
}

bool has_no_memory(const UntypedArray& array) {
  return array.size > 0 && array.record_bytes > 0 && array.base == nullptr;
}

void require_two_arrays_of_one_type(const UntypedArray& to, const UntypedArray& from) {
  std::string why;
  if (to.object != from.object) {
    why = "the object types differ";
  } else if (has_no_memory(to) || has_no_memory(from)) {
    why = "one of them has no memory (null)";
  } else if (overlap(to, from)) {
    why = "they share memory; copy to an array of its own";
  }
  if (!why.empty()) throw Error("cannot copy " + describe(from) + " to " + describe(to) + ": " + why);
  require_fields(to, from);
}

Losses count_losses(const UntypedArray& to, const UntypedArray& from, index_t begin, index_t end, Stream stream) {
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
    throw Error("cannot copy " + describe(from) + " to " + describe(to) + ": " + std::string(own->name) +
                " is stored in a format of the program's own, whose functions are called on the host; copy by way of a "
                "host array, or take format::Scaled");
  }
  if (checked_build && !detail::same_records(to, from))
    throw_if_falsified(count_losses(to, from, begin, end, stream), to);
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

void detail::wait_for_host_work(SpaceKind space, Stream stream) {
  if (space == SpaceKind::pinned) synchronize(stream);
}

void copy_first(const UntypedArray& to, const UntypedArray& from, index_t count, Stream stream) {
  copy_range(to, from, 0, count, stream);
}

void copy(const UntypedArray& to, const UntypedArray& from, Stream stream) {
  require_two_arrays_of_one_type(to, from);
  if (to.size != from.size) {
    throw Error("cannot copy " + describe(from) + " to " + describe(to) + ": resize the target first");
  }
  copy_first(to, from, from.size, stream);
}

Losses losses_of_copy(const UntypedArray& to, const UntypedArray& from, Stream stream) {
  require_fields(to, from);
  return count_losses(to, from, 0, from.size, stream);
}

void throw_if_falsified(const Losses& losses, const UntypedArray& array) {
  if (losses.falsified() == 0) return;
  std::string field = "byte " + std::to_string(losses.first.offset);
  for (const FieldInfo& candidate : array.fields) {
    const int at = losses.first.offset - candidate.offset, size = element_bytes(candidate.type);
    if (at >= 0 && at < candidate.count * size) {
      field = std::string(candidate.name) + (candidate.count > 1 ? "[" + std::to_string(at / size) + "]" : "");
    }
  }
  std::ostringstream message;
  message << describe(array) << ": its storage formats cannot hold " << losses.falsified() << " values ("
          << losses.out_of_range << " out of range, " << losses.not_a_number << " NaN or infinite, "
          << losses.not_a_rotation << " not rotations); the first is " << losses.first.value << " in " << field
          << " of object " << losses.first.object
          << "; choose a format with a wider range, or state the range in the schema";
  throw Error(message.str());
}

namespace {

Losses read_losses(const Losses& counters, SpaceKind space) {
  if (space != SpaceKind::host) backend::synchronize_device();
  Losses read;
  if (host_accessible(space)) {
    read = counters;
  } else {
    backend::copy_bytes(reinterpret_cast<std::byte*>(&read), reinterpret_cast<const std::byte*>(&counters), sizeof read,
                        nullptr);
    synchronize();
  }
  return read;
}

void write_losses(Losses& counters, const Losses& written, SpaceKind space) {
  if (host_accessible(space)) {
    counters = written;
  } else {
    backend::copy_bytes(reinterpret_cast<std::byte*>(&counters), reinterpret_cast<const std::byte*>(&written),
                        sizeof written, nullptr);
    synchronize();
  }
}

}  // namespace

Losses take_losses(Losses& counters, index_t objects, SpaceKind space) {
  const Losses taken = read_losses(counters, space);
  start_losses(counters, nullptr, objects, space);
  return taken;
}

void start_losses(Losses& counters, const Losses* old, index_t objects, SpaceKind space) {
  Losses fresh;
  if (old != nullptr) fresh = read_losses(*old, space);
  fresh.objects = objects;
  write_losses(counters, fresh, space);
}

void initialize(const UntypedArray& array, index_t begin, index_t end) {
  if (begin == end) return;
  detail::wait_for_host_work(array.space);
  for (const FieldInfo& field : array.fields) {
    if (!field.is_stored()) continue;
    const detail::Fill fill(field);
    if (fill.is_zero()) continue;
    if (host_accessible(array.space)) {
      const detail::Addressing addresses(array);
#pragma omp parallel for schedule(static) if (end - begin > 8192)
      for (index_t i = begin; i < end; ++i) fill.run(addresses, i);
    } else {
      backend::fill(array, fill, begin, end);
    }
  }
}

}  // namespace physgen
