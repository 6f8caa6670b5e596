// Copies between host and device that convert. What travels, and who converts:
//   - Pinned memory travels as it is and is converted on the device, which takes a hundredth of the transfer's time.
//   - Pageable memory must pass through pinned memory anyway, by the hands of the processor, which converts on the way
//     if the form on the device is the smaller one: then fewer bytes travel. If it is the larger one, the host's form
//     travels, and the device converts.
// A copy goes in chunks: while one travels, the processor is at the next one.
#include <physgen/chunked_transfer.h>
#include <physgen/cuda/check.h>

#include <algorithm>

#include "../backend.h"
#include "../describe.h"
#include "../host_convert.h"
#include "../part.h"
#include "../plain_copy.h"
#include "device_convert.h"
#include "pinned_ring.h"
#include "side_stream.h"
#include "stream_memory.h"

namespace physgen {

namespace {

using detail::part_of;

// The chunks of a range of objects, each from a multiple of the chunk's size on, but for the first.
struct Chunks {
  index_t begin, end, objects;

  /// @param times larger than usual
  Chunks(const Storage& array, index_t begin_, index_t end_, index_t times = 1)
      : begin(begin_),
        end(end_),
        objects(std::min(detail::chunk_objects(array) * times, align_up(end_ - begin_ + 1, index_t{1024}))) {}
  [[nodiscard]] index_t first(index_t k) const { return k == 0 ? begin : (begin / objects + k) * objects; }
  [[nodiscard]] index_t last(index_t k) const { return std::min(end, (begin / objects + k + 1) * objects); }
  [[nodiscard]] index_t count() const { return begin == end ? 0 : (end - 1) / objects - begin / objects + 1; }
  /// The multiple of 32 at or before the beginning of chunk k: where a part for it begins.
  [[nodiscard]] index_t aligned(index_t k) const { return first(k) / padding_objects * padding_objects; }
};

// Pinned memory to the device, and back: the transfer of one chunk, then, or before it, the conversion.
index_t convert_pinned(const Storage& to, const Storage& from, index_t begin, index_t end, Stream stream) {
  const bool up = to.space == SpaceKind::cuda;
  const Storage& travelling = up ? from : to;
  const Chunks chunks(travelling, begin, end, 4);
  // Two parts and a second stream: one part is converted while the other one travels.
  constexpr index_t parts = 2;
  Storage part = part_of(travelling, chunks.objects + padding_objects, SpaceKind::cuda);
  const cuda::StreamMemory memory(parts * part.bytes(), stream);
  const cuda::SideStream side(stream);
  const auto part_for = [&](index_t k) {
    Storage chunk = part;
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

// Pageable memory to the device.
index_t upload(const Storage& to, const Storage& from, index_t begin, index_t end, Stream stream) {
  if (to.record_bytes <= from.record_bytes) {
    ChunkedUpload chunks(to, begin, end, stream);
    while (chunks.next()) {
      const index_t first = chunks.begin();
      detail::convert_on_host(chunks.chunk(), first, from, 0, first, first + chunks.chunk().size);
    }
    return (end - begin) * to.record_bytes;
  }
  const Chunks chunks(from, begin, end);
  Storage pinned = part_of(from, chunks.objects + padding_objects, SpaceKind::pinned);
  Storage part = pinned;
  part.space = SpaceKind::cuda;
  cuda::PinnedRing ring(pinned.bytes());
  const cuda::StreamMemory memory(part.bytes(), stream);
  part.base = memory.data();
  for (index_t k = 0; k < chunks.count(); ++k) {
    const index_t first = chunks.first(k), last = chunks.last(k), at = chunks.aligned(k);
    pinned.base = ring.piece(k);
    ring.wait(k);
    detail::convert_on_host(pinned, at, from, 0, first, last);
    detail::copy_plain(part, first - at, pinned, first - at, last - first, stream);
    ring.used(k, stream);
    cuda::convert(to, 0, part, at, first, last, stream);
  }
  return (end - begin) * from.record_bytes;
}

// The device to pageable memory.
index_t download(const Storage& to, const Storage& from, index_t begin, index_t end, Stream stream) {
  if (from.record_bytes <= to.record_bytes) {
    ChunkedDownload chunks(from, begin, end, stream);
    while (chunks.next()) {
      const index_t first = chunks.begin();
      detail::convert_on_host(to, 0, chunks.chunk(), first, first, first + chunks.chunk().size);
    }
    return (end - begin) * from.record_bytes;
  }
  // Converted on the device as a whole, since the form that travels is the smaller one.
  const index_t at = begin / padding_objects * padding_objects;
  Storage part = part_of(to, end - at, SpaceKind::cuda);
  const cuda::StreamMemory memory(part.bytes(), stream);
  part.base = memory.data();
  cuda::convert(part, at, from, 0, begin, end, stream);
  ChunkedDownload chunks(part, begin - at, end - at, stream);
  while (chunks.next()) {
    const index_t first = at + chunks.begin();
    detail::convert_on_host(to, 0, chunks.chunk(), first, first, first + chunks.chunk().size);
  }
  return (end - begin) * to.record_bytes;
}

}  // namespace

index_t backend::convert(const Storage& to, const Storage& from, index_t begin, index_t end, Stream stream) {
  if (to.space == from.space) {
    cuda::convert(to, 0, from, 0, begin, end, stream);
    return (end - begin) * from.record_bytes;
  }
  if (from.space == SpaceKind::host) return upload(to, from, begin, end, stream);
  if (to.space == SpaceKind::host) return download(to, from, begin, end, stream);
  return convert_pinned(to, from, begin, end, stream);
}

namespace {

const Storage& checked_range(const Storage& array, index_t begin, index_t end) {
  if (array.space == SpaceKind::cuda && begin >= 0 && begin <= end && end <= array.size) return array;
  throw Error("cannot transfer objects " + std::to_string(begin) + " up to " + std::to_string(end) + " of " +
              detail::describe(array) + " in chunks: they must be objects of an array in cuda memory");
}

}  // namespace

struct ChunkedUpload::State {
  Storage to;
  Chunks chunks;
  Storage chunk;
  cuda::PinnedRing ring;
  Stream stream;
  index_t filling = -1;  // the chunk that is being filled

  State(const Storage& to_, index_t begin, index_t end, Stream stream_)
      : to(to_),
        chunks(to_, begin, end),
        chunk(part_of(to_, chunks.objects, SpaceKind::pinned)),
        ring(chunk.bytes()),
        stream(stream_) {}
};

ChunkedUpload::ChunkedUpload(const Storage& to, index_t begin, index_t end, Stream stream)
    : state_(std::make_unique<State>(checked_range(to, begin, end), begin, end, stream)) {}
ChunkedUpload::~ChunkedUpload() = default;

bool ChunkedUpload::next() {
  State& s = *state_;
  if (s.filling >= s.chunks.count()) return false;
  if (s.filling >= 0) {
    detail::copy_plain(s.to, begin(), s.chunk, 0, s.chunk.size, s.stream);
    s.ring.used(s.filling, s.stream);
  }
  if (++s.filling >= s.chunks.count()) return false;
  s.ring.wait(s.filling);
  s.chunk.base = s.ring.piece(s.filling);
  s.chunk.size = s.chunks.last(s.filling) - s.chunks.first(s.filling);
  return true;
}
const Storage& ChunkedUpload::chunk() const { return state_->chunk; }
index_t ChunkedUpload::begin() const { return state_->chunks.first(state_->filling); }

struct ChunkedDownload::State {
  Storage from;
  Chunks chunks;
  Storage chunk;
  cuda::PinnedRing ring;
  Stream stream;
  index_t reading = -1;  // the chunk that is being read
  index_t ordered = 0;   // chunks whose transfer has been ordered

  State(const Storage& from_, index_t begin, index_t end, Stream stream_)
      : from(from_),
        chunks(from_, begin, end),
        chunk(part_of(from_, chunks.objects, SpaceKind::pinned)),
        ring(chunk.bytes()),
        stream(stream_) {}

  void place(index_t k) {
    chunk.base = ring.piece(k);
    chunk.size = chunks.last(k) - chunks.first(k);
  }
};

ChunkedDownload::ChunkedDownload(const Storage& from, index_t begin, index_t end, Stream stream)
    : state_(std::make_unique<State>(checked_range(from, begin, end), begin, end, stream)) {}
ChunkedDownload::~ChunkedDownload() = default;

bool ChunkedDownload::next() {
  State& s = *state_;
  if (s.reading >= s.chunks.count()) return false;
  ++s.reading;
  for (; s.ordered < std::min(s.chunks.count(), s.reading + cuda::PinnedRing::pieces); ++s.ordered) {
    s.place(s.ordered);
    detail::copy_plain(s.chunk, 0, s.from, s.chunks.first(s.ordered), s.chunk.size, s.stream);
    s.ring.used(s.ordered, s.stream);
  }
  if (s.reading >= s.chunks.count()) return false;
  s.place(s.reading);
  s.ring.wait(s.reading);
  return true;
}
const Storage& ChunkedDownload::chunk() const { return state_->chunk; }
index_t ChunkedDownload::begin() const { return state_->chunks.first(state_->reading); }

}  // namespace physgen
