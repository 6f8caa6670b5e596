// Exchanges between arrays that the host reaches.
#include <physgen/distributed/halo_exchange.h>
#include <physgen/distributed/partition.h>

#include <cstring>
#include <vector>

#include "move_field.h"

namespace physgen {

namespace {

class HostExchange final : public HaloExchange {
 public:
  explicit HostExchange(Partition& arrays)
      : arrays_(arrays), sizes_(static_cast<std::size_t>(arrays.ranks().count())) {}

  void begin(std::span<const HaloFetch> fetches) override {
    fetches_.assign(fetches.begin(), fetches.end());
    // The bytes of each rank's message; then where its next field lies.
    sizes_.assign(sizes_.size(), {});
    each([&](const HaloPlan::Peer& peer, const UntypedArray&, const FieldInfo& info) {
      Places& of_rank = sizes_[static_cast<std::size_t>(peer.rank)];
      of_rank.sent += bytes_of(info, peer.sent.count);
      of_rank.received += bytes_of(info, peer.received.count);
    });
    Places all;
    for (const Places& one : sizes_) all.sent += one.sent, all.received += one.received;
    if (sent_.size() < all.sent) sent_.resize(all.sent);
    if (received_.size() < all.received) received_.resize(all.received);
    std::vector<Message> messages;
    Places at;
    for (std::size_t r = 0; r < sizes_.size(); ++r) {
      const Places size = sizes_[r];
      sizes_[r] = at;
      if (size.sent + size.received == 0) continue;
      messages.push_back(
          {static_cast<int>(r), {sent_.data() + at.sent, size.sent}, {received_.data() + at.received, size.received}});
      at = {at.sent + size.sent, at.received + size.received};
    }
    each([&](const HaloPlan::Peer& peer, const UntypedArray& memory, const FieldInfo& info) {
      std::size_t& place = sizes_[static_cast<std::size_t>(peer.rank)].sent;
      detail::pack(memory, info, peer.sent, sent_.data() + place);
      place += bytes_of(info, peer.sent.count);
    });
    arrays_.transport().begin(messages);
  }

  void end() override {
    arrays_.transport().end();
    each([&](const HaloPlan::Peer& peer, const UntypedArray& memory, const FieldInfo& info) {
      std::size_t& place = sizes_[static_cast<std::size_t>(peer.rank)].received;
      detail::unpack(memory, info, peer.received, received_.data() + place);
      place += bytes_of(info, peer.received.count);
    });
    fetches_.clear();
  }

  void gather(std::span<const HaloField> fields, const Runs& computed) override {
    index_t bytes_of_object = 0;
    for (const HaloField& field : fields) {
      bytes_of_object += static_cast<index_t>(bytes_of(info_of(field), 1));
    }
    std::vector<index_t> sizes;
    std::vector<ObjectRuns> objects(static_cast<std::size_t>(computed.ranks()));
    for (int r = 0; r < computed.ranks(); ++r) {
      const index_t count = computed.end(r) - computed.begin(r);
      sizes.push_back(count * bytes_of_object);
      if (count > 0) objects[static_cast<std::size_t>(r)] = {{{computed.begin(r), count}}, count};
    }
    const auto rank = static_cast<std::size_t>(arrays_.ranks().rank());
    std::vector<std::byte> given(static_cast<std::size_t>(sizes[rank])),
        all(static_cast<std::size_t>(computed.size() * bytes_of_object));
    std::byte* to = given.data();
    for (const HaloField& field : fields) to = detail::pack(array_of(field).memory, info_of(field), objects[rank], to);
    arrays_.transport().gather(given, sizes, all);
    const std::byte* from = all.data();
    for (const ObjectRuns& of_rank : objects) {
      for (const HaloField& field : fields) {
        from = detail::unpack(array_of(field).memory, info_of(field), of_rank, from);
      }
    }
  }

  void poison(const HaloField& field, HaloNeedBits fresh) override {
    const std::uint64_t bits = bits_of_no_value(info_of(field).type);
    const auto size = static_cast<std::size_t>(element_bytes(info_of(field).type));
    detail::for_each_piece(array_of(field).memory, info_of(field), stale_ghosts(set_of(field), fresh), index_t{0},
                           [&](std::byte* at, index_t /*place*/, std::size_t bytes) {
                             for (std::size_t b = 0; b < bytes; b += size) std::memcpy(at + b, &bits, size);
                           });
  }

 private:
  struct Places {
    std::size_t sent = 0, received = 0;
  };

  /// Calls use(peer, memory, info) for each field and each rank that has objects of it; all ranks in the same order.
  template <class Use>
  void each(const Use& use) const {
    for (const HaloFetch& fetch : fetches_) {
      const HaloNeed& need = set_of(fetch.field).needs[static_cast<std::size_t>(fetch.need)];
      for (const HaloPlan::Peer& peer : need.plan.peers) use(peer, array_of(fetch.field).memory, info_of(fetch.field));
    }
  }
  [[nodiscard]] static std::size_t bytes_of(const FieldInfo& info, index_t objects) {
    return info.is_stored() ? static_cast<std::size_t>(objects * info.count * element_bytes(info.type)) : 0;
  }
  [[nodiscard]] const DistributedArray& array_of(const HaloField& field) const {
    return arrays_.arrays()[static_cast<std::size_t>(field.array)];
  }
  [[nodiscard]] const FieldInfo& info_of(const HaloField& field) const {
    return array_of(field).memory.fields[static_cast<std::size_t>(field.field)];
  }
  [[nodiscard]] const DistributedSet& set_of(const HaloField& field) const {
    return arrays_.sets()[static_cast<std::size_t>(array_of(field).set)];
  }

  Partition& arrays_;
  std::vector<HaloFetch> fetches_;
  std::vector<Places> sizes_;               ///< by rank
  std::vector<std::byte> sent_, received_;  ///< of all ranks; they only grow
};

}  // namespace

std::unique_ptr<HaloExchange> make_host_exchange(Partition& arrays) { return std::make_unique<HostExchange>(arrays); }

ObjectRuns stale_ghosts(const DistributedSet& set, HaloNeedBits fresh) {
  ObjectRuns stale;
  for (std::size_t g = 0; g < set.local->ghosts().size(); ++g) {
    bool is_fresh = false;
    for (std::size_t n = 0; n < set.needs.size(); ++n) is_fresh |= (fresh >> n & 1) != 0 && set.needs[n].has[g] != 0;
    if (!is_fresh) stale.add(set.local->ghost(g));
  }
  return stale;
}

}  // namespace physgen
