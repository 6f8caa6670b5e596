// See plan.h.
#include "plan/plan.h"

#include <algorithm>
#include <stdexcept>

namespace physgen::plan {
namespace {

Bytes align_up(Bytes value, Bytes step) {
  return {model::align_up(value.with_float, step.with_float), model::align_up(value.with_double, step.with_double)};
}

Bytes max(Bytes a, Bytes b) { return {std::max(a.with_float, b.with_float), std::max(a.with_double, b.with_double)}; }

int entries(const model::Field& field) { return field.array_extent == 0 ? 1 : field.array_extent; }

void append_runs(const Record& record, Bytes base, std::vector<Step>& path, std::vector<Run>& all) {
  for (std::size_t f = 0; f < record.slots.size(); ++f) {
    const Slot& slot = record.slots[f];
    const model::Field& field = record.object->fields[f];
    path.push_back({&record, static_cast<int>(f)});
    if (slot.nested == nullptr) {
      all.push_back({path, base + slot.offset, entries(field) * stored_count(field, record.space)});
    } else {
      for (int entry = 0; entry < entries(field); ++entry) {
        path.back().entry = field.array_extent == 0 ? -1 : entry;
        append_runs(*slot.nested, base + slot.offset + entry * slot.stride, path, all);
      }
    }
    path.pop_back();
  }
}

/// @param entries what stands in the brackets of a fixed array of objects
std::string name_of(const std::vector<Step>& path, std::string (*entries)(const Step&)) {
  std::string text;
  for (const Step& step : path) {
    if (!text.empty()) text += '.';
    text += step.declaration().name;
    if (step.entry >= 0) text += "[" + entries(step) + "]";
  }
  return text;
}

// Gives every field its offset, and the record its bytes, in one precision.
void place(Record& record, const std::vector<Bytes>& alignments, Precision real) {
  for (int alignment = 8; alignment > 0; alignment /= 2) {
    for (std::size_t f = 0; f < record.slots.size(); ++f) {
      if (alignments[f].of(real) != alignment) continue;
      Slot& slot = record.slots[f];
      slot.offset.of(real) = record.bytes.of(real);
      record.bytes.of(real) += entries(record.object->fields[f]) * slot.stride.of(real);
    }
  }
}

}  // namespace

Bytes element_bytes(const model::Field& field, model::Space space) {
  const int stored = model::facts(field.format(space).encoding).bytes;
  if (stored != 0) return {stored, stored};
  const model::ElementFacts& element = model::facts(field.element);
  return {element.bytes_with_float, element.bytes_with_double};
}

int stored_count(const model::Field& field, model::Space space) {
  return field.format(space).quaternion ? 4 : model::element_count(field);
}

Record plan_record(const model::Object& object, model::Space space, const Lookup& lookup) {
  Record record;
  record.object = &object;
  record.space = space;
  record.natural_alignment = {1, 1};
  std::vector<Bytes> alignments;
  for (const model::Field& field : object.fields) {
    Slot slot;
    if (field.shape == model::Shape::object) {
      slot.nested = &lookup(field.object);
      alignments.push_back(slot.nested->natural_alignment);
      slot.stride = align_up(slot.nested->bytes, slot.nested->natural_alignment);
    } else {
      alignments.push_back(element_bytes(field, space));
      slot.stride = stored_count(field, space) * alignments.back();
    }
    record.natural_alignment = max(record.natural_alignment, alignments.back());
    record.slots.push_back(slot);
  }
  for (const Precision real : precisions) place(record, alignments, real);
  record.alignment = max(record.natural_alignment, {object.alignment, object.alignment});
  return record;
}

Records::Records(const model::Schema& schema, model::Space space) {
  const auto lookup = [this](const std::string& name) -> const Record& { return of(name); };
  for (const auto* objects : {&schema.imported, &schema.objects}) {
    for (const model::Object& object : *objects) {
      records_.emplace(object.qualified_name(), plan_record(object, space, lookup));
    }
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
  return name_of(path, [](const Step& step) { return std::to_string(step.entry); });
}

std::string Run::name_of_all_entries() const {
  return name_of(path, [](const Step& step) { return "0.." + std::to_string(step.declaration().array_extent - 1); });
}

std::vector<Run> runs(const Record& record) {
  std::vector<Run> all;
  std::vector<Step> path;
  append_runs(record, {}, path, all);
  return all;
}

}  // namespace physgen::plan
