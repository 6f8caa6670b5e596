// What the kernels of a step use, by the table of halo_uses.h.
#include "step_uses.h"

#include <algorithm>

namespace physgen {

namespace {

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

void HaloSteps::add_gathered(Step& step, const Use& use, const std::vector<Use>& uses) const {
  const DistributedSet& over = arrays_.sets()[static_cast<std::size_t>(step.set)];
  if (names_parts(use.field)) {
    throw Error(use.kernel + (use.is_known ? " reads " : " may read ") + name_of(use.field) +
                " of other objects, which a rank has of those objects of set " + set_of_array(use.field.array).name +
                " alone that it computes; let a kernel over this set read it of its own objects");
  }
  if (set_of_array(use.field.array).kind != DistributedSet::Kind::owned) return;
  step.gathered[use.field] = {};
  arrays_.arrays()[static_cast<std::size_t>(use.field.array)].is_gathered[static_cast<std::size_t>(use.field.field)] =
      1;
  const auto& namings = arrays_.namings();
  const auto is_this = [&](const Partition::Naming& naming) {
    // Numbers of objects that all ranks have are those of ghosts, too.
    const DistributedSet& target = arrays_.sets()[static_cast<std::size_t>(naming.target)];
    return naming.field == name_of(use.field) && target.kind != DistributedSet::Kind::replicated;
  };
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
    const std::vector<const Partition::Naming*> meant = namings_of(use, through, uses);
    for (const Partition::Naming* const naming : meant) {
      if (reaches(step, *naming)) continue;
      throw Error(use.kernel + " reads " + name_of(use.field) + " through " + naming->field +
                  " of other objects, whose set follows no set, so that what they name may be on other ranks; let it "
                  "follow one");
    }
    is_found &= !meant.empty();
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
  if (naming.source == step.set || source.follows >= 0) return true;
  const DistributedSet& target = arrays_.sets()[static_cast<std::size_t>(naming.target)];
  if (source.kind == DistributedSet::Kind::replicated) return target.kind == DistributedSet::Kind::replicated;
  return source.kind != DistributedSet::Kind::owned;
}

HaloSteps::Step HaloSteps::resolve(std::span<const Kernel> kernels, index_t size) {
  const std::vector<Use> uses = uses_of(kernels);
  Step step;
  step.set = set_of(uses, size);
  if (step.set < 0) return step;
  const bool is_of_shared = arrays_.sets()[static_cast<std::size_t>(step.set)].kind == DistributedSet::Kind::replicated;
  step.is_gathered = is_of_shared && std::ranges::any_of(uses, [&](const Use& use) { return needs_parts(use); });
  for (const Use& use : uses) {
    if (is_of_shared && !step.is_gathered) break;
    check_writes(use, step.set);
    const bool is_own = arrays_.arrays()[static_cast<std::size_t>(use.field.array)].set == step.set;
    const bool is_of_parts = set_of_array(use.field.array).kind == DistributedSet::Kind::owned;
    if (!use.is_known) {
      add_gathered(step, use, uses);
      step.reaches_on_ghosts = step.is_known = false;
      if (is_own && is_of_parts && use.is_written) step.written.insert(use.field);
      continue;
    }
    if (use.access.reads_others) add_gathered(step, use, uses);
    if (use.access.reads_own && is_of_parts) {
      step.own.insert(use.field);
      // Ghosts of a set that follows none have neither rows nor numbers of what they name.
      const bool is_index = arrays_.arrays()[static_cast<std::size_t>(use.field.array)]
                                .is_index[static_cast<std::size_t>(use.field.field)] != 0;
      if (is_index && set_of_array(use.field.array).follows < 0) step.reaches_on_ghosts = false;
    }
    if (use.access.writes_own && (is_of_parts || step.is_gathered)) step.written.insert(use.field);
  }
  if (step.is_known) {
    find_needs(step, uses);
    return step;
  }
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
