// Fields of ghosts between devices: packed and unpacked by kernels, all fields and neighbours in one launch.
#include <physgen/cuda/check.h>
#include <physgen/device.h>
#include <physgen/distributed/cuda/halo_exchange.h>
#include <physgen/distributed/partition.h>
#include <physgen/memory/buffer.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "../../addressing.h"
#include "../../element_codec.h"

namespace physgen::cuda {

namespace {

/// A field of some objects, and the bytes of a message that hold it: element k of object o at (k * count + o) * size.
struct Piece {
  detail::Addressing array;
  const index_t* objects;  ///< their numbers; null: first, first + 1, ...
  index_t first, count;
  int offset, size, elements;
  std::byte* bytes;

  [[nodiscard]] __device__ std::byte* element(index_t o, int k) const {
    return array.address(objects != nullptr ? objects[o] : first + o, offset + k * size, size);
  }
};

constexpr int pieces_per_launch = 32;  // a kernel's parameters have 4096 bytes
struct Pieces {
  int count = 0;
  alignas(Piece) std::byte memory[pieces_per_launch * sizeof(Piece)];

  [[nodiscard]] __host__ __device__ Piece* at() { return reinterpret_cast<Piece*>(memory); }
  [[nodiscard]] __host__ __device__ const Piece* at() const { return reinterpret_cast<const Piece*>(memory); }
};
static_assert(sizeof(Pieces) < 4000);

enum class Way { pack, unpack, poison };

template <Way kWay>
__global__ void move_pieces(const __grid_constant__ Pieces pieces, const std::uint64_t bits) {
  const Piece& piece = pieces.at()[blockIdx.y];
  const index_t all = piece.count * piece.elements;
  for (index_t w = blockIdx.x * index_t{blockDim.x} + threadIdx.x; w < all; w += gridDim.x * index_t{blockDim.x}) {
    const index_t k = w / piece.count;
    std::byte* const element = piece.element(w - k * piece.count, static_cast<int>(k));
    if constexpr (kWay == Way::pack) detail::move_bits(piece.bytes + w * piece.size, element, piece.size);
    if constexpr (kWay == Way::unpack) detail::move_bits(element, piece.bytes + w * piece.size, piece.size);
    if constexpr (kWay == Way::poison) {
      detail::move_bits(element, reinterpret_cast<const std::byte*>(&bits), piece.size);
    }
  }
}

template <Way kWay>
void move(const std::vector<Piece>& pieces, Stream stream, std::uint64_t bits = 0) {
  constexpr int threads = 256;
  for (std::size_t from = 0; from < pieces.size(); from += pieces_per_launch) {
    Pieces some;
    some.count = static_cast<int>(std::min(pieces.size() - from, std::size_t{pieces_per_launch}));
    index_t most = 1;
    for (int p = 0; p < some.count; ++p) {
      const Piece& piece = pieces[from + static_cast<std::size_t>(p)];
      new (some.at() + p) Piece(piece);
      most = std::max(most, piece.count * piece.elements);
    }
    const auto wide = static_cast<unsigned>(std::min((most + threads - 1) / threads, index_t{1024}));
    move_pieces<kWay><<<dim3(wide, static_cast<unsigned>(some.count)), threads, 0, stream>>>(some, bits);
    check(cudaGetLastError(), "packing fields of ghosts");
  }
}

class DeviceExchange final : public HaloExchange {
 public:
  DeviceExchange(Partition& arrays, Transport& transport, Stream stream)
      : arrays_(arrays), transport_(transport), stream_(stream) {
    for (const DistributedArray& array : arrays.arrays()) {
      const bool has_objects = array.memory.bytes() > 0;
      if (!has_objects || array.memory.space == SpaceKind::cuda) continue;
      throw Error("array " + array.name + " lies in " + name(array.memory.space) +
                  " memory, and the executor runs on CUDA; give arrays of Cuda");
    }
  }

  void begin(std::span<const HaloFetch> fetches) override {
    const auto ranks = static_cast<std::size_t>(transport_.count());
    // Where each rank's message lies, then where each field does in it.
    std::vector<index_t> sent(ranks + 1, 0), received(ranks + 1, 0);
    each(fetches, [&](const HaloPlan::Peer& peer, const FieldInfo& info, const auto&) {
      const auto r = static_cast<std::size_t>(peer.rank);
      sent[r + 1] += bytes_of(info, peer.sent.count);
      received[r + 1] += bytes_of(info, peer.received.count);
    });
    for (std::size_t r = 0; r < ranks; ++r) {
      sent[r + 1] += sent[r];
      received[r + 1] += received[r];
    }
    reserve(sent_, sent.back());
    reserve(received_, received.back());
    std::vector<Message> messages;
    for (std::size_t r = 0; r < ranks; ++r) {
      const auto mine = static_cast<std::size_t>(sent[r + 1] - sent[r]);
      const auto others = static_cast<std::size_t>(received[r + 1] - received[r]);
      if (mine + others == 0) continue;
      messages.push_back(
          {static_cast<int>(r), {sent_.data() + sent[r], mine}, {received_.data() + received[r], others}});
    }
    std::vector<Piece> packed;
    unpacked_.clear();
    each(fetches, [&](const HaloPlan::Peer& peer, const FieldInfo& info, const Place& place) {
      const auto r = static_cast<std::size_t>(peer.rank);
      if (peer.sent.count > 0) packed.push_back(piece_of(place.array, info, place.lists.sent, sent_.data() + sent[r]));
      if (peer.received.count > 0) {
        unpacked_.push_back(piece_of(place.array, info, place.lists.received, received_.data() + received[r]));
      }
      sent[r] += bytes_of(info, peer.sent.count);
      received[r] += bytes_of(info, peer.received.count);
    });
    move<Way::pack>(packed, stream_);
    transport_.begin(messages);
  }

  void end() override {
    transport_.end();
    move<Way::unpack>(unpacked_, stream_);
  }

  void gather(std::span<const HaloField> fields, const Runs& computed) override {
    // Of each rank as many bytes, those of the rank that computes most.
    index_t stride = 0;
    for (int r = 0; r < computed.ranks(); ++r) {
      index_t bytes = 0;
      each_field(fields, [&](const UntypedArray&, const FieldInfo& info) {
        bytes += bytes_of(info, computed.end(r) - computed.begin(r));
      });
      stride = std::max(stride, bytes);
    }
    if (stride == 0) return;
    reserve(sent_, stride);
    reserve(received_, stride * computed.ranks());
    const auto pieces_of = [&](int rank, std::byte* bytes, std::vector<Piece>& pieces) {
      const index_t first = computed.begin(rank), count = computed.end(rank) - first;
      each_field(fields, [&](const UntypedArray& memory, const FieldInfo& info) {
        if (count == 0) return;
        pieces.push_back({detail::Addressing(memory), nullptr, first, count, info.offset, element_bytes(info.type),
                          info.count, bytes});
        bytes += bytes_of(info, count);
      });
    };
    std::vector<Piece> mine, others;
    pieces_of(transport_.rank(), sent_.data(), mine);
    for (int r = 0; r < computed.ranks(); ++r) {
      if (r != transport_.rank()) pieces_of(r, received_.data() + r * stride, others);
    }
    move<Way::pack>(mine, stream_);
    const auto bytes = static_cast<std::size_t>(stride);
    const std::vector<index_t> sizes(static_cast<std::size_t>(computed.ranks()), stride);
    transport_.gather({sent_.data(), bytes}, sizes, {received_.data(), bytes * sizes.size()});
    move<Way::unpack>(others, stream_);
  }

  void poison(const HaloField& field, HaloNeedBits fresh) override {
    const DistributedArray& array = arrays_.arrays()[static_cast<std::size_t>(field.array)];
    const FieldInfo& info = array.memory.fields[static_cast<std::size_t>(field.field)];
    if (!info.is_stored()) return;
    // A need stays as it is, and so do the ghosts that none of some has.
    const auto [found, is_new] = stale_.try_emplace({array.set, fresh});
    if (is_new) found->second = List(stale_ghosts(arrays_.sets()[static_cast<std::size_t>(array.set)], fresh));
    if (found->second.count == 0) return;
    move<Way::poison>({piece_of(detail::Addressing(array.memory), info, found->second, nullptr)}, stream_,
                      bits_of_no_value(info.type));
  }

 private:
  /// Objects as a device reads them.
  struct List {
    Buffer numbers;  ///< none of objects that follow each other
    index_t first = 0, count = 0;

    List() = default;
    explicit List(const ObjectRuns& objects) : count(objects.count) {
      if (count > 0) first = objects.runs.front().first;
      if (objects.runs.size() < 2) return;
      std::vector<index_t> all;
      for (const ObjectRuns::Run& run : objects.runs) {
        for (index_t i = 0; i < run.count; ++i) all.push_back(run.first + i);
      }
      const auto bytes = static_cast<index_t>(all.size() * sizeof(index_t));
      numbers = Buffer(SpaceKind::cuda, bytes, "numbers of objects that cross between ranks");
      copy_memory(numbers.data(), SpaceKind::cuda, reinterpret_cast<const std::byte*>(all.data()), SpaceKind::host,
                  bytes);
    }
  };
  struct Lists {
    List sent, received;
  };
  struct Place {
    detail::Addressing array;
    const Lists& lists;
  };
  [[nodiscard]] static Piece piece_of(const detail::Addressing& array, const FieldInfo& info, const List& list,
                                      std::byte* bytes) {
    return {array,       list.numbers.bytes() > 0 ? reinterpret_cast<const index_t*>(list.numbers.data()) : nullptr,
            list.first,  list.count,
            info.offset, element_bytes(info.type),
            info.count,  bytes};
  }
  /// Of the peers of a need. A round that is recorded finds them, since it was run before.
  [[nodiscard]] const std::vector<Lists>& lists_of(int set, int need) {
    const auto [found, is_new] = lists_.try_emplace({set, need});
    if (is_new) {
      const HaloNeed& of = arrays_.sets()[static_cast<std::size_t>(set)].needs[static_cast<std::size_t>(need)];
      for (const HaloPlan::Peer& peer : of.plan.peers) {
        found->second.push_back({List(peer.sent), List(peer.received)});
      }
    }
    return found->second;
  }

  template <class Use>
  void each_field(std::span<const HaloField> fields, const Use& use) const {
    for (const HaloField& field : fields) {
      const UntypedArray& memory = arrays_.arrays()[static_cast<std::size_t>(field.array)].memory;
      const FieldInfo& info = memory.fields[static_cast<std::size_t>(field.field)];
      if (info.is_stored()) use(memory, info);
    }
  }
  /// Calls use(peer, info, place) for each field and each rank that has objects of it; all ranks in the same order.
  template <class Use>
  void each(std::span<const HaloFetch> fetches, const Use& use) {
    for (const auto& [field, need] : fetches) {
      const DistributedArray& array = arrays_.arrays()[static_cast<std::size_t>(field.array)];
      const FieldInfo& info = array.memory.fields[static_cast<std::size_t>(field.field)];
      if (!info.is_stored()) continue;
      const std::vector<Lists>& lists = lists_of(array.set, need);
      const HaloNeed& of = arrays_.sets()[static_cast<std::size_t>(array.set)].needs[static_cast<std::size_t>(need)];
      for (std::size_t p = 0; p < lists.size(); ++p) {
        use(of.plan.peers[p], info, Place{detail::Addressing(array.memory), lists[p]});
      }
    }
  }
  /// In a message, where fields of elements of any size begin.
  [[nodiscard]] static index_t bytes_of(const FieldInfo& info, index_t objects) {
    constexpr index_t alignment = 16;
    return (objects * info.count * element_bytes(info.type) + alignment - 1) / alignment * alignment;
  }
  void reserve(Buffer& buffer, index_t bytes) {
    if (buffer.bytes() >= bytes) return;
    if (buffer.bytes() > 0) outgrown_.push_back(std::move(buffer));
    buffer = Buffer(SpaceKind::cuda, bytes + bytes / 2, "messages between ranks");
  }

  Partition& arrays_;
  Transport& transport_;
  Stream stream_;
  std::map<std::pair<int, int>, std::vector<Lists>> lists_;  ///< by set and need, of each peer
  std::map<std::pair<int, HaloNeedBits>, List> stale_;       ///< by set and the needs that are fresh
  Buffer sent_, received_;
  std::vector<Buffer> outgrown_;  ///< graphs and work under way may have them
  std::vector<Piece> unpacked_;   ///< of the exchange that is under way
};

}  // namespace

std::unique_ptr<HaloExchange> make_device_exchange(Partition& arrays, Transport& transport, Stream stream) {
  return std::make_unique<DeviceExchange>(arrays, transport, stream);
}

}  // namespace physgen::cuda
