// See header_size.h. The numbers are characters of what the emitters print around names; a test compares with what they
// write.
#include "emit/cpp/header_size.h"

#include <algorithm>
#include <cmath>

namespace physgen::emit::cpp {
namespace {

double length(const std::string& text) { return static_cast<double>(text.size()); }

// Characters of "0" to "entries - 1", on average.
double digits(double entries) { return std::floor(std::log10(std::max(1.0, entries))) + 1; }

}  // namespace

ObjectSize HeaderSizes::of(const model::Object& object) {
  const double name = length(object.name), qualified = length(object.qualified_name());
  Runs all;
  ObjectSize size;
  size.bytes = 3300 + 55 * name + qualified + length(object.scope) + length(object.doc);
  double largest = 0, nested_bytes = 0;
  for (int f = 0; const model::Field& field : object.fields) {
    const double own = length(field.name);
    const double entries = field.array_extent == 0 ? 1 : field.array_extent;
    const double index = field.array_extent == 0 ? 0 : digits(entries) + 2;
    // Its lines in the value, formats, probe, record and reference, with its comment twice.
    size.bytes += 635 + 13 * own + 2 * (length(field.doc) + length(field.unit)) + 3 * length(field.object);
    const double record = name + 25 + own;  // NameRecord<Real, Formats>::field
    Runs runs;
    if (field.shape != model::Shape::object) {
      runs = {1, 1, own, record};
    } else if (const auto found = runs_.find(field.object); found != runs_.end()) {
      const Runs& nested = found->second;
      const double step = record + 3 + (index > 0 ? index + record + 16 : 0);
      runs.count = entries * nested.count;
      runs.steps = entries * (nested.steps + nested.count);
      runs.names = entries * (nested.names + nested.count * (own + 1 + index));
      runs.offsets = entries * (nested.offsets + nested.count * (step + 9) + nested.steps * (own + 2));
    }
    // A line of the table of fields, and numbers in the proofs.
    const double table = runs.count * (130 + length(field.unit)) + 2.1 * runs.names + runs.steps + 1.1 * runs.offsets;
    size.bytes += table;
    if (field.shape == model::Shape::object) {
      nested_bytes += table;
      if (table > largest) size.largest_nested = f;
      largest = std::max(largest, table);
    }
    all.count += runs.count;
    all.steps += runs.steps;
    all.names += runs.names;
    all.offsets += runs.offsets;
    ++f;
  }
  if (nested_bytes < size.bytes / 2) size.largest_nested = -1;
  runs_[object.qualified_name()] = all;
  return size;
}

}  // namespace physgen::emit::cpp
