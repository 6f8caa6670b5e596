// Exchanges between arrays that the host reaches.
#include <physgen/distributed/halo_exchange.h>
#include <physgen/distributed/partition.h>

#include <cstring>
#include <vector>

namespace physgen {

namespace {

/// Calls use(address, bytes) for the elements of a field of an object.
template <class Use>
void each_element(const UntypedArray& memory, const FieldInfo& info, index_t object, const Use& use) {
  const int size = element_bytes(info.type);
  for (int k = 0; k < info.count && size > 0; ++k) {
    use(memory.address(object, info.offset + k * size, size), static_cast<std::size_t>(size));
  }
}

class HostExchange final : public HaloExchange {
 public:
  explicit HostExchange(Partition& arrays) : arrays_(arrays) {}

  void begin(std::span<const HaloField> fields) override {
    const auto ranks = static_cast<std::size_t>(arrays_.ranks().count());
    fields_.assign(fields.begin(), fields.end());
    sent_.assign(ranks, {});
    received_.assign(ranks, {});
    std::vector<std::size_t> to_come(ranks, 0);
    // Field by field, object by object, element by element.
    for (const HaloField& field : fields) {
      const UntypedArray& memory = array_of(field).memory;
      const FieldInfo& info = memory.fields[static_cast<std::size_t>(field.field)];
      for (const HaloPlan::Peer& peer : set_of(field).plan.peers) {
        const auto r = static_cast<std::size_t>(peer.rank);
        std::vector<std::byte>& sent = sent_[r];
        for (const index_t object : peer.sent) {
          each_element(memory, info, object,
                       [&](const std::byte* at, std::size_t size) { sent.insert(sent.end(), at, at + size); });
        }
        to_come[r] += static_cast<std::size_t>((peer.last - peer.first) * info.count * element_bytes(info.type));
      }
    }
    std::vector<Message> messages;
    for (std::size_t r = 0; r < ranks; ++r) {
      received_[r].resize(to_come[r]);
      if (sent_[r].empty() && to_come[r] == 0) continue;
      messages.push_back({static_cast<int>(r), sent_[r], received_[r]});
    }
    arrays_.transport().begin(messages);
  }

  void end() override {
    arrays_.transport().end();
    std::vector<std::size_t> taken(received_.size(), 0);
    for (const HaloField& field : fields_) {
      const UntypedArray& memory = array_of(field).memory;
      const FieldInfo& info = memory.fields[static_cast<std::size_t>(field.field)];
      for (const HaloPlan::Peer& peer : set_of(field).plan.peers) {
        const auto r = static_cast<std::size_t>(peer.rank);
        for (index_t object = peer.first; object < peer.last; ++object) {
          each_element(memory, info, object, [&](std::byte* at, std::size_t size) {
            std::memcpy(at, received_[r].data() + taken[r], size);
            taken[r] += size;
          });
        }
      }
    }
    fields_.clear();
    sent_.clear();
    received_.clear();
  }

  void gather(std::span<const HaloField> fields, const Runs& computed) override {
    const auto each = [&](int rank, const auto& use) {
      for (const HaloField& field : fields) {
        const UntypedArray& memory = array_of(field).memory;
        const FieldInfo& info = memory.fields[static_cast<std::size_t>(field.field)];
        for (index_t i = computed.begin(rank); i < computed.end(rank); ++i) each_element(memory, info, i, use);
      }
    };
    index_t bytes_of_object = 0;
    for (const HaloField& field : fields) {
      const FieldInfo& info = array_of(field).memory.fields[static_cast<std::size_t>(field.field)];
      bytes_of_object += info.count * element_bytes(info.type);
    }
    std::vector<index_t> sizes;
    for (int r = 0; r < computed.ranks(); ++r) sizes.push_back((computed.end(r) - computed.begin(r)) * bytes_of_object);
    std::vector<std::byte> given, all(static_cast<std::size_t>(computed.size() * bytes_of_object));
    each(arrays_.ranks().rank(),
         [&](const std::byte* at, std::size_t size) { given.insert(given.end(), at, at + size); });
    arrays_.transport().gather(given, sizes, all);
    const std::byte* from = all.data();
    for (int r = 0; r < computed.ranks(); ++r) {
      each(r, [&](std::byte* at, std::size_t size) {
        std::memcpy(at, from, size);
        from += size;
      });
    }
  }

  void poison(const HaloField& field) override {
    const UntypedArray& memory = array_of(field).memory;
    const LocalSet& objects = *set_of(field).local;
    const FieldInfo& info = memory.fields[static_cast<std::size_t>(field.field)];
    const std::uint64_t bits = bits_of_no_value(info.type);
    for (std::size_t g = 0; g < objects.ghosts().size(); ++g) {
      each_element(memory, info, objects.ghost(g),
                   [&](std::byte* at, std::size_t size) { std::memcpy(at, &bits, size); });
    }
  }

 private:
  [[nodiscard]] const DistributedArray& array_of(const HaloField& field) const {
    return arrays_.arrays()[static_cast<std::size_t>(field.array)];
  }
  [[nodiscard]] const DistributedSet& set_of(const HaloField& field) const {
    return arrays_.sets()[static_cast<std::size_t>(array_of(field).set)];
  }

  Partition& arrays_;
  std::vector<HaloField> fields_;
  std::vector<std::vector<std::byte>> sent_, received_;  ///< by rank
};

}  // namespace

std::unique_ptr<HaloExchange> make_host_exchange(Partition& arrays) { return std::make_unique<HostExchange>(arrays); }

}  // namespace physgen
