// Runs of bytes between arrays that store the same records.
#include "plain_copy.h"

#include <physgen/detail/changed_objects.h>
#include <physgen/detail/launch.h>

#include <algorithm>
#include <cstring>

#include "backend/memory.h"
#include "element_codec.h"

namespace physgen::detail {

namespace {

// Strips of equal length that lie at a constant distance on each side.
struct Strips {
  std::byte* to;
  index_t to_pitch;  // [bytes]
  const std::byte* from;
  index_t from_pitch;  // [bytes]
  index_t bytes;       // of one strip
  int count;
};

// On several threads where one would take long.
void copy_on_host(std::byte* to, const std::byte* from, index_t bytes) {
  constexpr index_t part = index_t{1} << 16;
  if (bytes <= part) {
    std::memcpy(to, from, static_cast<std::size_t>(bytes));
    return;
  }
  for_each_index<part / 64>(0, (bytes + part - 1) / part, [=](index_t p) {
    std::memcpy(to + p * part, from + p * part, static_cast<std::size_t>(std::min(part, bytes - p * part)));
  });
}

void copy_strips(const Strips& strips, bool on_host, Stream stream) {
  if (!on_host) {
    backend::copy_strips(strips.to, strips.to_pitch, strips.from, strips.from_pitch, strips.bytes, strips.count,
                         stream);
    return;
  }
  for (index_t k = 0; k < strips.count; ++k) {
    copy_on_host(strips.to + k * strips.to_pitch, strips.from + k * strips.from_pitch, strips.bytes);
  }
}

}  // namespace

bool same_records(const UntypedArray& a, const UntypedArray& b) {
  return a.record_bytes == b.record_bytes && same_formats(a, b) &&
         std::ranges::equal(a.fields, b.fields, {}, &FieldInfo::offset, &FieldInfo::offset);
}

bool same_runs(const UntypedArray& a, const UntypedArray& b) {
  return a.pitch == b.pitch || (a.pitch >= a.padded && b.pitch >= b.padded);
}

index_t copy_plain(const UntypedArray& to, index_t to_begin, const UntypedArray& from, index_t from_begin,
                   index_t count, Stream stream) {
  const bool on_host = host_accessible(to.space) && host_accessible(from.space);
  if (to.record_bytes == 0) return 0;
  index_t moved = 0;
  for (index_t done = 0, piece = 0; done < count; done += piece) {
    const index_t rest = count - done;
    const index_t to_i = to_begin + done, from_i = from_begin + done;
    const index_t to_lane = AnyPitch{to.pitch}.lane(to_i), from_lane = AnyPitch{from.pitch}.lane(from_i);
    if (to.pitch == from.pitch && to_lane == 0 && from_lane == 0 && rest >= to.pitch) {
      piece = rest / to.pitch * to.pitch;
      const index_t bytes = piece * to.record_bytes;
      copy_strips({to.address(to_i, 0, 0), bytes, from.address(from_i, 0, 0), bytes, bytes, 1}, on_host, stream);
      moved += bytes;
      continue;
    }
    piece = std::min({rest, to.pitch - to_lane, from.pitch - from_lane});
    for (const FieldInfo& field : to.fields) {
      const int size = element_bytes(field.type);
      if (size == 0) continue;
      copy_strips(
          {to.address(to_i, field.offset, size), law::channel_begin(size, to.pitch),
           from.address(from_i, field.offset, size), law::channel_begin(size, from.pitch), piece * size, field.count},
          on_host, stream);
      moved += piece * size * field.count;
    }
  }
  return moved;
}

}  // namespace physgen::detail
