// Which objects each rank owns, and which objects of sets that all ranks have it computes. Each
// object is counted by one rank, and ranks tell each other what they have counted.
#include <physgen/distributed/partition.h>

#include <algorithm>
#include <mutex>
#include <numeric>
#include <utility>

#include "named_batches.h"
#include "require_object.h"

namespace physgen {

namespace {

/// The objects of which a rank can tell all that some functions do.
KnownObjects known_to_all(const std::vector<const detail::NamedObjects*>& named, index_t size) {
  KnownObjects known{0, size};
  for (const detail::NamedObjects* const one : named) {
    known = {std::max(known.first, one->known().first), std::min(known.last, one->known().last)};
  }
  return {std::min(known.first, known.last), known.last};
}

/// The number of each rank.
std::vector<index_t> told_by_all(Transport& transport, index_t mine) {
  return transport.all_to_all(std::vector<index_t>(static_cast<std::size_t>(transport.count()), mine));
}

/// Each object is counted by one rank: the lowest that knows it.
class Share {
 public:
  /// @throw Error when an object is known to no rank
  Share(const DistributedSet& set, const KnownObjects& known, Transport& transport) : own_(known) {
    const std::vector<index_t> first = told_by_all(transport, known.first), last = told_by_all(transport, known.last);
    std::vector<KnownObjects> all;
    for (std::size_t r = 0; r < first.size(); ++r) all.push_back({first[r], last[r]});
    below_.assign(all.begin(), all.begin() + transport.rank());
    std::ranges::sort(all, {}, &KnownObjects::first);
    all.push_back({set.size, set.size});
    index_t behind = 0;
    for (const KnownObjects& of_rank : all) {
      if (of_rank.first > behind) {
        throw Error("what objects " + std::to_string(behind) + " .. " + std::to_string(of_rank.first - 1) + " of set " +
                    set.name + " name is known to no rank; let one know more objects");
      }
      behind = std::max(behind, of_rank.last);
    }
  }
  [[nodiscard]] bool has(index_t object) const {
    return own_.has(object) && std::ranges::none_of(below_, [=](const KnownObjects& one) { return one.has(object); });
  }

 private:
  KnownObjects own_;
  std::vector<KnownObjects> below_;
};

/// Where runs begin that have so many objects each.
std::vector<index_t> begins_of(std::vector<index_t> counts) {
  std::exclusive_scan(counts.begin(), counts.end(), counts.begin(), index_t{0});
  return counts;
}

}  // namespace

std::vector<std::vector<index_t>> Partition::decide_runs() {
  for (DistributedSet& set : sets_) {
    if (set.kind == DistributedSet::Kind::owned && set.follows < 0) {
      set.local.emplace(Runs::of_blocks(set.size, ranks_.count()), ranks_.rank(), std::vector<index_t>());
    } else if (set.kind == DistributedSet::Kind::replicated) {
      set.local.emplace(Runs::of_blocks(set.size, 1), 0, std::vector<index_t>());
    }
  }
  std::vector<std::vector<index_t>> touching(sets_.size());
  for (std::size_t s = 0; s < sets_.size(); ++s) {
    if (sets_[s].follows >= 0) touching[s] = decide_runs_of(static_cast<int>(s));
  }
  return touching;
}

std::vector<index_t> Partition::decide_runs_of(int following) {
  DistributedSet& set = sets_[static_cast<std::size_t>(following)];
  const DistributedSet& followed = sets_[static_cast<std::size_t>(set.follows)];
  const Runs& runs = followed.local->runs();
  std::vector<const detail::NamedObjects*> named;
  for (const Connection& connection : connections_) {
    if (connection.source == following && connection.target == set.follows) named.push_back(&connection.named);
  }
  const KnownObjects known = known_to_all(named, set.size);
  const Share share(set, known, *transport_);
  // Of the objects of this rank's share: how many have their lowest object on each rank, and name some of it.
  const auto ranks = static_cast<std::size_t>(ranks_.count());
  std::vector<index_t> lowest_on(ranks, 0), touching_of(ranks, 0);
  std::mutex counting;
  detail::FoundInBatches<index_t> found(known.last - known.first);
  detail::each_named(
      named, known.last - known.first, [&](index_t i) { return known.first + i; },
      [&](const detail::NamedBatch& batch) {
        std::vector<index_t> lowest_of_batch(ranks, 0), touching_of_batch(ranks, 0);
        std::vector<int> owners;
        for (std::size_t k = 0; k < batch.objects.size(); ++k) {
          owners.clear();
          for (const detail::NamedNumbers& numbers : batch.numbers) {
            for (const index_t number : numbers.of(k)) {
              detail::require_object(followed, number, batch.objects[k]);
              if (number < 0) continue;
              const int owner = runs.owner(number);
              if (std::ranges::find(owners, owner) == owners.end()) owners.push_back(owner);
            }
          }
          if (std::ranges::find(owners, ranks_.rank()) != owners.end()) found.of(batch).push_back(batch.objects[k]);
          if (owners.empty() || !share.has(batch.objects[k])) continue;
          ++lowest_of_batch[static_cast<std::size_t>(std::ranges::min(owners))];
          for (const int owner : owners) ++touching_of_batch[static_cast<std::size_t>(owner)];
        }
        const std::lock_guard lock(counting);
        for (std::size_t r = 0; r < ranks; ++r) {
          lowest_on[r] += lowest_of_batch[r];
          touching_of[r] += touching_of_batch[r];
        }
      });
  std::vector<index_t> touching;
  found.append_to(touching);
  const auto sum = [](const std::vector<index_t>& counts) {
    return std::accumulate(counts.begin(), counts.end(), index_t{0});
  };
  if (const index_t all = sum(transport_->all_to_all(touching_of)); all != static_cast<index_t>(touching.size())) {
    throw Error("rank " + std::to_string(ranks_.rank()) + " knows " + std::to_string(touching.size()) +
                " objects of set " + set.name + " that name objects of its own of set " + followed.name +
                ", and there are " + std::to_string(all) + "; let the rank know more than " +
                std::to_string(known.first) + " .. " + std::to_string(known.last - 1));
  }
  // As many objects before a rank's run as have their lowest object on ranks below: in ordered meshes these come first.
  const index_t of_this = sum(transport_->all_to_all(lowest_on));
  set.local.emplace(Runs::near(set.size, begins_of(told_by_all(*transport_, of_this))), ranks_.rank(),
                    std::vector<index_t>());
  return touching;
}

void Partition::decide_computed() {
  for (std::size_t s = 0; s < sets_.size(); ++s) {
    if (sets_[s].kind == DistributedSet::Kind::replicated) decide_computed_of(static_cast<int>(s));
  }
}

void Partition::decide_computed_of(int replicated) {
  DistributedSet& set = sets_[static_cast<std::size_t>(replicated)];
  std::vector<const detail::NamedObjects*> named;
  std::vector<const DistributedSet*> targets;
  for (const Connection& connection : connections_) {
    const DistributedSet& target = sets_[static_cast<std::size_t>(connection.target)];
    if (connection.source != replicated || target.kind != DistributedSet::Kind::owned) continue;
    named.push_back(&connection.named);
    targets.push_back(&target);
  }
  if (named.empty()) return;
  // An object is computed about where most of what it names is owned: the owner in the middle of all. In ordered sets
  // these ascend; runs have as many objects as there are of each.
  const KnownObjects known = known_to_all(named, set.size);
  const Share share(set, known, *transport_);
  std::vector<index_t> objects;
  for (index_t i = known.first; i < known.last; ++i) {
    if (share.has(i)) objects.push_back(i);
  }
  const auto count = static_cast<index_t>(objects.size());
  std::vector<int> of_objects(objects.size(), -1);
  detail::each_named(
      named, count, [&](index_t i) { return objects[static_cast<std::size_t>(i)]; },
      [&](const detail::NamedBatch& batch) {
        std::vector<int> owners;
        for (std::size_t k = 0; k < batch.objects.size(); ++k) {
          owners.clear();
          for (std::size_t n = 0; n < named.size(); ++n) {
            for (const index_t number : batch.numbers[n].of(k)) {
              detail::require_object(*targets[n], number, batch.objects[k]);
              if (number >= 0) owners.push_back(targets[n]->local->runs().owner(number));
            }
          }
          if (owners.empty()) continue;
          const auto middle = owners.begin() + static_cast<std::ptrdiff_t>(owners.size() / 2);
          std::nth_element(owners.begin(), middle, owners.end());
          of_objects[static_cast<std::size_t>(batch.first) + k] = *middle;
        }
      });
  // Those that name none are spread evenly.
  std::vector<index_t> counts(static_cast<std::size_t>(ranks_.count()), 0);
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const index_t evenly = objects[k] * ranks_.count() / set.size;
    ++counts[static_cast<std::size_t>(of_objects[k] >= 0 ? index_t{of_objects[k]} : evenly)];
  }
  const std::vector<index_t> counted = transport_->all_to_all(counts);
  const index_t of_this = std::accumulate(counted.begin(), counted.end(), index_t{0});
  set.computed = Runs::at(set.size, begins_of(told_by_all(*transport_, of_this)));
}

}  // namespace physgen
