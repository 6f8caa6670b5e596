// What each rank has of the sets: runs, and the ghosts that the objects name which it computes.
#include <physgen/distributed/partition.h>

#include <algorithm>
#include <utility>

namespace physgen {

namespace {

/// @throw Error when the number names no object
void require_object(const DistributedSet& set, index_t number, index_t by) {
  if (number >= -1 && number < set.size) return;
  throw Error("object " + std::to_string(by) + " names object " + std::to_string(number) + " of set " + set.name +
              ", which has " + std::to_string(set.size) + "; name one of 0 .. size-1, or -1 for none");
}

}  // namespace

void Partition::cut() {
  if (is_cut_) throw Error("cut() was called a second time; make other arrays");
  std::string text;
  for (const DistributedSet& set : sets_) {
    text += set.name + ":" + std::to_string(set.size) + " ";
    if (set.same_as >= 0) text += "same as " + sets_[static_cast<std::size_t>(set.same_as)].name + " ";
  }
  ranks_.agree("list of sets and sizes", text);
  text.clear();
  for (const HaloUse& use : uses_) {
    text += std::string(use.kernel) + " " + std::to_string(use.view) + " " + std::string(use.field) + " " +
            std::string(use.through) + " ";
    for (const bool flag :
         {use.access.reads_own, use.access.reads_others, use.access.writes_own, use.access.writes_others})
      text += flag ? '1' : '0';
  }
  ranks_.agree("table of kernels", std::to_string(std::hash<std::string>()(text)));

  decide_runs();
  decide_computed();
  find_ghosts();
  for (DistributedSet& set : sets_) {  // what was connected by the other name asks it for local numbers
    if (set.same_as >= 0) set.local = sets_[static_cast<std::size_t>(number_of(set.name))].local;
  }
  find_reached();
  find_fields_that_name_parts();
  is_cut_ = true;
  for (DistributedArray& array : arrays_) {
    const DistributedSet& set = sets_[static_cast<std::size_t>(array.set)];
    if (set.kind != DistributedSet::Kind::entries) array.resize(set.local ? set.local->size() : set.size);
  }
  for (const Connection& connection : connections_) {
    if (connection.store) connection.store();
  }
  for (DistributedArray& array : arrays_) array.memory = array.untyped();
}

void Partition::decide_runs() {
  const int ranks = ranks_.count();
  for (DistributedSet& set : sets_) {
    if (set.kind == DistributedSet::Kind::owned && set.follows < 0) {
      set.local.emplace(Runs::of_blocks(set.size, ranks), ranks_.rank(), std::vector<index_t>());
    } else if (set.kind == DistributedSet::Kind::replicated) {
      set.local.emplace(Runs::of_blocks(set.size, 1), 0, std::vector<index_t>());
    }
  }
  for (std::size_t s = 0; s < sets_.size(); ++s) {
    DistributedSet& set = sets_[s];
    if (set.follows < 0) continue;
    // As many objects before a rank's run as have their lowest object on ranks below: in ordered meshes these come
    // first.
    const Runs& followed = sets_[static_cast<std::size_t>(set.follows)].local->runs();
    std::vector<index_t> cuts(static_cast<std::size_t>(ranks) + 1, 0), numbers;
    for (index_t i = 0; i < set.size; ++i) {
      index_t lowest = followed.size();
      for (const Connection& connection : connections_) {
        if (connection.source != static_cast<int>(s) || connection.target != set.follows) continue;
        numbers.clear();
        connection.named(i, numbers);
        for (const index_t number : numbers) {
          require_object(sets_[static_cast<std::size_t>(set.follows)], number, i);
          if (number >= 0) lowest = std::min(lowest, number);
        }
      }
      if (lowest < followed.size()) ++cuts[static_cast<std::size_t>(followed.owner(lowest)) + 1];
    }
    for (std::size_t r = 1; r < cuts.size(); ++r) cuts[r] += cuts[r - 1];
    cuts.pop_back();
    set.local.emplace(Runs::near(set.size, cuts), ranks_.rank(), std::vector<index_t>());
  }
}

void Partition::decide_computed() {
  const auto ranks = static_cast<std::size_t>(ranks_.count());
  for (std::size_t s = 0; s < sets_.size(); ++s) {
    DistributedSet& set = sets_[s];
    if (set.kind != DistributedSet::Kind::replicated) continue;
    std::vector<const Connection*> to_parts;
    for (const Connection& connection : connections_) {
      const DistributedSet& target = sets_[static_cast<std::size_t>(connection.target)];
      const bool is_of_parts = target.kind == DistributedSet::Kind::owned;
      if (connection.source == static_cast<int>(s) && is_of_parts) to_parts.push_back(&connection);
    }
    if (to_parts.empty()) continue;
    // An object is computed about where most of what it names is owned: the owner in the middle of all. In ordered sets
    // these ascend; runs have as many objects as there are of each.
    std::vector<index_t> cuts(ranks + 1, 0), numbers;
    std::vector<int> owners;
    int owner = 0;
    for (index_t i = 0; i < set.size; ++i) {
      owners.clear();
      for (const Connection* const connection : to_parts) {
        const DistributedSet& target = sets_[static_cast<std::size_t>(connection->target)];
        numbers.clear();
        connection->named(i, numbers);
        for (const index_t number : numbers) {
          require_object(target, number, i);
          if (number >= 0) owners.push_back(target.local->runs().owner(number));
        }
      }
      const auto middle = owners.begin() + static_cast<std::ptrdiff_t>(owners.size() / 2);
      std::nth_element(owners.begin(), middle, owners.end());
      if (!owners.empty()) owner = *middle;  // else that of the object before
      ++cuts[static_cast<std::size_t>(owner) + 1];
    }
    for (std::size_t r = 1; r < cuts.size(); ++r) cuts[r] += cuts[r - 1];
    cuts.pop_back();
    set.computed = Runs::at(set.size, cuts);
  }
}

void Partition::find_fields_that_name_parts() {
  for (DistributedSet& set : sets_) set.has_parts = set.kind == DistributedSet::Kind::owned;
  for (const Naming& naming : namings_) {
    DistributedSet& source = sets_[static_cast<std::size_t>(naming.source)];
    DistributedSet& target = sets_[static_cast<std::size_t>(naming.target)];
    const auto is_owned = [](const DistributedSet& set) { return set.kind == DistributedSet::Kind::owned; };
    if (source.kind == DistributedSet::Kind::entries) source.has_parts |= is_owned(target);
    if (target.kind == DistributedSet::Kind::entries) target.has_parts |= is_owned(source);
  }
  for (DistributedArray& array : arrays_) array.names_parts.assign(array.is_index.size(), 0);
  for (const Naming& naming : namings_) {
    const bool is_replicated = sets_[static_cast<std::size_t>(naming.source)].kind == DistributedSet::Kind::replicated;
    if (!is_replicated || !sets_[static_cast<std::size_t>(naming.target)].has_parts) continue;
    DistributedArray& array = arrays_[static_cast<std::size_t>(naming.array)];
    const UntypedArray untyped = array.untyped();
    for (std::size_t f = 0; f < untyped.fields.size(); ++f) {
      if (array.name + "." + std::string(untyped.fields[f].name) == naming.field) array.names_parts[f] = 1;
    }
  }
}

void Partition::find_ghosts() {
  const std::size_t count = sets_.size();
  std::vector<std::vector<bool>> is_here(count), is_done(count);
  std::vector<std::pair<std::size_t, index_t>> complete;  // objects whose named objects must be here
  const auto is_owned = [&](std::size_t s, index_t i) { return sets_[s].local->runs().owns(ranks_.rank(), i); };
  const auto add = [&](std::size_t s, index_t i) {
    if (is_done[s][static_cast<std::size_t>(i)]) return;
    is_done[s][static_cast<std::size_t>(i)] = true;
    complete.emplace_back(s, i);
  };
  std::vector<index_t> numbers;
  for (std::size_t s = 0; s < count; ++s) {
    if (sets_[s].kind != DistributedSet::Kind::owned) continue;
    is_here[s].resize(static_cast<std::size_t>(sets_[s].size));
    is_done[s].resize(static_cast<std::size_t>(sets_[s].size));
    const Runs& runs = sets_[s].local->runs();
    for (index_t i = runs.begin(ranks_.rank()); i < runs.end(ranks_.rank()); ++i) add(s, i);
  }
  for (const Connection& connection : connections_) {
    const auto s = static_cast<std::size_t>(connection.source);
    if (sets_[s].kind != DistributedSet::Kind::owned || sets_[s].follows != connection.target) continue;
    for (index_t i = 0; i < sets_[s].size; ++i) {
      numbers.clear();
      connection.named(i, numbers);
      const auto is_ours = [&](index_t number) {
        return number >= 0 && is_owned(static_cast<std::size_t>(connection.target), number);
      };
      if (!std::ranges::any_of(numbers, is_ours)) continue;
      is_here[s][static_cast<std::size_t>(i)] = true;
      add(s, i);
    }
  }
  for (std::size_t s = 0; s < count; ++s) {
    if (!sets_[s].computed) continue;
    const Runs& runs = *sets_[s].computed;
    for (index_t i = runs.begin(ranks_.rank()); i < runs.end(ranks_.rank()); ++i) complete.emplace_back(s, i);
  }
  while (!complete.empty()) {
    const auto [s, i] = complete.back();
    complete.pop_back();
    for (const Connection& connection : connections_) {
      if (static_cast<std::size_t>(connection.source) != s) continue;
      const auto t = static_cast<std::size_t>(connection.target);
      numbers.clear();
      connection.named(i, numbers);
      for (const index_t number : numbers) {
        require_object(sets_[t], number, i);
        if (number < 0 || sets_[t].kind != DistributedSet::Kind::owned) continue;
        is_here[t][static_cast<std::size_t>(number)] = true;
        if (sets_[t].follows >= 0) add(t, number);  // all that is here of such a set is computed here
      }
    }
  }
  for (std::size_t s = 0; s < count; ++s) {
    DistributedSet& set = sets_[s];
    if (set.kind != DistributedSet::Kind::owned) continue;
    std::vector<index_t> ghosts;
    for (index_t i = 0; i < set.size; ++i) {
      if (is_here[s][static_cast<std::size_t>(i)] && !is_owned(s, i)) ghosts.push_back(i);
    }
    set.local.emplace(Runs(set.local->runs()), ranks_.rank(), std::move(ghosts));
    const std::size_t all = set.local->ghosts().size();
    set.needs.push_back({make_halo_plan(*set.local, *transport_), std::vector<char>(all, 1), all_ghosts});
  }
}

bool Partition::is_complete(int set, index_t local, int target) const {
  const DistributedSet& of = sets_[static_cast<std::size_t>(set)];
  if (of.kind == DistributedSet::Kind::replicated) {
    while (sets_[static_cast<std::size_t>(target)].same_as >= 0)
      target = sets_[static_cast<std::size_t>(target)].same_as;
    const bool is_of_parts = sets_[static_cast<std::size_t>(target)].kind == DistributedSet::Kind::owned;
    return !is_of_parts || of.computed->owns(ranks_.rank(), local);
  }
  if (local < of.local->first() || local >= of.local->last()) return false;
  return of.follows >= 0 || (of.local->begin() <= local && local < of.local->end());
}

std::int32_t Partition::local_number(int set, index_t number, const std::string& of) const {
  const DistributedSet& target = sets_[static_cast<std::size_t>(set)];
  if (number < -1 || number >= target.size) {
    throw Error(of + " names object " + std::to_string(number) + " of set " + target.name + ", which has " +
                std::to_string(target.size) + "; name one of 0 .. size-1, or -1 for none");
  }
  return static_cast<std::int32_t>(number < 0 ? -1 : target.local->local(number));  // -1, too, where it is not here
}

}  // namespace physgen
