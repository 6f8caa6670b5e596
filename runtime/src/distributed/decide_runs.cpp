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

/// Each object is counted by one rank that knows it. Ranks count objects that are consecutive.
class Share {
 public:
  /// @throw Error when an object is known to no rank
  Share(const DistributedSet& set, const KnownObjects& known, Transport& transport)
      : ascending_(static_cast<std::size_t>(transport.count())) {
    const std::vector<index_t> first = told_by_all(transport, known.first), last = told_by_all(transport, known.last);
    const auto first_of = [&](int rank) { return first[static_cast<std::size_t>(rank)]; };
    std::iota(ascending_.begin(), ascending_.end(), 0);
    std::ranges::stable_sort(ascending_, {}, first_of);
    index_t behind = 0;
    const auto require_up_to = [&](index_t next) {
      if (next <= behind) return;
      throw Error("what objects " + std::to_string(behind) + " .. " + std::to_string(next - 1) + " of set " + set.name +
                  " name is known to no rank; let one know more objects");
    };
    for (const int rank : ascending_) {
      require_up_to(first_of(rank));
      const index_t end = std::max(behind, last[static_cast<std::size_t>(rank)]);
      if (rank == transport.rank()) own_ = {behind, end};
      behind = end;
    }
    require_up_to(set.size);
  }
  /// Those of first .. last-1 that this rank counts.
  [[nodiscard]] index_t count_of(index_t first, index_t last) const {
    return std::max(index_t{0}, std::min(last, own_.last) - std::max(first, own_.first));
  }
  [[nodiscard]] const KnownObjects& own() const { return own_; }
  /// All ranks, in the order of what they count.
  [[nodiscard]] const std::vector<int>& ascending() const { return ascending_; }

 private:
  KnownObjects own_{0, 0};
  std::vector<int> ascending_;
};

/// Where some consecutive objects are best divided into those of ranks below a rank, and those of this rank and above.
struct Cut {
  index_t sum = 0;    ///< what it costs more where all are below than where none is
  index_t least = 0;  ///< what it costs more where those before `at` are
  index_t at = 0;     ///< none is below where `least` is 0
  void add(index_t object, index_t cost) {
    sum += cost;
    if (sum < least) *this = {sum, sum, object + 1};
  }
  void append(const Cut& behind) {
    if (sum + behind.least < least) least = sum + behind.least, at = behind.at;
    sum += behind.sum;
  }
};

/// The rank that owns all that a piece's objects name, each of which names some; or -1, where it is not one for all.
/// @param targets the set that each of the functions names
int owner_of_named(const std::vector<const detail::NamedObjects*>& named,
                   const std::vector<const DistributedSet*>& targets, const detail::ObjectPiece& piece) {
  int owner = -1;
  bool all_name = false;
  for (std::size_t n = 0; n < named.size(); ++n) {
    const detail::NamedBounds bounds = named[n]->bounds_of(piece);
    if (bounds.are_none()) continue;
    const Runs& runs = targets[n]->local->runs();
    if (bounds.low < 0 || bounds.high >= runs.size()) return -1;
    const int of_low = runs.owner(bounds.low);
    if (bounds.high >= runs.end(of_low) || (owner >= 0 && owner != of_low)) return -1;
    owner = of_low;
    all_name |= bounds.fewest > 0;
  }
  return all_name ? owner : -1;
}

/// Where runs begin that have so many objects each.
std::vector<index_t> begins_of(std::vector<index_t> counts) {
  std::exclusive_scan(counts.begin(), counts.end(), counts.begin(), index_t{0});
  return counts;
}

}  // namespace

std::vector<ObjectRuns> Partition::decide_runs() {
  for (DistributedSet& set : sets_) {
    if (set.kind == DistributedSet::Kind::owned && set.follows < 0) {
      set.local.emplace(Runs::of_blocks(set.size, ranks_.count()), ranks_.rank(), std::vector<index_t>());
    } else if (set.kind == DistributedSet::Kind::replicated) {
      set.local.emplace(Runs::of_blocks(set.size, 1), 0, std::vector<index_t>());
    }
  }
  std::vector<ObjectRuns> touching(sets_.size());
  for (std::size_t s = 0; s < sets_.size(); ++s) {
    if (sets_[s].follows >= 0) touching[s] = decide_runs_of(static_cast<int>(s));
  }
  return touching;
}

ObjectRuns Partition::decide_runs_of(int following) {
  DistributedSet& set = sets_[static_cast<std::size_t>(following)];
  const DistributedSet& followed = sets_[static_cast<std::size_t>(set.follows)];
  const Runs& runs = followed.local->runs();
  std::vector<const detail::NamedObjects*> named;
  for (const Connection& connection : connections_) {
    if (connection.source == following && connection.target == set.follows) named.push_back(&connection.named);
  }
  const std::vector<const DistributedSet*> targets(named.size(), &followed);
  const KnownObjects known = known_to_all(named, set.size);
  const Share share(set, known, *transport_);
  // Of the objects of this rank's share: how many have their lowest object on each rank, and name some of it.
  const auto ranks = static_cast<std::size_t>(ranks_.count());
  std::vector<index_t> lowest_on(ranks, 0), touching_of(ranks, 0);
  std::mutex counting;
  ObjectRuns all_known;
  all_known.add(known.first, known.last - known.first);
  const std::vector<detail::ObjectPiece> pieces = detail::pieces_of(all_known);
  std::vector<ObjectRuns> found(pieces.size());
  detail::each_named(
      named, pieces,
      [&](std::size_t p) {
        const detail::ObjectPiece& piece = pieces[p];
        const int owner = owner_of_named(named, targets, piece);
        if (owner < 0) return false;
        if (owner == ranks_.rank()) found[p].add(piece.first, piece.size());
        const index_t mine = share.count_of(piece.first, piece.last);
        const std::lock_guard lock(counting);
        lowest_on[static_cast<std::size_t>(owner)] += mine;
        touching_of[static_cast<std::size_t>(owner)] += mine;
        return true;
      },
      [&](const detail::NamedBatch& batch) {
        std::vector<index_t> lowest_of_batch(ranks, 0), touching_of_batch(ranks, 0);
        std::vector<int> owners;
        for (std::size_t k = 0; k < batch.size(); ++k) {
          owners.clear();
          for (const detail::NamedNumbers& numbers : batch.numbers) {
            for (const index_t number : numbers.of(k)) {
              detail::require_object(followed, number, batch.object(k));
              if (number < 0) continue;
              const int owner = runs.owner(number);
              if (std::ranges::find(owners, owner) == owners.end()) owners.push_back(owner);
            }
          }
          if (std::ranges::find(owners, ranks_.rank()) != owners.end()) found[batch.number].add(batch.object(k));
          if (owners.empty() || share.count_of(batch.object(k), batch.object(k) + 1) == 0) continue;
          ++lowest_of_batch[static_cast<std::size_t>(std::ranges::min(owners))];
          for (const int owner : owners) ++touching_of_batch[static_cast<std::size_t>(owner)];
        }
        const std::lock_guard lock(counting);
        for (std::size_t r = 0; r < ranks; ++r) {
          lowest_on[r] += lowest_of_batch[r];
          touching_of[r] += touching_of_batch[r];
        }
      });
  ObjectRuns touching;
  for (const ObjectRuns& of_piece : found) {
    for (const ObjectRuns::Run& run : of_piece.runs) touching.add(run.first, run.count);
  }
  const auto sum = [](const std::vector<index_t>& counts) {
    return std::accumulate(counts.begin(), counts.end(), index_t{0});
  };
  if (const index_t all = sum(transport_->all_to_all(touching_of)); all != touching.count) {
    throw Error("rank " + std::to_string(ranks_.rank()) + " knows " + std::to_string(touching.count) +
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
  // Where ranks below a rank end and it begins, the fewest named objects are owned on the other side. So an object is
  // computed about where most of what it names is owned, also where its neighbours in the order name others than it
  // does.
  const KnownObjects known = known_to_all(named, set.size);
  const Share share(set, known, *transport_);
  ObjectRuns counted;
  counted.add(share.own().first, share.own().last - share.own().first);
  const std::vector<detail::ObjectPiece> pieces = detail::pieces_of(counted);
  const auto ranks = static_cast<std::size_t>(ranks_.count());
  std::vector<std::vector<Cut>> found(pieces.size(), std::vector<Cut>(ranks));
  detail::each_named(
      named, pieces, [](std::size_t /*piece*/) { return false; },
      [&](const detail::NamedBatch& batch) {
        std::vector<Cut>& cuts = found[batch.number];
        std::vector<index_t> owned(ranks);  // of what an object names, by each rank
        for (std::size_t k = 0; k < batch.size(); ++k) {
          std::ranges::fill(owned, 0);
          index_t all = 0;
          for (std::size_t n = 0; n < named.size(); ++n) {
            for (const index_t number : batch.numbers[n].of(k)) {
              detail::require_object(*targets[n], number, batch.object(k));
              if (number < 0) continue;
              ++owned[static_cast<std::size_t>(targets[n]->local->runs().owner(number))];
              ++all;
            }
          }
          if (all == 0) {  // those that name none are spread evenly
            ++owned[static_cast<std::size_t>(batch.object(k) * ranks_.count() / set.size)];
            ++all;
          }
          index_t below = 0;
          for (std::size_t r = 0; r < ranks; ++r) {
            cuts[r].add(batch.object(k), all - 2 * below);
            below += owned[r];
          }
        }
      });
  std::vector<Cut> cuts(ranks);
  for (const std::vector<Cut>& of_piece : found) {
    for (std::size_t r = 0; r < ranks; ++r) cuts[r].append(of_piece[r]);
  }
  // Each rank is told where all others would cut what they count.
  const auto told = [&](index_t Cut::* const number) {
    std::vector<index_t> numbers;
    for (const Cut& cut : cuts) numbers.push_back(cut.*number);
    return transport_->all_to_all(numbers);
  };
  const std::vector<index_t> sums = told(&Cut::sum), leasts = told(&Cut::least), places = told(&Cut::at);
  Cut of_all;
  for (const int rank : share.ascending()) {
    const auto r = static_cast<std::size_t>(rank);
    of_all.append({sums[r], leasts[r], places[r]});
  }
  set.computed = Runs::at(set.size, told_by_all(*transport_, of_all.at));
}

}  // namespace physgen
