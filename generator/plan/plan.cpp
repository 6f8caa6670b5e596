// See plan.h.
#include "plan/plan.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <tuple>

namespace physgen::plan {
namespace {

int align_up(int value, int step) { return (value + step - 1) / step * step; }

Bytes align_up(Bytes value, Bytes step) {
  return {align_up(value.with_float, step.with_float), align_up(value.with_double, step.with_double)};
}

Bytes max(Bytes a, Bytes b) { return {std::max(a.with_float, b.with_float), std::max(a.with_double, b.with_double)}; }

int entries(const model::Field& field) { return field.array_extent == 0 ? 1 : field.array_extent; }

void append_runs(const Record& record, Bytes base, std::vector<Step>& path, std::vector<Run>& all) {
  for (std::size_t f = 0; f < record.slots.size(); ++f) {
    const Slot& slot = record.slots[f];
    const model::Field& field = record.object->fields[f];
    path.push_back({&record, static_cast<int>(f)});
    if (slot.nested == nullptr) {
      all.push_back({path, base + slot.offset, entries(field) * model::element_count(field)});
    } else {
      for (int entry = 0; entry < entries(field); ++entry) {
        path.back().entry = field.array_extent == 0 ? -1 : entry;
        append_runs(*slot.nested, base + slot.offset + entry * slot.stride, path, all);
      }
    }
    path.pop_back();
  }
}

}  // namespace

Bytes element_bytes(model::Element element) {
  switch (element) {
    case model::Element::real:
      return {4, 8};
    case model::Element::float64:
      return {8, 8};
    case model::Element::index:
    case model::Element::int32:
    case model::Element::float32:
      break;
  }
  return {4, 4};
}

Record plan_record(const model::Object& object, const Lookup& lookup) {
  Record record;
  record.object = &object;
  std::vector<Bytes> alignments;
  for (const model::Field& field : object.fields) {
    Slot slot;
    if (field.shape == model::Shape::object) {
      slot.nested = &lookup(field.object);
      alignments.push_back(slot.nested->natural_alignment);
      slot.stride = align_up(slot.nested->bytes, slot.nested->natural_alignment);
    } else {
      alignments.push_back(element_bytes(field.element));
      slot.stride = model::element_count(field) * alignments.back();
    }
    record.slots.push_back(slot);
  }

  record.order.resize(record.slots.size());
  std::iota(record.order.begin(), record.order.end(), 0);
  const auto alignment_of = [&](int field) {
    const Bytes alignment = alignments[static_cast<std::size_t>(field)];
    return std::tuple(alignment.with_float, alignment.with_double);
  };
  std::stable_sort(record.order.begin(), record.order.end(),
                   [&](int a, int b) { return alignment_of(a) > alignment_of(b); });

  record.natural_alignment = {1, 1};
  for (const int f : record.order) {
    const auto field = static_cast<std::size_t>(f);
    record.slots[field].offset = align_up(record.bytes, alignments[field]);
    record.bytes = record.slots[field].offset + entries(object.fields[field]) * record.slots[field].stride;
    record.natural_alignment = max(record.natural_alignment, alignments[field]);
  }
  record.alignment = max(record.natural_alignment, {object.alignment, object.alignment});
  return record;
}

Records::Records(const model::Schema& schema) {
  const auto lookup = [this](const std::string& name) -> const Record& { return of(name); };
  for (const auto* objects : {&schema.imported, &schema.objects}) {
    for (const model::Object& object : *objects) records_.emplace(object.qualified_name(), plan_record(object, lookup));
  }
}

const Record& Records::of(const std::string& qualified_name) const {
  const auto found = records_.find(qualified_name);
  if (found == records_.end()) {
    throw std::invalid_argument("plan: object '" + qualified_name + "' is not declared before it is used");
  }
  return found->second;
}

std::string Run::name() const {
  std::string text;
  for (const Step& step : path) {
    if (!text.empty()) text += '.';
    text += step.declaration().name;
    if (step.entry >= 0) text += "[" + std::to_string(step.entry) + "]";
  }
  return text;
}

std::vector<Run> runs(const Record& record) {
  std::vector<Run> all;
  std::vector<Step> path;
  append_runs(record, {}, path, all);
  return all;
}

}  // namespace physgen::plan
