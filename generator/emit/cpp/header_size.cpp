// See header_size.h. The numbers are characters of what the emitters print around names; a test compares with what they
// write.
#include "emit/cpp/header_size.h"

#include <algorithm>
#include <cmath>

#include "emit/cpp/pieces.h"

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
  bool has_docs = false;
  size.bytes = (runs_.empty() ? 1740 : 0) + 1530 + 29 * name + qualified + length(object.scope) + length(object.doc);
  double largest = 0, nested_bytes = 0;
  for (int f = 0; const model::Field& field : object.fields) {
    const double own = length(field.name);
    const bool is_array = field.array_extent != 0;
    const double entries = is_array ? field.array_extent : 1;
    // Its lines in the value, formats, probe, record and reference, with its comment twice, and among the docs.
    size.bytes += 370 + 15 * own + name + 3 * length(field.doc) + 2 * length(field.unit) + 4 * length(field.object);
    has_docs = has_docs || !field.doc.empty();
    if (is_array) size.bytes += 290 + 5 * own + qualified;
    if (is_array && entries <= longest_unrolled) {  // each is read, and each matrix has an initializer
      const bool matrix = field.shape != model::Shape::scalar && field.shape != model::Shape::object;
      size.bytes += entries * (own + 12 + (matrix ? own + 45 : 0));
    }
    Runs runs{1, own};
    if (field.shape == model::Shape::object) {
      const auto found = runs_.find(field.object);
      const Runs nested = found == runs_.end() ? Runs{} : found->second;
      const double index = is_array ? digits(entries) + 2 : 0;
      runs.count = entries * nested.count;
      runs.names = entries * (nested.names + nested.count * (own + 1 + index));
    }
    // Texts in the list of fields, and numbers in the proofs.
    const double table = runs.count * (22 + length(field.unit)) + runs.names;
    size.bytes += table;
    if (field.shape == model::Shape::object) {
      nested_bytes += table;
      if (table > largest) size.largest_nested = f;
      largest = std::max(largest, table);
    }
    all.count += runs.count;
    all.names += runs.names;
    ++f;
  }
  if (has_docs) size.bytes += 75 + 8 * static_cast<double>(object.fields.size());
  size.fields = all.count;
  if (nested_bytes < size.bytes / 2) size.largest_nested = -1;
  runs_[object.qualified_name()] = all;
  return size;
}

}  // namespace physgen::emit::cpp
