// Where everything lies: byte offsets of the fields of an object in its record, in one memory space, for both
// precisions at once. The runtime computes the same at compile time, for formats that a program chooses, too; emitters
// print these offsets for compilers to compare, and proof.h checks it.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "model/model.h"

namespace physgen::plan {

/// The type that Real stands for.
enum class Precision { with_float, with_double };
inline constexpr Precision precisions[] = {Precision::with_float, Precision::with_double};

/// A number of bytes where Real is float, and where it is double.
struct Bytes {
  int with_float = 0;
  int with_double = 0;
  [[nodiscard]] constexpr int of(Precision real) const {
    return real == Precision::with_float ? with_float : with_double;
  }
  [[nodiscard]] constexpr int& of(Precision real) { return real == Precision::with_float ? with_float : with_double; }
  bool operator==(const Bytes&) const = default;
};
[[nodiscard]] constexpr Bytes operator+(Bytes a, Bytes b) {
  return {a.with_float + b.with_float, a.with_double + b.with_double};
}
[[nodiscard]] constexpr Bytes operator*(int n, Bytes b) { return {n * b.with_float, n * b.with_double}; }

/// Bytes of one stored element of `field`; also its alignment.
[[nodiscard]] Bytes element_bytes(const model::Field& field, model::Space space);

/// Stored elements of one entry of `field`: model::element_count(), but 4 for a rotation stored as a quaternion.
[[nodiscard]] int stored_count(const model::Field& field, model::Space space);

struct Record;

/// A field in a record.
struct Slot {
  Bytes offset;  ///< of the first entry
  Bytes stride;  ///< from one entry of a fixed array to the next; the whole field if it is not an array
  const Record* nested = nullptr;  ///< of the nested object, for Shape::object only
};

/// The record of one object: its bytes in memory. It is packed: an array of structs rounds it up to `alignment`, tiles
/// of two objects to 4 bytes, of four to 2, and larger tiles do not.
struct Record {
  const model::Object* object = nullptr;
  model::Space space = model::Space::host;
  std::vector<Slot> slots;  ///< parallel to object->fields
  Bytes bytes;
  Bytes natural_alignment;  ///< of the largest element; what an object that nests this one keeps to
  Bytes alignment;  ///< of a record in an array of structs: natural, or what the schema asks for if that is more
};

/// Finds the record of a nested object by its qualified name; it must outlive the records that nest it.
using Lookup = std::function<const Record&(const std::string&)>;

/// Plans the record of `object`, which must outlive it. Fields are ordered by alignment, largest first, and by
/// declaration among equals. That leaves no gaps between fields. A nested object lies there as a whole, rounded up to
/// its natural alignment: the only bytes without data.
/// @pre validate() has no objection to the object
[[nodiscard]] Record plan_record(const model::Object& object, model::Space space, const Lookup& lookup);

/// The records of all objects of a schema, which must outlive them.
class Records {
 public:
  /// @throws std::invalid_argument when an object nests one that is not declared before it
  Records(const model::Schema& schema, model::Space space);
  [[nodiscard]] const Record& of(const std::string& qualified_name) const;

 private:
  std::map<std::string, Record> records_;  // a map's elements stay where they are: slots point at them
};

/// One step on the way from a record to an element: a field, and the entry of it if it is a fixed array of objects.
struct Step {
  const Record* record = nullptr;
  int field = 0;
  int entry = -1;  ///< -1: not a fixed array of objects
  [[nodiscard]] const model::Field& declaration() const {
    return record->object->fields[static_cast<std::size_t>(field)];
  }
  [[nodiscard]] const Slot& slot() const { return record->slots[static_cast<std::size_t>(field)]; }
};

/// Elements of one type that follow each other in a record: a field, or a field of a nested object.
struct Run {
  std::vector<Step> path;
  Bytes offset;
  int count = 0;  ///< stored elements
  [[nodiscard]] const model::Field& field() const { return path.back().declaration(); }
  /// "x", "svd.U", "points[2].x"
  [[nodiscard]] std::string name() const;
  /// The same with all entries of arrays instead of one: "points[0..9].x".
  [[nodiscard]] std::string name_of_all_entries() const;
};

/// All elements of a record as runs, in order of declaration: nested objects give one run for each of their fields,
/// fixed arrays of anything else one run for all entries.
[[nodiscard]] std::vector<Run> runs(const Record& record);

}  // namespace physgen::plan
