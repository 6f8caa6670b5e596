#include <physgen/distributed/halo_plan.h>
#include <physgen/error.h>

#include <string>

namespace physgen {

namespace {

/// Calls use(object) for each, in ascending order.
template <class Use>
void each_object(const ObjectRuns& objects, const Use& use) {
  for (const ObjectRuns::Run& run : objects.runs) {
    for (index_t i = run.first; i < run.first + run.count; ++i) use(i);
  }
}

}  // namespace

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
  std::vector<std::vector<index_t>> asked(ranks);  // of this rank, by global numbers
  std::vector<Message> messages;
  for (std::size_t r = 0; r < ranks; ++r) {
    if (wanted[r] == 0 && given[r] == 0) continue;
    HaloPlan::Peer& peer = plan.peers.emplace_back();
    peer.rank = static_cast<int>(r);
    for (std::size_t g = first[r]; g < first[r + 1]; ++g) peer.received.add(set.ghost(g));
    asked[r].resize(static_cast<std::size_t>(given[r]));
    messages.push_back({peer.rank, std::as_bytes(set.ghosts().subspan(first[r], first[r + 1] - first[r])),
                        std::as_writable_bytes(std::span(asked[r]))});
  }
  transport.tell(messages);
  for (HaloPlan::Peer& peer : plan.peers) {
    for (const index_t object : asked[static_cast<std::size_t>(peer.rank)]) {
      if (!set.runs().owns(set.rank(), object)) {
        throw Error("rank " + std::to_string(peer.rank) + " asks rank " + std::to_string(set.rank()) + " for object " +
                    std::to_string(object) + ", which it does not own; give all ranks sets of equal sizes");
      }
      peer.sent.add(set.local(object));
    }
  }
  return plan;
}

HaloPlan make_halo_plan(const LocalSet& set, Transport& transport, const HaloPlan& all,
                        const std::vector<char>& is_needed) {
  // Of each ghost of the whole plan the owner is told whether it crosses here.
  std::vector<std::vector<char>> mine(all.peers.size()), of_others(all.peers.size());
  std::vector<Message> messages;
  for (std::size_t p = 0; p < all.peers.size(); ++p) {
    const HaloPlan::Peer& peer = all.peers[p];
    each_object(peer.received, [&](index_t ghost) { mine[p].push_back(is_needed[set.ghost_number(ghost)]); });
    of_others[p].resize(static_cast<std::size_t>(peer.sent.count));
    messages.push_back({peer.rank, std::as_bytes(std::span(mine[p])), std::as_writable_bytes(std::span(of_others[p]))});
  }
  transport.tell(messages);
  HaloPlan plan;
  for (std::size_t p = 0; p < all.peers.size(); ++p) {
    const auto some_of = [](const ObjectRuns& objects, const std::vector<char>& crosses) {
      ObjectRuns some;
      std::size_t at = 0;
      each_object(objects, [&](index_t object) {
        if (crosses[at++] != 0) some.add(object);
      });
      return some;
    };
    HaloPlan::Peer peer{all.peers[p].rank, some_of(all.peers[p].sent, of_others[p]),
                        some_of(all.peers[p].received, mine[p])};
    if (peer.sent.count + peer.received.count > 0) plan.peers.push_back(std::move(peer));
  }
  return plan;
}

}  // namespace physgen
