// Over which set a step runs.
#include <algorithm>

#include "step_uses.h"

namespace physgen {

int HaloSteps::set_of(const std::vector<Use>& uses, index_t size) {
  int found = -1;
  const Use* of_shared = nullptr;
  std::set<int> of_uniform;
  bool needs_those_of_ranks = false;
  bool may_be_of_uniform = false;
  const std::string kernels = names_of(uses);
  for (const Use& use : uses) {
    if (use.field.array < 0) continue;
    needs_those_of_ranks |= needs_parts(use);
    const bool is_own = use.access.reads_own || use.access.writes_own;
    if (set_of_array(use.field.array).kind == DistributedSet::Kind::replicated) {
      const int set = set_of_uniform(use);
      may_be_of_uniform |= set >= 0 && !use.is_known;
      if (is_own && set >= 0) of_uniform.insert(set);
      if (is_own && set < 0) of_shared = &use;
      continue;
    }
    if (!is_own) continue;
    const int set = arrays_.arrays()[static_cast<std::size_t>(use.field.array)].set;
    if (found >= 0 && found != set) refuse_two_sets(kernels, found, set);
    found = set;
  }
  if (found >= 0 && of_shared != nullptr) {
    refuse_two_sets(kernels, found, arrays_.arrays()[static_cast<std::size_t>(of_shared->field.array)].set);
  }
  if (found >= 0) return found;
  if (of_shared != nullptr) return needs_those_of_ranks ? set_that_is_gathered(uses) : -1;
  if (of_uniform.size() == 1 && !may_be_of_uniform) return *of_uniform.begin();
  if (!needs_those_of_ranks && of_uniform.empty() && !may_be_of_uniform) return -1;
  return set_of_all_ranks(uses, size, needs_those_of_ranks);
}

void HaloSteps::refuse_two_sets(const std::string& kernels, int one, int other) const {
  throw Error(kernels + " uses own objects of two sets, " + arrays_.sets()[static_cast<std::size_t>(one)].name +
              " and " + arrays_.sets()[static_cast<std::size_t>(other)].name +
              "; correct its rows in the table of kernels, or say same_set() where they have the same objects");
}

int HaloSteps::set_that_is_gathered(const std::vector<Use>& uses) const {
  const Use* own = nullptr;
  for (const Use& use : uses) {
    const bool is_own = use.access.reads_own || use.access.writes_own;
    if (use.field.array < 0 || !is_own || set_of_uniform(use) >= 0) continue;
    const int set = arrays_.arrays()[static_cast<std::size_t>(use.field.array)].set;
    if (own == nullptr) own = &use;
    const int first = arrays_.arrays()[static_cast<std::size_t>(own->field.array)].set;
    if (set != first) refuse_two_sets(names_of(uses), first, set);
  }
  const int set = arrays_.arrays()[static_cast<std::size_t>(own->field.array)].set;
  if (const auto of_parts = std::ranges::find_if(uses, [&](const Use& use) { return needs_parts(use); });
      !arrays_.sets()[static_cast<std::size_t>(set)].computed) {
    throw Error(names_of(uses) + " runs over the objects of " + array_name(*own) + ", which all ranks have, and uses " +
                array_name(*of_parts) + ", of which ranks have parts of set " +
                set_of_array(of_parts->field.array).name + "; connect an index field of set " +
                set_of_array(own->field.array).name + " by which it finds these, or reduce what is wanted of them");
  }
  for (const Use& use : uses) {
    if (!use.is_known) refuse_unknown(names_of(uses), set);
  }
  return set;
}

void HaloSteps::refuse_unknown(const std::string& kernels, int set) const {
  throw Error(kernels + " runs over the objects of set " + arrays_.sets()[static_cast<std::size_t>(set)].name +
              ", which all ranks have, and uses others of which ranks have parts; give all its views rows in the table "
              "of kernels");
}

const std::string& HaloSteps::array_name(const Use& use) const {
  return arrays_.arrays()[static_cast<std::size_t>(use.field.array)].name;
}

bool HaloSteps::names_parts(const Field& field) const {
  const DistributedArray& array = arrays_.arrays()[static_cast<std::size_t>(field.array)];
  return array.names_parts[static_cast<std::size_t>(field.field)] != 0;
}

bool HaloSteps::needs_parts(const Use& use) const {
  if (use.field.array < 0) return false;
  return set_of_array(use.field.array).has_parts || names_parts(use.field);
}

int HaloSteps::set_of_uniform(const Use& use) const {
  const int set = arrays_.arrays()[static_cast<std::size_t>(use.field.array)].uniform_of;
  if (set < 0 || arrays_.sets()[static_cast<std::size_t>(set)].kind != DistributedSet::Kind::owned) return -1;
  return set;
}

void HaloSteps::require_size_of_all_ranks(std::span<const Kernel> kernels, index_t size, Way way,
                                          bool is_of_window) const {
  bool has_views = false;
  for (const Kernel& kernel : kernels) {
    for (const KernelView& view : kernel.views) {
      const int array = view.base == nullptr ? -1 : arrays_.find(view.base);
      if (view.base == nullptr || (array >= 0 && set_of_array(array).kind != DistributedSet::Kind::replicated))
        continue;
      has_views = true;
      const index_t all = array < 0 ? view.size : set_of_array(array).size;
      if (is_of_window && way == Way::run ? size <= all : size == all) return;
    }
  }
  if (!has_views && way != Way::reduce) return;  // it leaves nothing
  throw Error(
      "it is not known over which set " + *kernels.front().name + " is run: the size " + std::to_string(size) +
      " is that of no array that it uses and all ranks have; let it read its own object of an array that has so "
      "many, array.size()");
}

int HaloSteps::set_of_all_ranks(const std::vector<Use>& uses, index_t size, bool has_parts) {
  // Sizes of two sets may be equal on one rank, and not on another.
  std::vector<index_t> fits(arrays_.sets().size(), 0);
  for (const Use& use : uses) {
    if (use.field.array < 0) continue;
    for (const int set : {arrays_.arrays()[static_cast<std::size_t>(use.field.array)].set, set_of_uniform(use)}) {
      if (set < 0) continue;
      const DistributedSet& one = arrays_.sets()[static_cast<std::size_t>(set)];
      const bool may_be = one.kind == DistributedSet::Kind::owned ||
                          (one.kind == DistributedSet::Kind::replicated && (!has_parts || one.computed));
      if (may_be && one.local->size() == size) fits[static_cast<std::size_t>(set)] = 1;
    }
  }
  const auto ranks = static_cast<std::size_t>(arrays_.ranks().count());
  const std::vector<index_t> sizes(ranks, static_cast<index_t>(fits.size() * sizeof(index_t)));
  std::vector<index_t> of_all(fits.size() * ranks, 0);
  arrays_.transport().gather(std::as_bytes(std::span(fits)), sizes, std::as_writable_bytes(std::span(of_all)));
  std::vector<int> found;
  for (std::size_t s = 0; s < fits.size(); ++s) {
    bool everywhere = true;
    for (std::size_t r = 0; r < ranks; ++r) everywhere &= of_all[r * fits.size() + s] != 0;
    if (everywhere) found.push_back(static_cast<int>(s));
  }
  if (found.size() == 1) {
    const bool is_shared =
        arrays_.sets()[static_cast<std::size_t>(found.front())].kind == DistributedSet::Kind::replicated;
    if (is_shared && has_parts) refuse_unknown(names_of(uses), found.front());
    return found.front();
  }
  throw Error("it is not known over which set " + names_of(uses) + " is run: the size " + std::to_string(size) +
              " is that of " + std::to_string(found.size()) +
              " sets of its views; give it rows in the table of kernels");
}

}  // namespace physgen
