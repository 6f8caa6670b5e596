#include <physgen/distributed/halo_plan.h>
#include <physgen/error.h>

#include <string>

namespace physgen {

HaloPlan make_halo_plan(const LocalSet& set, Transport& transport) {
  const auto ranks = static_cast<std::size_t>(transport.count());
  // The ghosts of a rank follow each other, since runs ascend.
  std::vector<std::size_t> first(ranks + 1, 0);
  for (const index_t ghost : set.ghosts()) ++first[static_cast<std::size_t>(set.runs().owner(ghost)) + 1];
  for (std::size_t r = 0; r < ranks; ++r) first[r + 1] += first[r];
  std::vector<index_t> wanted(ranks);
  for (std::size_t r = 0; r < ranks; ++r) wanted[r] = static_cast<index_t>(first[r + 1] - first[r]);
  const std::vector<index_t> given = transport.all_to_all(wanted);

  HaloPlan plan;
  std::vector<Message> messages;
  for (std::size_t r = 0; r < ranks; ++r) {
    if (wanted[r] == 0 && given[r] == 0) continue;
    HaloPlan::Peer peer{static_cast<int>(r), std::vector<index_t>(static_cast<std::size_t>(given[r])), 0, 0};
    if (wanted[r] > 0) {
      peer.first = set.ghost(first[r]);
      peer.last = peer.first + wanted[r];
    }
    plan.peers.push_back(std::move(peer));
  }
  for (HaloPlan::Peer& peer : plan.peers) {
    const auto r = static_cast<std::size_t>(peer.rank);
    const std::span<const index_t> asked = set.ghosts().subspan(first[r], first[r + 1] - first[r]);
    messages.push_back({peer.rank, std::as_bytes(asked), std::as_writable_bytes(std::span(peer.sent))});
  }
  transport.begin(messages);
  transport.end();
  for (HaloPlan::Peer& peer : plan.peers) {
    for (index_t& object : peer.sent) {
      if (!set.runs().owns(set.rank(), object)) {
        throw Error("rank " + std::to_string(peer.rank) + " asks rank " + std::to_string(set.rank()) + " for object " +
                    std::to_string(object) + ", which it does not own; give all ranks sets of equal sizes");
      }
      object = set.local(object);
    }
  }
  return plan;
}

}  // namespace physgen
