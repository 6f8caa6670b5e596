// What the kernels of a step use, by the table of halo_uses.h; and over which set they run.
#include "step_uses.h"

#include <algorithm>
#include <bit>

namespace physgen {

namespace {

/// Whether a field is meant by a name: "points.x" means that of all entries, "points[0].x".
bool is_named(std::string_view field, std::string_view name) {
  while (!field.empty() && !name.empty() && field.front() == name.front()) {
    field.remove_prefix(1);
    name.remove_prefix(1);
    if (field.starts_with('[')) field.remove_prefix(field.find(']') + 1);
  }
  return field.empty() && name.empty();
}

/// The names of a list "a, b"; an empty one is one name, which nothing has.
void add_names(std::vector<std::string>& names, std::string_view list) {
  for (std::size_t at = 0; at <= list.size();) {
    const std::size_t end = std::min(list.find(", ", at), list.size());
    names.emplace_back(list.substr(at, end - at));
    at = end + 2;
  }
}

void unite(HaloAccess& access, const HaloAccess& other) {
  access.reads_own |= other.reads_own;
  access.reads_others |= other.reads_others;
  access.writes_own |= other.writes_own;
  access.writes_others |= other.writes_others;
}

}  // namespace

std::string HaloSteps::names_of(const std::vector<Use>& uses) {
  std::string names;
  for (const Use& use : uses) {
    if (names.find(use.kernel) == std::string::npos) names += (names.empty() ? "" : ", ") + use.kernel;
  }
  return names;
}

bool HaloSteps::may_write(const std::string& kernel, int view) const {
  bool is_known = false;
  for (const HaloUse& row : arrays_.uses()) {
    if (row.kernel != kernel || row.view != view) continue;
    if (row.access.writes_own || row.access.writes_others) return true;
    is_known = true;
  }
  return !is_known;
}

std::vector<HaloSteps::Use> HaloSteps::uses_of(std::span<const Kernel> kernels) {
  std::vector<Use> uses;
  for (const Kernel& kernel : kernels) {
    for (std::size_t v = 0; v < kernel.views.size(); ++v) {
      const KernelView& view = kernel.views[v];
      if (view.base == nullptr) continue;  // nothing is stored
      const int array = arrays_.find(view.base);
      if (array < 0) {
        if (view.size == 1) {  // numbers that all ranks keep
          if (view.is_written && may_write(*kernel.name, static_cast<int>(v)))
            uses.push_back({*kernel.name, {-1, 0}, true, true, {}, {}});
          continue;
        }
        throw Error(*kernel.name + " uses an array of " + std::to_string(view.size) + " " + std::string(view.object) +
                    " that is none of the distributed arrays; add() it before cut()");
      }
      const auto is_row = [&](const HaloUse& use) {
        return use.kernel == *kernel.name && use.view == static_cast<int>(v);
      };
      const bool is_known = std::ranges::any_of(arrays_.uses(), is_row);
      if (!is_known) unknown_.insert(*kernel.name);
      const UntypedArray& memory = arrays_.arrays()[static_cast<std::size_t>(array)].memory;
      for (std::size_t f = 0; f < memory.fields.size(); ++f) {
        Use use{*kernel.name, {array, static_cast<int>(f)}, is_known, view.is_written, {}, {}};
        for (const HaloUse& row : arrays_.uses()) {
          if (!is_row(row) || !is_named(memory.fields[f].name, row.field)) continue;
          unite(use.access, row.access);
          if (row.access.reads_others) add_names(use.through, row.through);
        }
        if (!is_known || use.access != HaloAccess{}) uses.push_back(std::move(use));
      }
    }
  }
  return uses;
}

int HaloSteps::set_of(const std::vector<Use>& uses, index_t size) {
  int found = -1;
  const Use *of_parts = nullptr, *of_shared = nullptr;
  std::set<int> of_uniform;
  bool may_be_of_uniform = false;
  const std::string kernels = names_of(uses);
  for (const Use& use : uses) {
    if (use.field.array < 0) continue;
    const bool is_own = use.access.reads_own || use.access.writes_own;
    if (set_of_array(use.field.array).kind == DistributedSet::Kind::replicated) {
      const int set = set_of_uniform(use);
      may_be_of_uniform |= set >= 0 && !use.is_known;
      if (is_own && set >= 0) of_uniform.insert(set);
      if (is_own && set < 0) of_shared = &use;
      continue;
    }
    of_parts = &use;
    if (!is_own) continue;
    const int set = arrays_.arrays()[static_cast<std::size_t>(use.field.array)].set;
    if (found >= 0 && found != set) {
      throw Error(kernels + " uses own objects of two sets, " + arrays_.sets()[static_cast<std::size_t>(found)].name +
                  " and " + arrays_.sets()[static_cast<std::size_t>(set)].name +
                  "; correct its rows in the table of kernels, or say same_set() where they have the same objects");
    }
    found = set;
  }
  if (found >= 0 || (of_shared != nullptr && of_parts == nullptr)) return found;
  if (of_shared != nullptr) {
    throw Error(
        kernels + " runs over the objects of " +
        arrays_.arrays()[static_cast<std::size_t>(of_shared->field.array)].name + ", which all ranks have, and uses " +
        arrays_.arrays()[static_cast<std::size_t>(of_parts->field.array)].name + ", of which ranks have parts of set " +
        set_of_array(of_parts->field.array).name + "; reduce what is wanted of it");
  }
  if (of_uniform.size() == 1 && !may_be_of_uniform) return *of_uniform.begin();
  if (of_parts == nullptr && of_uniform.empty() && !may_be_of_uniform) return -1;
  return set_of_all_ranks(uses, size, of_parts != nullptr);
}

int HaloSteps::set_of_uniform(const Use& use) const {
  const int set = arrays_.arrays()[static_cast<std::size_t>(use.field.array)].uniform_of;
  if (set < 0 || arrays_.sets()[static_cast<std::size_t>(set)].kind != DistributedSet::Kind::owned) return -1;
  return set;
}

void HaloSteps::require_size_of_all_ranks(std::span<const Kernel> kernels, index_t size, Way way) const {
  bool has_views = false;
  for (const Kernel& kernel : kernels) {
    for (const KernelView& view : kernel.views) {
      const int array = view.base == nullptr ? -1 : arrays_.find(view.base);
      if (view.base == nullptr || (array >= 0 && set_of_array(array).kind != DistributedSet::Kind::replicated))
        continue;
      has_views = true;
      if (size == (array < 0 ? view.size : set_of_array(array).size)) return;
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
      const bool may_be =
          one.kind == DistributedSet::Kind::owned || (!has_parts && one.kind == DistributedSet::Kind::replicated);
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
  if (found.size() == 1) return found.front();
  throw Error("it is not known over which set " + names_of(uses) + " is run: the size " + std::to_string(size) +
              " is that of " + std::to_string(found.size()) +
              " sets of its views; give it rows in the table of kernels");
}

void HaloSteps::check_writes(const Use& use, int set) const {
  if (use.field.array < 0) {
    throw Error(use.kernel +
                " may write numbers that all ranks keep, in a step of which each rank does a part; reduce "
                "instead, or give the kernel a const_view() or rows in the table of kernels");
  }
  const DistributedSet& of_array = set_of_array(use.field.array);
  const bool is_own = arrays_.arrays()[static_cast<std::size_t>(use.field.array)].set == set;
  const bool is_shared = of_array.kind == DistributedSet::Kind::replicated;
  const bool writes_others = use.access.writes_others || (use.access.writes_own && !is_own);
  const std::string what = use.kernel + " writes " + name_of(use.field);
  if (writes_others || (!use.is_known && use.is_written && !is_own)) {
    throw Error(what + " of other objects than that of its call, " +
                (is_shared ? "which all ranks have: they would differ; reduce instead"
                           : "which another rank may own; gather over rows instead") +
                (use.is_known ? "" : ", or give the kernel a const_view() or rows in the table of kernels"));
  }
  const bool writes = use.is_known ? use.access.writes_own : use.is_written;
  const DistributedArray& array = arrays_.arrays()[static_cast<std::size_t>(use.field.array)];
  if (writes && array.is_index[static_cast<std::size_t>(use.field.field)] != 0) {
    throw Error(what + ", which names objects by the numbers of this rank; connect other arrays instead" +
                (use.is_known ? "" : ", or give the kernel a const_view() or rows in the table of kernels"));
  }
}

void HaloSteps::add_gathered(Step& step, const Use& use) const {
  const DistributedSet& over = arrays_.sets()[static_cast<std::size_t>(step.set)];
  if (set_of_array(use.field.array).kind != DistributedSet::Kind::owned) return;
  step.gathered.insert(use.field);
  const auto& namings = arrays_.namings();
  const auto is_this = [&](const Partition::Naming& naming) { return naming.field == name_of(use.field); };
  const auto indices = std::ranges::find_if(namings, is_this);
  if (use.is_known && indices != namings.end()) {
    const DistributedSet& source = arrays_.sets()[static_cast<std::size_t>(indices->source)];
    if (source.kind == DistributedSet::Kind::owned && source.follows < 0) {
      throw Error(use.kernel + " reads " + indices->field + " of other objects, whose set " + source.name +
                  " follows no set, so that ranks have neither their rows nor all that they name; let it follow one");
    }
  }
  // Of the objects that are computed here, all that they name is here. What those name in turn is not, unless they are
  // computed here, too.
  bool is_found = !use.through.empty();
  for (const std::string& through : use.through) {
    const auto naming = std::ranges::find(namings, through, &Partition::Naming::field);
    is_found &= naming != namings.end();
    if (naming != namings.end() && !reaches(step, *naming)) {
      throw Error(use.kernel + " reads " + name_of(use.field) + " through " + naming->field +
                  " of other objects, whose set follows no set, so that what they name may be on other ranks; let it "
                  "follow one");
    }
  }
  if (use.is_known && !is_found) {
    throw Error(use.kernel + " reads " + name_of(use.field) +
                " of other objects by numbers that no connected index field has, and which of them are on this rank is "
                "not known; let an index field name them, and connect() it");
  }
  step.reaches_on_ghosts &= is_found && over.follows >= 0;
  step.is_known &= is_found;
}

bool HaloSteps::reaches(const Step& step, const Partition::Naming& naming) const {
  const DistributedSet& source = arrays_.sets()[static_cast<std::size_t>(naming.source)];
  return naming.source == step.set || source.follows >= 0 || source.kind != DistributedSet::Kind::owned;
}

HaloSteps::Step HaloSteps::resolve(std::span<const Kernel> kernels, index_t size) {
  const std::vector<Use> uses = uses_of(kernels);
  Step step;
  step.set = set_of(uses, size);
  if (step.set < 0) return step;
  const bool is_of_shared = arrays_.sets()[static_cast<std::size_t>(step.set)].kind == DistributedSet::Kind::replicated;
  for (const Use& use : uses) {
    if (is_of_shared) break;
    check_writes(use, step.set);
    const bool is_own = arrays_.arrays()[static_cast<std::size_t>(use.field.array)].set == step.set;
    const bool is_of_parts = set_of_array(use.field.array).kind == DistributedSet::Kind::owned;
    if (!use.is_known) {
      add_gathered(step, use);
      step.reaches_on_ghosts = step.is_known = false;
      if (is_own && is_of_parts && use.is_written) step.written.insert(use.field);
      continue;
    }
    if (use.access.reads_others) add_gathered(step, use);
    if (use.access.reads_own && is_of_parts) {
      step.own.insert(use.field);
      // Ghosts of a set that follows none have neither rows nor numbers of what they name.
      const bool is_index = arrays_.arrays()[static_cast<std::size_t>(use.field.array)]
                                .is_index[static_cast<std::size_t>(use.field.field)] != 0;
      if (is_index && set_of_array(use.field.array).follows < 0) step.reaches_on_ghosts = false;
    }
    if (use.access.writes_own && is_of_parts) step.written.insert(use.field);
  }
  if (step.is_known) return step;
  for (const Partition::Naming& naming : arrays_.namings()) {
    // A kernel of which the table does not say it may follow the indices of all its views.
    const bool is_there = std::ranges::any_of(uses, [&](const Use& use) { return name_of(use.field) == naming.field; });
    if (!is_there || reaches(step, naming)) continue;
    throw Error(uses.front().kernel + " may read through " + naming.field +
                " of other objects, whose set follows no set, so that what they name may be on other ranks; give the "
                "kernel rows in the table of kernels, or let the set follow one");
  }
  return step;
}

}  // namespace physgen
