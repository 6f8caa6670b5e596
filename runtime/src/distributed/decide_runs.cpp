// Which objects each rank owns, and which objects of sets that all ranks have it computes.
#include <physgen/distributed/partition.h>

#include <algorithm>
#include <utility>

#include "named_batches.h"
#include "require_object.h"

namespace physgen {

std::vector<std::vector<index_t>> Partition::decide_runs() {
  const int ranks = ranks_.count();
  for (DistributedSet& set : sets_) {
    if (set.kind == DistributedSet::Kind::owned && set.follows < 0) {
      set.local.emplace(Runs::of_blocks(set.size, ranks), ranks_.rank(), std::vector<index_t>());
    } else if (set.kind == DistributedSet::Kind::replicated) {
      set.local.emplace(Runs::of_blocks(set.size, 1), 0, std::vector<index_t>());
    }
  }
  std::vector<std::vector<index_t>> touching(sets_.size());
  for (std::size_t s = 0; s < sets_.size(); ++s) {
    DistributedSet& set = sets_[s];
    if (set.follows < 0) continue;
    // As many objects before a rank's run as have their lowest object on ranks below: in ordered meshes these come
    // first.
    const DistributedSet& followed = sets_[static_cast<std::size_t>(set.follows)];
    const Runs& runs = followed.local->runs();
    std::vector<const detail::NamedObjects*> named;
    for (const Connection& connection : connections_) {
      if (connection.source == static_cast<int>(s) && connection.target == set.follows) {
        named.push_back(&connection.named);
      }
    }
    std::vector<int> owners(static_cast<std::size_t>(set.size), -1);  // of the lowest object that each names
    detail::FoundInBatches<index_t> found(set.size);
    detail::each_named(
        named, set.size, [](index_t i) { return i; },
        [&](const detail::NamedBatch& batch) {
          for (std::size_t k = 0; k < batch.objects.size(); ++k) {
            index_t lowest = runs.size();
            bool is_ours = false;
            for (const detail::NamedNumbers& numbers : batch.numbers) {
              for (const index_t number : numbers.of(k)) {
                detail::require_object(followed, number, batch.objects[k]);
                if (number < 0) continue;
                lowest = std::min(lowest, number);
                is_ours |= runs.owns(ranks_.rank(), number);
              }
            }
            if (lowest < runs.size()) owners[static_cast<std::size_t>(batch.objects[k])] = runs.owner(lowest);
            if (is_ours) found.of(batch).push_back(batch.objects[k]);
          }
        });
    found.append_to(touching[s]);
    std::vector<index_t> cuts(static_cast<std::size_t>(ranks) + 1, 0);
    for (const int owner : owners) {
      if (owner >= 0) ++cuts[static_cast<std::size_t>(owner) + 1];
    }
    for (std::size_t r = 1; r < cuts.size(); ++r) cuts[r] += cuts[r - 1];
    cuts.pop_back();
    set.local.emplace(Runs::near(set.size, cuts), ranks_.rank(), std::vector<index_t>());
  }
  return touching;
}

void Partition::decide_computed() {
  const auto ranks = static_cast<std::size_t>(ranks_.count());
  for (std::size_t s = 0; s < sets_.size(); ++s) {
    DistributedSet& set = sets_[s];
    if (set.kind != DistributedSet::Kind::replicated) continue;
    std::vector<const detail::NamedObjects*> named;
    std::vector<const DistributedSet*> targets;
    for (const Connection& connection : connections_) {
      const DistributedSet& target = sets_[static_cast<std::size_t>(connection.target)];
      if (connection.source != static_cast<int>(s) || target.kind != DistributedSet::Kind::owned) continue;
      named.push_back(&connection.named);
      targets.push_back(&target);
    }
    if (named.empty()) continue;
    // An object is computed about where most of what it names is owned: the owner in the middle of all. In ordered sets
    // these ascend; runs have as many objects as there are of each.
    std::vector<int> of_objects(static_cast<std::size_t>(set.size), -1);
    detail::each_named(
        named, set.size, [](index_t i) { return i; },
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
            of_objects[static_cast<std::size_t>(batch.objects[k])] = *middle;
          }
        });
    std::vector<index_t> cuts(ranks + 1, 0);
    int before = 0;
    for (const int owner : of_objects) {
      if (owner >= 0) before = owner;  // else that of the object before
      ++cuts[static_cast<std::size_t>(before) + 1];
    }
    for (std::size_t r = 1; r < cuts.size(); ++r) cuts[r] += cuts[r - 1];
    cuts.pop_back();
    set.computed = Runs::at(set.size, cuts);
  }
}

}  // namespace physgen
