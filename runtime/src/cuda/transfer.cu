// Copies between host and device that convert. These rules say what travels, and who converts:
//   - Pinned memory travels as it is and is converted on the device, which takes a hundredth of the transfer's time.
//   - Pageable memory is copied to pinned memory by the processor in any case. The processor converts on the way
//     where that makes doubles floats: then fewer bytes travel. Else the host's form travels and the device converts:
//     to change the layout or to make 16-bit formats takes a processor longer than the bytes take to travel.
//   - The functions of formats of a program's own are called by the processor, also for pinned memory.
// tools/physbench/README.md, "Who converts", says which of them were measured. A copy goes in chunks: while
// one travels, the processor is at the next one.
#include <physgen/arrays/chunked_transfer.h>
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

// Chunks of an array in CUDA memory that pass through pinned memory in some form: the array's own, or the host's, which
// the device converts. On their way up they are filled by the host, on their way down it reads them.
struct Passage {
  bool up;
  UntypedArray device;
  Chunks chunks;
  UntypedArray chunk;                        // in pinned memory; take_piece() says which
  UntypedArray part;                         // the same in CUDA memory, where the device converts
  std::optional<cuda::PinnedRing> ring;      // none for no objects
  std::optional<cuda::StreamMemory> memory;  // of the part
  Stream stream;
  index_t at = -1;      // the chunk that is being filled or read
  index_t ordered = 0;  // chunks whose way down has been ordered

  Passage(bool up_, const UntypedArray& device_, const UntypedArray& form, bool device_converts, index_t begin,
          index_t end, Stream stream_)
      : up(up_),
        device(device_),
        chunks(form, begin, end),
        chunk(part_of(form, chunks.objects, SpaceKind::pinned)),
        part(chunk),
        stream(stream_) {
    detail::refuse_capture(stream, "a transfer in chunks");
    if (begin == end) return;
    ring.emplace(chunk.bytes());
    if (!device_converts) return;
    memory.emplace(part.bytes(), stream);
    part.space = SpaceKind::cuda;
    part.base = memory->data();
  }

  // The number of the object at the beginning of a chunk: what the device converts is in step with its tiles.
  [[nodiscard]] index_t beginning(index_t k) const { return memory ? chunks.aligned(k) : chunks.first(k); }
  void take_piece(index_t k) {
    chunk.base = ring->piece(k);
    chunk.size = chunks.last(k) - beginning(k);
  }

  // Orders the way of chunk k.
  void move(index_t k) {
    const index_t first = chunks.first(k), last = chunks.last(k), lead = first - beginning(k);
    take_piece(k);
    if (memory && !up) cuda::convert(part, beginning(k), device, 0, first, last, stream);
    const UntypedArray& in_cuda = memory ? part : device;
    const index_t there = memory ? lead : first;
    if (up) {
      detail::copy_plain(in_cuda, there, chunk, lead, last - first, stream);
    } else {
      detail::copy_plain(chunk, lead, in_cuda, there, last - first, stream);
    }
    ring->used(k, stream);
    if (memory && up) cuda::convert(device, 0, part, beginning(k), first, last, stream);
  }

  // Goes on to the next chunk. On the way up the one before is on its way when this returns, and this one may be
  // filled; on the way down this one has come, and those after it are on their way.
  bool next() {
    if (at >= chunks.count()) return false;
    if (up && at >= 0) move(at);
    ++at;
    for (; !up && ordered < std::min(chunks.count(), at + cuda::PinnedRing::pieces); ++ordered) move(ordered);
    if (at >= chunks.count()) return false;
    ring->wait(at);
    take_piece(at);
    // Padding of records travels, too, and must not be what another transfer left.
    const bool padded_records = detail::stored_bytes(device) < device.record_bytes;
    if (up && !memory && padded_records) detail::clear_on_host(chunk.base, chunk.size * chunk.record_bytes);
    return true;
  }
};

// Between pageable memory and the device; also pinned memory, where the processor converts.
index_t convert_pageable(const UntypedArray& to, const UntypedArray& from, index_t begin, index_t end, Stream stream) {
  const bool up = to.space == SpaceKind::cuda;
  const UntypedArray &host = up ? from : to, &device = up ? to : from;
  const bool on_host = processor_converts(host, device);
  const UntypedArray& form = on_host ? device : host;
  Passage way(up, device, form, !on_host, begin, end, stream);
  while (way.next()) {
    const index_t beginning = way.beginning(way.at), first = way.chunks.first(way.at), last = way.chunks.last(way.at);
    if (up) {
      detail::convert_on_host(way.chunk, beginning, host, 0, first, last);
    } else {
      detail::convert_on_host(host, 0, way.chunk, beginning, first, last);
    }
  }
  return (end - begin) * form.record_bytes;
}

const UntypedArray& checked_range(const UntypedArray& array, index_t begin, index_t end) {
  if (array.space == SpaceKind::cuda && begin >= 0 && begin <= end && end <= array.size) return array;
  throw Error("cannot transfer objects " + std::to_string(begin) + " up to " + std::to_string(end) + " of " +
              detail::describe(array) + " in chunks: they must be objects of an array in cuda memory");
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
  if (on_host || from.space == SpaceKind::host || to.space == SpaceKind::host)
    return convert_pageable(to, from, begin, end, stream);
  return convert_pinned(to, from, begin, end, stream);
}

struct ChunkedTransfer::State : Passage {
  using Passage::Passage;
};
ChunkedTransfer::ChunkedTransfer(bool up, const UntypedArray& array, index_t begin, index_t end, Stream stream)
    : state_(std::make_unique<State>(up, checked_range(array, begin, end), array, false, begin, end, stream)) {}
ChunkedTransfer::~ChunkedTransfer() = default;
const UntypedArray& ChunkedTransfer::chunk() const { return state_->chunk; }
index_t ChunkedTransfer::begin() const { return state_->beginning(state_->at); }
bool ChunkedTransfer::next() { return state_->next(); }

}  // namespace physgen
