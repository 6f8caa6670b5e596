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

auto key(const StepUse& step) { return std::tie(step.kernel, step.arrays, step.place, step.root); }

}  // namespace

void add(std::vector<FieldUse>& uses, const FieldUse& use) {
  const auto same = std::ranges::find_if(
      uses, [&](const FieldUse& known) { return known.array == use.array && known.field == use.field; });
  FieldUse& to = same != uses.end() ? *same : uses.emplace_back(FieldUse{use.array, use.field, {}, {}, {}, {}, {}, {}});
  to.read = to.read || use.read;
  to.written = to.written || use.written;
  to.address_taken = to.address_taken || use.address_taken;
  to.whole_object = to.whole_object || use.whole_object;
  merge(to.places, use.places);
  merge(to.whole_places, use.whole_places);
}

void sort(Usage& usage) {
  std::vector<StepUse> steps;
  for (const StepUse& step : usage.steps) {
    const auto same = std::ranges::find_if(steps, [&](const StepUse& known) { return key(known) == key(step); });
    if (same == steps.end()) {
      steps.push_back(step);
    } else {
      for (const FieldUse& use : step.fields) add(same->fields, use);
    }
  }
  for (StepUse& step : steps) sort(step.fields);
  std::ranges::sort(steps, [](const StepUse& a, const StepUse& b) { return key(a) < key(b); });
  usage.steps = std::move(steps);
  sort(usage.unattributed);
  std::ranges::sort(usage.unknown);
  usage.unknown.erase(std::ranges::unique(usage.unknown).begin(), usage.unknown.end());
}

Usage unite(const Usage& a, const Usage& b) {
  Usage result = a;
  result.steps.insert(result.steps.end(), b.steps.begin(), b.steps.end());
  for (const FieldUse& use : b.unattributed) add(result.unattributed, use);
  result.unknown.insert(result.unknown.end(), b.unknown.begin(), b.unknown.end());
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

std::string text_of(const Place& place) {
  return place.file + ':' + std::to_string(place.line) + ':' + std::to_string(place.column);
}

std::string short_text(const Place& place) {
  return text_of({place.file.substr(place.file.rfind('/') + 1), place.line, place.column});
}

}  // namespace physgen::usage
