// See usage.h.
#include "usage/usage.h"

#include <algorithm>
#include <tuple>

namespace physgen::usage {
namespace {

void merge(std::vector<Place>& places, const std::vector<Place>& more) {
  places.insert(places.end(), more.begin(), more.end());
  std::ranges::sort(places);
  places.erase(std::ranges::unique(places).begin(), places.end());
}

void sort(std::vector<FieldUse>& uses) {
  std::ranges::sort(uses, [](const FieldUse& a, const FieldUse& b) {
    return std::tie(a.array, a.field) < std::tie(b.array, b.field);
  });
}

/// Adds kernels of the same step as it is compiled for another side.
void add(std::vector<KernelUse>& kernels, const std::vector<KernelUse>& more) {
  for (const KernelUse& kernel : more) {
    const auto same = std::ranges::find_if(kernels, [&](const KernelUse& known) {
      return known.name == kernel.name && known.views.arrays == kernel.views.arrays;
    });
    if (same == kernels.end()) {
      kernels.push_back(kernel);
    } else {
      for (const FieldUse& use : kernel.fields) usage::add(same->fields, use);
      same->calculated.insert(kernel.calculated.begin(), kernel.calculated.end());
    }
  }
}

auto key(const StepUse& step) { return std::tie(step.kernel, step.arrays, step.place, step.root); }

}  // namespace

void add(std::vector<FieldUse>& uses, const FieldUse& use) {
  const auto same = std::ranges::find_if(
      uses, [&](const FieldUse& known) { return known.array == use.array && known.field == use.field; });
  FieldUse& to = same != uses.end() ? *same : uses.emplace_back();
  to.array = use.array;
  to.field = use.field;
  to.read = to.read || use.read;
  to.written = to.written || use.written;
  to.address_taken = to.address_taken || use.address_taken;
  to.own = to.own || use.own;
  to.gathered = to.gathered || use.gathered;
  to.added = to.added || use.added;
  to.reads_own = to.reads_own || use.reads_own;
  to.reads_others = to.reads_others || use.reads_others;
  to.writes_own = to.writes_own || use.writes_own;
  to.writes_others = to.writes_others || use.writes_others;
  to.whole_object = to.whole_object || use.whole_object;
  merge(to.places, use.places);
  merge(to.read_places, use.read_places);
  merge(to.written_places, use.written_places);
  merge(to.whole_places, use.whole_places);
}

bool may_be_fused(const FieldUse& one, const FieldUse& other) {
  const auto writes = [](const FieldUse& use) { return use.written || use.address_taken; };
  const auto own = [](const FieldUse& use) { return use.own && !use.gathered && !use.added; };
  const auto adds = [](const FieldUse& use) { return use.added && !use.gathered && !use.own; };
  return (!writes(one) && !writes(other)) || (own(one) && own(other)) || (adds(one) && adds(other));
}

void sort(Usage& usage) {
  std::vector<StepUse> steps;
  for (const StepUse& step : usage.steps) {
    const auto same = std::ranges::find_if(steps, [&](const StepUse& known) { return key(known) == key(step); });
    if (same == steps.end()) {
      steps.push_back(step);
    } else {
      for (const FieldUse& use : step.fields) add(same->fields, use);
      add(same->kernels, step.kernels);
    }
  }
  for (StepUse& step : steps) {
    sort(step.fields);
    for (KernelUse& kernel : step.kernels) sort(kernel.fields);
  }
  std::ranges::sort(steps, [](const StepUse& a, const StepUse& b) { return key(a) < key(b); });
  usage.steps = std::move(steps);
  sort(usage.unattributed);
  std::ranges::sort(usage.unknown);
  usage.unknown.erase(std::ranges::unique(usage.unknown).begin(), usage.unknown.end());
  std::ranges::sort(usage.races);
  usage.races.erase(std::ranges::unique(usage.races).begin(), usage.races.end());
  std::ranges::sort(usage.dependences);
  usage.dependences.erase(std::ranges::unique(usage.dependences).begin(), usage.dependences.end());
}

Usage unite(const Usage& a, const Usage& b) {
  Usage result = a;
  result.steps.insert(result.steps.end(), b.steps.begin(), b.steps.end());
  for (const FieldUse& use : b.unattributed) add(result.unattributed, use);
  result.unknown.insert(result.unknown.end(), b.unknown.begin(), b.unknown.end());
  result.races.insert(result.races.end(), b.races.begin(), b.races.end());
  result.dependences.insert(result.dependences.end(), b.dependences.begin(), b.dependences.end());
  for (const EarlyRead& early : b.early_reads)
    if (std::ranges::find(result.early_reads, early) == result.early_reads.end()) result.early_reads.push_back(early);
  sort(result);
  return result;
}

std::vector<FieldUse> all_fields(const Usage& usage) {
  std::vector<FieldUse> result;
  for (const StepUse& step : usage.steps)
    for (const FieldUse& use : step.fields) add(result, use);
  for (const FieldUse& use : usage.unattributed) add(result, use);
  sort(result);
  return result;
}

std::string name_of(const StepUse& step) {
  constexpr std::size_t most = 8;
  std::string arrays;
  for (std::size_t a = 0; a < std::min(step.arrays.size(), most); ++a) arrays += (a == 0 ? "" : ", ") + step.arrays[a];
  if (step.arrays.size() > most) arrays += " and " + std::to_string(step.arrays.size() - most) + " more";
  return step.kernel + '(' + arrays + ')';
}

std::string text_of(const Race& race) {
  return race.writer + " writes " + race.array + "." + race.field + ", and " + race.other + " uses it at " +
         text_of(race.other_place) +
         " in the same fused kernel, one of them at other objects than its own: what it finds there depends on how "
         "threads run; take one of the two out of fuse(...)";
}

std::string text_of(const Dependence& dependence) {
  return "the program depends on how fields are stored (here " + dependence.what +
         "), so it would compute something else, or read other fields, where some are pruned; write what is the same "
         "for every format, or choose by a template parameter of the kernel";
}

std::string text_of(const Place& place) {
  return place.file + ':' + std::to_string(place.line) + ':' + std::to_string(place.column);
}

std::string short_text(const Place& place) {
  return text_of(Place{place.file.substr(place.file.rfind('/') + 1), place.line, place.column});
}

}  // namespace physgen::usage
