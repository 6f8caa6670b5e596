// Which objects of a rank need ghosts: the others can be computed while fields cross.
#include <physgen/distributed/partition.h>

#include <algorithm>
#include <atomic>

#include "named_batches.h"

namespace physgen {

void Partition::find_reached() {
  if (ranks_.count() == 1) return;
  const std::size_t count = sets_.size();
  std::vector<Reached> reached(count);  // of each local object; all bits of what is not computed here
  for (std::size_t s = 0; s < count; ++s) {
    if (sets_[s].kind != DistributedSet::Kind::owned) continue;
    reached[s].assign(static_cast<std::size_t>(sets_[s].local->size()), ~std::uint64_t{0});
    const auto [first, last] = complete(static_cast<int>(s), static_cast<int>(s));
    std::fill(reached[s].begin() + first, reached[s].begin() + last, 0);
  }
  const auto is_of = [&](const Connection& connection, bool follows) {
    const DistributedSet& source = sets_[static_cast<std::size_t>(connection.source)];
    const DistributedSet& target = sets_[static_cast<std::size_t>(connection.target)];
    return source.kind == DistributedSet::Kind::owned && target.kind == DistributedSet::Kind::owned &&
           (source.follows >= 0) == follows;
  };
  // Sets that follow come first, and until nothing is added where they name each other.
  for (const Connection& connection : connections_) {
    if (is_of(connection, true)) (void)add_reached(connection, reached);
  }
  for (bool is_again = true; is_again;) {
    is_again = false;
    for (const Connection& connection : connections_) {
      const bool names_such = sets_[static_cast<std::size_t>(connection.target)].follows >= 0;
      is_again |= names_such && is_of(connection, true) && add_reached(connection, reached);
    }
  }
  for (const Connection& connection : connections_) {
    if (is_of(connection, false)) (void)add_reached(connection, reached);
  }
  keep_what_leads_to_ghosts(reached);
  for (std::size_t s = 0; s < count; ++s) {
    const auto objects = static_cast<index_t>(reached[s].size());
    sets_[s].reached.assign(static_cast<std::size_t>((objects + DistributedSet::group - 1) / DistributedSet::group), 0);
    for (index_t i = 0; i < objects; ++i) {
      sets_[s].reached[static_cast<std::size_t>(i / DistributedSet::group)] |= reached[s][static_cast<std::size_t>(i)];
    }
  }
}

bool Partition::add_reached(const Connection& connection, std::vector<Reached>& reached) const {
  const auto s = static_cast<std::size_t>(connection.source), t = static_cast<std::size_t>(connection.target);
  const LocalSet &source = *sets_[s].local, &target = *sets_[t].local;
  const auto [first, last] = complete(connection.source, connection.target);
  std::atomic<bool> has_changed = false;
  // Where objects of a set name each other, one thread reads what another writes: bits, which are only added.
  const auto bits_of = [](std::uint64_t& bits) { return std::atomic_ref(bits); };
  detail::each_named(
      {&connection.named}, last - first, [&, first = first](index_t i) { return source.global(first + i); },
      [&, first = first](const detail::NamedBatch& batch) {
        for (std::size_t k = 0; k < batch.objects.size(); ++k) {
          std::uint64_t added = 0;
          for (const index_t number : batch.numbers.front().of(k)) {
            const index_t local = number < 0 ? -1 : target.local(number);
            if (local < 0) continue;
            if (target.is_ghost(local)) added |= std::uint64_t{1} << (t % 64);
            if (sets_[t].follows >= 0) {
              added |= bits_of(reached[t][static_cast<std::size_t>(local)]).load(std::memory_order_relaxed);
            }
          }
          if (added == 0) continue;
          const index_t i = first + batch.first + static_cast<index_t>(k);
          const auto mine = bits_of(reached[s][static_cast<std::size_t>(i)]);
          const std::uint64_t before = mine.load(std::memory_order_relaxed);
          if ((before | added) == before) continue;
          mine.store(before | added, std::memory_order_relaxed);
          has_changed.store(true, std::memory_order_relaxed);
        }
      });
  return has_changed;
}

void Partition::keep_what_leads_to_ghosts(const std::vector<Reached>& reached) {
  for (Connection& connection : connections_) {
    const auto s = static_cast<std::size_t>(connection.source), t = static_cast<std::size_t>(connection.target);
    if (sets_[t].kind != DistributedSet::Kind::owned) continue;
    const LocalSet &source = *sets_[s].local, &target = *sets_[t].local;
    const auto [first, last] = complete(connection.source, connection.target);
    std::vector<index_t> leading;
    for (index_t i = first; i < last; ++i) {
      if (reached[s].empty() || reached[s][static_cast<std::size_t>(i)] != 0) leading.push_back(i);
    }
    const auto count = static_cast<index_t>(leading.size());
    detail::FoundInBatches<std::array<index_t, 2>> found(count);
    detail::each_named(
        {&connection.named}, count, [&](index_t i) { return source.global(leading[static_cast<std::size_t>(i)]); },
        [&](const detail::NamedBatch& batch) {
          for (std::size_t k = 0; k < batch.objects.size(); ++k) {
            for (const index_t number : batch.numbers.front().of(k)) {
              const index_t local = number < 0 ? -1 : target.local(number);
              if (local < 0 || (!target.is_ghost(local) && reached[t][static_cast<std::size_t>(local)] == 0)) continue;
              found.of(batch).push_back({leading[static_cast<std::size_t>(batch.first) + k], local});
            }
          }
        });
    found.append_to(connection.to_ghosts);
  }
}

}  // namespace physgen
