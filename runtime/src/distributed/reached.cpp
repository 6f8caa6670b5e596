// Which objects of a rank need ghosts: the others can be computed while fields cross.
#include <physgen/distributed/partition.h>

#include <algorithm>

namespace physgen {

void Partition::find_reached() {
  if (ranks_.count() == 1) return;
  const std::size_t count = sets_.size();
  std::vector<std::vector<std::uint64_t>> reached(
      count);  // of each local object; all bits of what is not computed here
  for (std::size_t s = 0; s < count; ++s) {
    if (sets_[s].kind != DistributedSet::Kind::owned) continue;
    reached[s].assign(static_cast<std::size_t>(sets_[s].local->size()), ~std::uint64_t{0});
    for (index_t i = 0; i < sets_[s].local->size(); ++i) {
      if (is_complete(static_cast<int>(s), i, static_cast<int>(s))) reached[s][static_cast<std::size_t>(i)] = 0;
    }
  }
  std::vector<index_t> numbers;
  // What a connection adds to the objects of its set. @return whether it added something
  const auto add = [&](const Connection& connection) {
    const auto s = static_cast<std::size_t>(connection.source), t = static_cast<std::size_t>(connection.target);
    const LocalSet& target = *sets_[t].local;
    bool has_changed = false;
    for (index_t i = sets_[s].local->first(); i < sets_[s].local->last(); ++i) {
      if (!is_complete(connection.source, i, connection.target)) continue;
      std::uint64_t& mine = reached[s][static_cast<std::size_t>(i)];
      const std::uint64_t before = mine;
      numbers.clear();
      connection.named(sets_[s].local->global(i), numbers);
      for (const index_t number : numbers) {
        const index_t local = number < 0 ? -1 : target.local(number);
        if (local < 0) continue;
        if (target.is_ghost(local)) mine |= std::uint64_t{1} << (t % 64);
        if (sets_[t].follows >= 0) mine |= reached[t][static_cast<std::size_t>(local)];
      }
      has_changed |= mine != before;
    }
    return has_changed;
  };
  const auto is_of = [&](const Connection& connection, bool follows) {
    const DistributedSet& source = sets_[static_cast<std::size_t>(connection.source)];
    const DistributedSet& target = sets_[static_cast<std::size_t>(connection.target)];
    return source.kind == DistributedSet::Kind::owned && target.kind == DistributedSet::Kind::owned &&
           (source.follows >= 0) == follows;
  };
  // Sets that follow come first, and until nothing is added where they name each other.
  const bool has_chains = std::ranges::any_of(connections_, [&](const Connection& connection) {
    return is_of(connection, true) && sets_[static_cast<std::size_t>(connection.target)].follows >= 0;
  });
  for (bool is_again = true; is_again;) {
    is_again = false;
    for (const Connection& connection : connections_) is_again |= is_of(connection, true) && add(connection);
    is_again &= has_chains;
  }
  for (const Connection& connection : connections_) {
    if (is_of(connection, false)) add(connection);
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

void Partition::keep_what_leads_to_ghosts(const std::vector<std::vector<std::uint64_t>>& reached) {
  std::vector<index_t> numbers;
  for (Connection& connection : connections_) {
    const auto s = static_cast<std::size_t>(connection.source), t = static_cast<std::size_t>(connection.target);
    if (sets_[t].kind != DistributedSet::Kind::owned) continue;
    const LocalSet& target = *sets_[t].local;
    for (index_t i = sets_[s].local->first(); i < sets_[s].local->last(); ++i) {
      if (!is_complete(connection.source, i, connection.target)) continue;
      if (!reached[s].empty() && reached[s][static_cast<std::size_t>(i)] == 0) continue;
      numbers.clear();
      connection.named(sets_[s].local->global(i), numbers);
      for (const index_t number : numbers) {
        const index_t local = number < 0 ? -1 : target.local(number);
        if (local < 0 || (!target.is_ghost(local) && reached[t][static_cast<std::size_t>(local)] == 0)) continue;
        connection.to_ghosts.push_back({i, local});
      }
    }
  }
}

}  // namespace physgen
