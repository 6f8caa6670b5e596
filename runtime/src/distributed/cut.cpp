// What each rank has of the sets: the ghosts that the objects name which it computes.
#include <physgen/distributed/partition.h>

#include <algorithm>
#include <iterator>
#include <ranges>
#include <utility>

#include "named_batches.h"
#include "require_object.h"

namespace physgen {

void Partition::cut(const std::function<void()>& behind_names) {
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

  for (Connection& connection : connections_) {
    connection.named.keep_bounds(sets_[static_cast<std::size_t>(connection.source)].size);
  }
  const std::vector<ObjectRuns> touching = decide_runs();
  decide_computed();
  find_ghosts(touching);
  for (DistributedSet& set : sets_) {  // what was connected by the other name asks it for local numbers
    if (set.same_as >= 0) set.local = sets_[static_cast<std::size_t>(number_of(set.name))].local;
  }
  find_reached();
  find_fields_that_name_parts();
  is_cut_ = true;
  const auto resize = [&](bool those_that_name) {
    for (DistributedArray& array : arrays_) {
      const DistributedSet& set = sets_[static_cast<std::size_t>(array.set)];
      const bool names = std::ranges::count(array.is_index, 1) > 0;
      if (names != those_that_name || set.kind == DistributedSet::Kind::entries) continue;
      const index_t size = set.local ? set.local->size() : set.size;
      array.resize(array.window > 0 ? std::min(array.window, size) : size);
    }
  };
  resize(true);
  for (std::size_t c = 0; c < connections_.size(); ++c) {
    if (connections_[c].store) connections_[c].store(c);
    connections_[c].store = {};
  }
  for (Connection& connection : connections_) connection.named = {};
  if (behind_names) behind_names();
  resize(false);
  for (DistributedArray& array : arrays_) array.memory = array.untyped();
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

void Partition::find_ghosts(const std::vector<ObjectRuns>& touching) {
  const std::size_t count = sets_.size();
  // Of each set: objects of others that are here, and objects of which all that they name must be here.
  std::vector<std::vector<index_t>> ghosts(count);
  std::vector<ObjectRuns> complete(count);
  const auto run_of = [&](std::size_t s) -> const Runs* {
    if (sets_[s].kind == DistributedSet::Kind::owned) return &sets_[s].local->runs();
    return sets_[s].computed ? &*sets_[s].computed : nullptr;
  };
  const int rank = ranks_.rank();
  for (std::size_t s = 0; s < count; ++s) {
    const Runs* const runs = run_of(s);
    if (runs == nullptr) continue;
    const index_t begin = runs->begin(rank), end = runs->end(rank);
    const auto add = [&](index_t from, index_t to) {  // of touching objects, those in a range
      for (const ObjectRuns::Run& run : touching[s].runs) {
        const index_t first = std::max(run.first, from), last = std::min(run.first + run.count, to);
        complete[s].add(first, last - first);
        for (index_t i = first; i < last; ++i) ghosts[s].push_back(i);
      }
    };
    add(0, begin);
    complete[s].add(begin, end - begin);
    add(end, runs->size());
  }
  while (std::ranges::any_of(complete, [](const ObjectRuns& objects) { return objects.count > 0; })) {
    std::vector<std::vector<index_t>> found(count);
    for (std::size_t c = 0; c < connections_.size(); ++c) {
      const auto t = static_cast<std::size_t>(connections_[c].target);
      if (sets_[t].kind != DistributedSet::Kind::owned) continue;
      add_named_of_others(c, complete[static_cast<std::size_t>(connections_[c].source)], found[t]);
    }
    for (std::size_t s = 0; s < count; ++s) {
      detail::sort_once(found[s]);
      complete[s] = {};
      std::vector<index_t> added, all;
      std::ranges::set_difference(found[s], ghosts[s], std::back_inserter(added));
      std::ranges::set_union(found[s], ghosts[s], std::back_inserter(all));
      ghosts[s] = std::move(all);
      if (sets_[s].follows < 0) continue;
      for (const index_t object : added) complete[s].add(object);  // all that is here of others is computed here
    }
  }
  for (std::size_t s = 0; s < count; ++s) {
    DistributedSet& set = sets_[s];
    if (set.kind != DistributedSet::Kind::owned) continue;
    set.local.emplace(Runs(set.local->runs()), rank, std::move(ghosts[s]));
    const std::size_t all = set.local->ghosts().size();
    set.needs.push_back({make_halo_plan(*set.local, *transport_), std::vector<char>(all, 1), all_ghosts});
  }
}

void Partition::add_named_of_others(std::size_t connection, const ObjectRuns& objects,
                                    std::vector<index_t>& others) const {
  const Connection& by = connections_[connection];
  const DistributedSet& target = sets_[static_cast<std::size_t>(by.target)];
  const Runs& runs = target.local->runs();
  const std::vector<detail::ObjectPiece> pieces = detail::pieces_of(objects);
  std::vector<std::vector<index_t>> found(pieces.size());
  detail::each_named(
      {&by.named}, pieces, [&](std::size_t p) { return owns_named(connection, pieces[p]); },
      [&](const detail::NamedBatch& batch) {
        std::vector<index_t>& of_batch = found[batch.number];
        for (std::size_t k = 0; k < batch.size(); ++k) {
          for (const index_t number : batch.numbers.front().of(k)) {
            detail::require_object(target, number, batch.object(k));
            if (number >= 0 && !runs.owns(ranks_.rank(), number)) of_batch.push_back(number);
          }
        }
        detail::sort_once(of_batch);
      });
  for (const std::vector<index_t>& of_piece : found) others.insert(others.end(), of_piece.begin(), of_piece.end());
}

std::vector<detail::ObjectPiece> Partition::pieces(int set, index_t first, index_t last) const {
  const LocalSet& local = *sets_[static_cast<std::size_t>(set)].local;
  ObjectRuns objects;
  for (index_t i = first; i < std::min(last, local.begin()); ++i) objects.add(local.global(i));
  const index_t begin = std::max(first, local.begin()), end = std::min(last, local.end());
  if (begin < end) objects.add(local.global(begin), end - begin);
  for (index_t i = std::max(first, local.end()); i < last; ++i) objects.add(local.global(i));
  return detail::pieces_of(objects);
}

bool Partition::owns_named(std::size_t connection, const detail::ObjectPiece& piece) const {
  const detail::NamedBounds bounds = connections_[connection].named.bounds_of(piece);
  const LocalSet& target = *sets_[static_cast<std::size_t>(connections_[connection].target)].local;
  const index_t begin = target.runs().begin(target.rank()), end = target.runs().end(target.rank());
  return bounds.are_none() || (begin <= bounds.low && bounds.high < end);
}

index_t Partition::below_local(std::size_t connection) const {
  const LocalSet& target = *sets_[static_cast<std::size_t>(connections_[connection].target)].local;
  return target.runs().begin(target.rank()) - target.begin();
}

std::pair<index_t, index_t> Partition::complete(int set, int target) const {
  const DistributedSet& of = sets_[static_cast<std::size_t>(set)];
  const LocalSet& local = *of.local;
  if (of.kind == DistributedSet::Kind::replicated) {
    while (sets_[static_cast<std::size_t>(target)].same_as >= 0)
      target = sets_[static_cast<std::size_t>(target)].same_as;
    const bool is_of_parts = sets_[static_cast<std::size_t>(target)].kind == DistributedSet::Kind::owned;
    if (is_of_parts) return {of.computed->begin(ranks_.rank()), of.computed->end(ranks_.rank())};
    return {local.first(), local.last()};
  }
  return of.follows >= 0 ? std::pair{local.first(), local.last()} : std::pair{local.begin(), local.end()};
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
