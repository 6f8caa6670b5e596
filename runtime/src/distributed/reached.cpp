// Which objects of a rank need ghosts: the others can be computed while fields cross.
#include <physgen/distributed/partition.h>

#include <algorithm>
#include <atomic>
#include <utility>

#include "named_batches.h"

namespace physgen {

Partition::Reached::Reached(index_t size, index_t first, index_t last)
    : objects(static_cast<std::size_t>(size), 0),
      groups(static_cast<std::size_t>((size + DistributedSet::group - 1) / DistributedSet::group), 0) {
  for (const auto& [from, to] : {std::pair{index_t{0}, first}, std::pair{last, size}}) {
    for (index_t i = from; i < to; ++i) add(i, ~std::uint64_t{0});
  }
}

bool Partition::Reached::any(index_t first, index_t last) {
  if (first >= last) return false;
  const auto group = [&](index_t object) { return groups.begin() + object / DistributedSet::group; };
  return std::any_of(group(first), group(last - 1) + 1,
                     [](std::uint64_t& bits) { return std::atomic_ref(bits).load(std::memory_order_relaxed) != 0; });
}

bool Partition::Reached::add(index_t object, std::uint64_t bits) {
  const auto place = static_cast<std::size_t>(object);
  const std::uint64_t before = std::atomic_ref(objects[place]).fetch_or(bits, std::memory_order_relaxed);
  if ((before | bits) == before) return false;
  std::atomic_ref(groups[place / DistributedSet::group]).fetch_or(bits, std::memory_order_relaxed);
  return true;
}

std::uint64_t Partition::Reached::of(index_t object) {
  return std::atomic_ref(objects[static_cast<std::size_t>(object)]).load(std::memory_order_relaxed);
}

void Partition::find_reached() {
  if (ranks_.count() == 1) return;
  const std::size_t count = sets_.size();
  std::vector<Reached> reached(count);
  for (std::size_t s = 0; s < count; ++s) {
    if (sets_[s].kind != DistributedSet::Kind::owned) continue;
    const auto [first, last] = complete(static_cast<int>(s), static_cast<int>(s));
    reached[s] = Reached(sets_[s].local->size(), first, last);
  }
  const auto is_of = [&](const Connection& connection, bool follows) {
    const DistributedSet& source = sets_[static_cast<std::size_t>(connection.source)];
    const DistributedSet& target = sets_[static_cast<std::size_t>(connection.target)];
    return source.kind == DistributedSet::Kind::owned && target.kind == DistributedSet::Kind::owned &&
           (source.follows >= 0) == follows;
  };
  // Sets that follow come first, and until nothing is added where they name each other.
  for (std::size_t c = 0; c < connections_.size(); ++c) {
    if (is_of(connections_[c], true)) (void)add_reached(c, reached);
  }
  for (bool is_again = true; is_again;) {
    is_again = false;
    for (std::size_t c = 0; c < connections_.size(); ++c) {
      const bool names_such = sets_[static_cast<std::size_t>(connections_[c].target)].follows >= 0;
      is_again |= names_such && is_of(connections_[c], true) && add_reached(c, reached);
    }
  }
  for (std::size_t c = 0; c < connections_.size(); ++c) {
    if (is_of(connections_[c], false)) (void)add_reached(c, reached);
  }
  keep_what_leads_to_ghosts(reached);
  for (std::size_t s = 0; s < count; ++s) sets_[s].reached = std::move(reached[s].groups);
}

bool Partition::may_reach(std::size_t connection, const detail::ObjectPiece& piece, Reached& target) const {
  if (!owns_named(connection, piece)) return true;
  const detail::NamedBounds bounds = connections_[connection].named.bounds_of(piece);
  const index_t below = below_local(connection);
  return !bounds.are_none() && target.any(bounds.low - below, bounds.high - below + 1);
}

bool Partition::add_reached(std::size_t connection, std::vector<Reached>& reached) const {
  const Connection& by = connections_[connection];
  const auto s = static_cast<std::size_t>(by.source), t = static_cast<std::size_t>(by.target);
  const LocalSet& target = *sets_[t].local;
  const bool leads_on = sets_[t].follows >= 0;
  const auto [first, last] = complete(by.source, by.target);
  const std::vector<detail::ObjectPiece> all = pieces(by.source, first, last);
  std::atomic<bool> has_changed = false;
  detail::each_named(
      {&by.named}, all,
      [&](std::size_t p) {
        return leads_on ? !may_reach(connection, all[p], reached[t]) : owns_named(connection, all[p]);
      },
      [&, first = first](const detail::NamedBatch& batch) {
        for (std::size_t k = 0; k < batch.size(); ++k) {
          std::uint64_t added = 0;
          for (const index_t number : batch.numbers.front().of(k)) {
            const index_t local = number < 0 ? -1 : target.local(number);
            if (local < 0) continue;
            if (target.is_ghost(local)) added |= std::uint64_t{1} << (t % 64);
            if (leads_on) added |= reached[t].of(local);
          }
          if (added == 0) continue;
          if (reached[s].add(first + batch.piece.place + static_cast<index_t>(k), added)) {
            has_changed.store(true, std::memory_order_relaxed);
          }
        }
      });
  return has_changed;
}

void Partition::keep_what_leads_to_ghosts(std::vector<Reached>& reached) {
  for (std::size_t c = 0; c < connections_.size(); ++c) {
    Connection& by = connections_[c];
    const auto s = static_cast<std::size_t>(by.source), t = static_cast<std::size_t>(by.target);
    if (sets_[t].kind != DistributedSet::Kind::owned) continue;
    const LocalSet& target = *sets_[t].local;
    const bool all_lead = reached[s].objects.empty();
    const auto [first, last] = complete(by.source, by.target);
    const std::vector<detail::ObjectPiece> all = pieces(by.source, first, last);
    std::vector<std::vector<std::array<std::int32_t, 2>>> found(all.size());
    detail::each_named(
        {&by.named}, all,
        [&, first = first](std::size_t p) {
          const index_t begin = first + all[p].place;
          return (!all_lead && !reached[s].any(begin, begin + all[p].size())) || !may_reach(c, all[p], reached[t]);
        },
        [&, first = first](const detail::NamedBatch& batch) {
          for (std::size_t k = 0; k < batch.size(); ++k) {
            const index_t leading = first + batch.piece.place + static_cast<index_t>(k);
            if (!all_lead && reached[s].of(leading) == 0) continue;
            for (const index_t number : batch.numbers.front().of(k)) {
              const index_t local = number < 0 ? -1 : target.local(number);
              if (local < 0 || (!target.is_ghost(local) && reached[t].of(local) == 0)) continue;
              found[batch.number].push_back({static_cast<std::int32_t>(leading), static_cast<std::int32_t>(local)});
            }
          }
        });
    std::size_t size = 0;
    for (const auto& of_piece : found) size += of_piece.size();
    by.to_ghosts.reserve(size);
    for (const auto& of_piece : found) by.to_ghosts.insert(by.to_ghosts.end(), of_piece.begin(), of_piece.end());
  }
}

}  // namespace physgen
