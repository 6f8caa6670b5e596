// Copies between host and device that convert. What travels, and who converts:
//   - Pinned memory travels as it is and is converted on the device, which takes a hundredth of the transfer's time.
//   - Pageable memory must pass through pinned memory anyway, by the hands of the processor. It converts on the way
//     where that makes doubles floats: then fewer bytes travel. Else the host's form travels and the device converts:
//     to change the layout or to make 16-bit formats takes a processor longer than the bytes take to travel.
//   - The functions of formats of a program's own are called by the processor, also for pinned memory.
// What was measured of that, and what was not: tools/physbench/README.md, "Who converts". A copy goes in chunks: while
// one travels, the processor is at the next one.
#include <physgen/chunked_transfer.h>
#include <physgen/cuda/check.h>
#include <physgen/device.h>

#include <algorithm>
#include <optional>

#include "../backend/transfer.h"
#include "../chunks.h"
#include "../convert.h"
#include "../describe.h"
#include "../host_convert.h"
#include "../part.h"
#include "../plain_copy.h"
#include "parts/device_convert.h"
#include "parts/pinned_ring.h"
#include "parts/side_stream.h"
#include "parts/stream_memory.h"

namespace physgen {

namespace {

using detail::Chunks;
using detail::part_of;

// Pinned memory to the device, and back: the transfer of one chunk, then, or before it, the conversion.
index_t convert_pinned(const UntypedArray& to, const UntypedArray& from, index_t begin, index_t end, Stream stream) {
  const bool up = to.space == SpaceKind::cuda;
  const UntypedArray& travelling = up ? from : to;
  const Chunks chunks(travelling, begin, end, 4);
  // Two parts and a second stream: one part is converted while the other one travels.
  constexpr index_t parts = 2;
  UntypedArray part = part_of(travelling, chunks.objects, SpaceKind::cuda);
  const cuda::StreamMemory memory(parts * part.bytes(), stream);
  const cuda::SideStream side(stream);
  const auto part_for = [&](index_t k) {
    UntypedArray chunk = part;
    chunk.base = memory.data() + k % parts * part.bytes();
    return chunk;
  };
  const auto convert = [&](index_t k) {
    side.waits_for_main();
    if (up) {
      cuda::convert(to, 0, part_for(k), chunks.aligned(k), chunks.first(k), chunks.last(k), side.stream());
    } else {
      cuda::convert(part_for(k), chunks.aligned(k), from, 0, chunks.first(k), chunks.last(k), side.stream());
    }
    side.done(k);
  };
  const auto transfer = [&](index_t k) {
    const index_t first = chunks.first(k), in_part = first - chunks.aligned(k), count = chunks.last(k) - first;
    return up ? detail::copy_plain(part_for(k), in_part, from, first, count, stream)
              : detail::copy_plain(to, first, part_for(k), in_part, count, stream);
  };
  index_t moved = 0;
  if (!up) convert(0);
  for (index_t k = 0; k < chunks.count(); ++k) {
    if (up) {
      side.main_waits_for(k - parts);
      moved += transfer(k);
      convert(k);
    } else {
      if (k + 1 < chunks.count()) convert(k + 1);  // while chunk k travels; the transfer before it has left the part
      side.main_waits_for(k);
      moved += transfer(k);
    }
  }
  return moved;  // the end of the side stream makes the main one wait for it
}

// Whether the processor converts on the way to or from pageable memory.
bool processor_converts(const UntypedArray& host, const UntypedArray& device) {
  if (detail::changed_by_own_functions(host, device) != nullptr) return true;
  const auto plain = [](const UntypedArray& array) {
    return std::all_of(array.fields.begin(), array.fields.end(), [](const FieldInfo& field) {
      return !field.is_stored() || (element_bytes(field.type) >= 4 && !field.quaternion);
    });
  };
  return device.record_bytes < host.record_bytes && plain(host) && plain(device);
}

// One chunk of the host's form, pinned and on the device, and where the objects of chunk k lie in it.
struct Passage {
  Chunks chunks;
  UntypedArray pinned, part;
  cuda::PinnedRing ring;
  cuda::StreamMemory memory;

  Passage(const UntypedArray& host, index_t begin, index_t end, Stream stream)
      : chunks(host, begin, end),
        pinned(part_of(host, chunks.objects, SpaceKind::pinned)),
        part(pinned),
        ring(pinned.bytes()),
        memory(part.bytes(), stream) {
    part.space = SpaceKind::cuda;
    part.base = memory.data();
  }
  [[nodiscard]] index_t in_part(index_t k) const { return chunks.first(k) - chunks.aligned(k); }
  [[nodiscard]] index_t count(index_t k) const { return chunks.last(k) - chunks.first(k); }
  [[nodiscard]] const UntypedArray& piece(index_t k) {
    pinned.base = ring.piece(k);
    return pinned;
  }
};

// Pageable memory to the device.
index_t upload(const UntypedArray& to, const UntypedArray& from, index_t begin, index_t end, Stream stream) {
  if (processor_converts(from, to)) {
    ChunkedUpload chunks(to, begin, end, stream);
    while (chunks.next()) {
      const index_t first = chunks.begin();
      detail::convert_on_host(chunks.chunk(), first, from, 0, first, first + chunks.chunk().size);
    }
    return (end - begin) * to.record_bytes;
  }
  Passage way(from, begin, end, stream);
  for (index_t k = 0; k < way.chunks.count(); ++k) {
    const index_t first = way.chunks.first(k), last = way.chunks.last(k), at = way.chunks.aligned(k);
    way.ring.wait(k);
    detail::convert_on_host(way.piece(k), at, from, 0, first, last);
    detail::copy_plain(way.part, way.in_part(k), way.piece(k), way.in_part(k), way.count(k), stream);
    way.ring.used(k, stream);
    cuda::convert(to, 0, way.part, at, first, last, stream);
  }
  return (end - begin) * from.record_bytes;
}

// The device to pageable memory.
index_t download(const UntypedArray& to, const UntypedArray& from, index_t begin, index_t end, Stream stream) {
  if (processor_converts(to, from)) {
    ChunkedDownload chunks(from, begin, end, stream);
    while (chunks.next()) {
      const index_t first = chunks.begin();
      detail::convert_on_host(to, 0, chunks.chunk(), first, first, first + chunks.chunk().size);
    }
    return (end - begin) * from.record_bytes;
  }
  Passage way(to, begin, end, stream);
  const auto order = [&](index_t k) {
    cuda::convert(way.part, way.chunks.aligned(k), from, 0, way.chunks.first(k), way.chunks.last(k), stream);
    detail::copy_plain(way.piece(k), way.in_part(k), way.part, way.in_part(k), way.count(k), stream);
    way.ring.used(k, stream);
  };
  const auto take = [&](index_t k) {
    way.ring.wait(k);
    detail::convert_on_host(to, 0, way.piece(k), way.chunks.aligned(k), way.chunks.first(k), way.chunks.last(k));
  };
  constexpr index_t ahead = cuda::PinnedRing::pieces - 1;
  for (index_t k = 0; k < way.chunks.count() + ahead; ++k) {
    if (k < way.chunks.count()) order(k);
    if (k >= ahead) take(k - ahead);
  }
  return (end - begin) * to.record_bytes;
}

}  // namespace

index_t backend::convert(const UntypedArray& to, const UntypedArray& from, index_t begin, index_t end, Stream stream) {
  if (to.space == from.space) {
    cuda::convert(to, 0, from, 0, begin, end, stream);
    return (end - begin) * from.record_bytes;
  }
  detail::refuse_capture(stream, "a copy that converts between host and cuda memory");
  const bool on_host = detail::changed_by_own_functions(to, from) != nullptr;
  if (on_host) {
    detail::wait_for_host_work(from.space, stream);
    detail::wait_for_host_work(to.space, stream);
  }
  if (from.space == SpaceKind::host || (on_host && from.space == SpaceKind::pinned))
    return upload(to, from, begin, end, stream);
  if (to.space == SpaceKind::host || (on_host && to.space == SpaceKind::pinned))
    return download(to, from, begin, end, stream);
  return convert_pinned(to, from, begin, end, stream);
}

namespace {

const UntypedArray& checked_range(const UntypedArray& array, index_t begin, index_t end) {
  if (array.space == SpaceKind::cuda && begin >= 0 && begin <= end && end <= array.size) return array;
  throw Error("cannot transfer objects " + std::to_string(begin) + " up to " + std::to_string(end) + " of " +
              detail::describe(array) + " in chunks: they must be objects of an array in cuda memory");
}

}  // namespace

struct ChunkedUpload::State {
  UntypedArray to;
  Chunks chunks;
  UntypedArray chunk;
  std::optional<cuda::PinnedRing> ring;  // none for no objects
  Stream stream;
  bool padded_records;   // their padding travels, too, and must not be what another transfer left
  index_t filling = -1;  // the chunk that is being filled

  State(const UntypedArray& to_, index_t begin, index_t end, Stream stream_)
      : to(to_),
        chunks(to_, begin, end),
        chunk(part_of(to_, chunks.objects, SpaceKind::pinned)),
        stream(stream_),
        padded_records(detail::stored_bytes(to_) < to_.record_bytes) {
    detail::refuse_capture(stream, "a transfer in chunks");
    if (begin < end) ring.emplace(chunk.bytes());
  }
};

ChunkedUpload::ChunkedUpload(const UntypedArray& to, index_t begin, index_t end, Stream stream)
    : state_(std::make_unique<State>(checked_range(to, begin, end), begin, end, stream)) {}
ChunkedUpload::~ChunkedUpload() = default;

bool ChunkedUpload::next() {
  State& s = *state_;
  if (s.filling >= s.chunks.count()) return false;
  if (s.filling >= 0) {
    detail::copy_plain(s.to, begin(), s.chunk, 0, s.chunk.size, s.stream);
    s.ring->used(s.filling, s.stream);
  }
  if (++s.filling >= s.chunks.count()) return false;
  s.ring->wait(s.filling);
  s.chunk.base = s.ring->piece(s.filling);
  s.chunk.size = s.chunks.last(s.filling) - s.chunks.first(s.filling);
  if (s.padded_records) detail::clear_on_host(s.chunk.base, s.chunk.size * s.chunk.record_bytes);
  return true;
}
const UntypedArray& ChunkedUpload::chunk() const { return state_->chunk; }
index_t ChunkedUpload::begin() const { return state_->chunks.first(state_->filling); }

struct ChunkedDownload::State {
  UntypedArray from;
  Chunks chunks;
  UntypedArray chunk;
  std::optional<cuda::PinnedRing> ring;  // none for no objects
  Stream stream;
  index_t reading = -1;  // the chunk that is being read
  index_t ordered = 0;   // chunks whose transfer has been ordered

  State(const UntypedArray& from_, index_t begin, index_t end, Stream stream_)
      : from(from_),
        chunks(from_, begin, end),
        chunk(part_of(from_, chunks.objects, SpaceKind::pinned)),
        stream(stream_) {
    detail::refuse_capture(stream, "a transfer in chunks");
    if (begin < end) ring.emplace(chunk.bytes());
  }

  void place(index_t k) {
    chunk.base = ring->piece(k);
    chunk.size = chunks.last(k) - chunks.first(k);
  }
};

ChunkedDownload::ChunkedDownload(const UntypedArray& from, index_t begin, index_t end, Stream stream)
    : state_(std::make_unique<State>(checked_range(from, begin, end), begin, end, stream)) {}
ChunkedDownload::~ChunkedDownload() = default;

bool ChunkedDownload::next() {
  State& s = *state_;
  if (s.reading >= s.chunks.count()) return false;
  ++s.reading;
  for (; s.ordered < std::min(s.chunks.count(), s.reading + cuda::PinnedRing::pieces); ++s.ordered) {
    s.place(s.ordered);
    detail::copy_plain(s.chunk, 0, s.from, s.chunks.first(s.ordered), s.chunk.size, s.stream);
    s.ring->used(s.ordered, s.stream);
  }
  if (s.reading >= s.chunks.count()) return false;
  s.place(s.reading);
  s.ring->wait(s.reading);
  return true;
}
const UntypedArray& ChunkedDownload::chunk() const { return state_->chunk; }
index_t ChunkedDownload::begin() const { return state_->chunks.first(state_->reading); }

}  // namespace physgen
