// Which ghosts a step needs of a field, and what it leaves fresh.
#include <algorithm>

#include "step_uses.h"

namespace physgen {

std::vector<const Partition::Naming*> HaloSteps::namings_of(const Use& use, std::string_view through,
                                                            const std::vector<Use>& uses) const {
  // "level.edges.nodes" means level[0].edges.nodes and level[1].edges.nodes, of such arrays as the kernel has views of,
  // or that name objects of the array that it reads.
  const int set = arrays_.arrays()[static_cast<std::size_t>(use.field.array)].set;
  std::vector<const Partition::Naming*> found;
  for (const Partition::Naming& naming : arrays_.namings()) {
    const auto is_viewed = [&](const Use& other) { return other.field.array == naming.array; };
    const bool is_meant = naming.target == set || std::ranges::any_of(uses, is_viewed);
    if (naming.field == through || (is_meant && is_named(naming.field, through))) found.push_back(&naming);
  }
  return found;
}

void HaloSteps::find_needs(Step& step, const std::vector<Use>& uses) const {
  if (!step.is_known) return;  // all ghosts
  std::set<int> followed;
  std::map<Field, std::set<int>> last;
  std::vector<const Partition::Naming*> read;
  for (const Use& use : uses) {
    if (use.field.array < 0) continue;
    const DistributedArray& array = arrays_.arrays()[static_cast<std::size_t>(use.field.array)];
    for (const Partition::Naming& naming : arrays_.namings()) {
      const bool is_read = naming.array == use.field.array && naming.field == name_of(use.field);
      if (is_read && naming.connection >= 0) read.push_back(&naming);
    }
    for (const std::string& through : use.through) {
      for (const Partition::Naming* const naming : namings_of(use, through, uses)) {
        if (naming->connection < 0) continue;
        followed.insert(naming->connection);
        if (naming->target == array.set) last[use.field].insert(naming->connection);
      }
    }
  }
  // Rows say which arrays a program has given to the kernel. It may have swapped these since, or give others: what the
  // step reads of indices leads to all objects that they name.
  for (const Partition::Naming* const naming : read) followed.insert(naming->connection);
  const bool may_be_of_ghosts = step.reaches_on_ghosts && !step.written.empty();
  for (auto& [field, need] : step.gathered) {
    const int set = arrays_.arrays()[static_cast<std::size_t>(field.array)].set;
    for (const Partition::Naming* const naming : read) {
      if (naming->target == set) last[field].insert(naming->connection);
    }
    HaloPath path{step.set, false, {followed.begin(), followed.end()}, {last[field].begin(), last[field].end()}};
    need.of_owned = arrays_.need_of(path);
    if (!may_be_of_ghosts || step.own.contains(field)) continue;  // what it reads of its own is of all ghosts
    path.is_of_ghosts = true;
    need.of_ghosts = arrays_.need_of(path);
  }
}

HaloNeedBits& HaloSteps::fresh(const Field& field) const {
  return arrays_.arrays()[static_cast<std::size_t>(field.array)].fresh[static_cast<std::size_t>(field.field)];
}

HaloNeedBits& HaloSteps::also(const Field& field) const {
  return arrays_.arrays()[static_cast<std::size_t>(field.array)].also[static_cast<std::size_t>(field.field)];
}

bool HaloSteps::can_be_of_ghosts(const Step& step) const {
  if (!step.reaches_on_ghosts) return false;
  bool is_in_part = false;
  for (const Field& field : step.own) {
    if (step.gathered.contains(field)) continue;
    if (fresh(field) == 0) return false;
    is_in_part |= fresh(field) != all_ghosts;
  }
  // What was stale before stays so. To cross to all ghosts is of use where what is written need not cross for it.
  return std::ranges::any_of(step.written, [&](const Field& field) {
    const DistributedArray& array = arrays_.arrays()[static_cast<std::size_t>(field.array)];
    const bool is_gathered = array.is_gathered[static_cast<std::size_t>(field.field)] != 0;
    return step.gathered.contains(field) || (fresh(field) != 0 && (is_gathered || !is_in_part));
  });
}

std::vector<HaloFetch> HaloSteps::stale_of(const Step& step) {
  std::vector<HaloFetch> stale;
  const auto add = [&](const Field& field, int need) {
    const HaloNeedBits wanted = HaloNeedBits{1} << need;
    if ((fresh(field) & wanted) != 0) return;
    const DistributedArray& array = arrays_.arrays()[static_cast<std::size_t>(field.array)];
    if (array.window > 0) throw Error(name_of(field) + " of a window is stale, and windows never cross");
    const int set = array.set;
    stale.push_back({field, arrays_.need_of(set, also(field) | wanted)});
    // It crosses a second time since it was written; the next time all of that crosses at once.
    if (fresh(field) != 0) also(field) |= fresh(field) | wanted;
  };
  for (const auto& [field, needs] : step.gathered) add(field, on_ghosts_ ? needs.of_ghosts : needs.of_owned);
  for (const Field& field : step.own) {
    if (on_ghosts_ && !step.gathered.contains(field)) add(field, 0);
  }
  return stale;
}

void HaloSteps::begin_exchange(const std::vector<HaloFetch>& fetches) {
  crossing_ = 0;
  for (const HaloFetch& fetch : fetches) {
    const int set = arrays_.arrays()[static_cast<std::size_t>(fetch.field.array)].set;
    const HaloNeed& need = arrays_.sets()[static_cast<std::size_t>(set)].needs[static_cast<std::size_t>(fetch.need)];
    fresh(fetch.field) |= need.within;
    crossing_ |= std::uint64_t{1} << (set % 64);
    // What a program has changed, as it has told the arrays, is not poisoned yet.
    if (poisons_ && fresh(fetch.field) != all_ghosts) exchange_->poison(fetch.field, fresh(fetch.field));
  }
  exchange_->begin(fetches);
}

void HaloSteps::end() {
  const Step* const step = std::exchange(current_, nullptr);
  if (step == nullptr || step->set < 0) return;
  if (step->is_gathered) {
    const std::vector<Field> written(step->written.begin(), step->written.end());
    return exchange_->gather(written, *arrays_.sets()[static_cast<std::size_t>(step->set)].computed);
  }
  if (arrays_.sets()[static_cast<std::size_t>(step->set)].kind != DistributedSet::Kind::owned) return;
  for (const Field& field : step->written) {
    // A step may write some objects of the field, or some of its elements: of ghosts the others stay as they were.
    if (!on_ghosts_) fresh(field) = 0;
    if (poisons_ && fresh(field) != all_ghosts) exchange_->poison(field, fresh(field));
  }
}

}  // namespace physgen
