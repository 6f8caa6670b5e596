// Where arrays of one object type place every element, in one layout: the law of addresses (layout.h of the runtime)
// over a planned record, padding, and how many sectors of memory a warp touches.
#pragma once

#include <string>
#include <vector>

#include "plan/plan.h"

namespace physgen::plan {

inline constexpr int warp_objects =
    32;  ///< a warp reads one element of so many objects that follow each other: a request
inline constexpr int sector_bytes = 32;                  ///< what CUDA's memory delivers at least
inline constexpr long long assumed_objects = 1LL << 20;  ///< length of the array; only the pitch of Soa depends on it

/// The sectors touched by a warp: objects 0 to 31.
struct Sectors {
  int fewest = 0;       ///< by one of the requests
  int most = 0;         ///< by one of the requests
  long long total = 0;  ///< by all requests, one per element
  int ideal = 0;        ///< by one request, if its elements lay side by side
  bool operator==(const Sectors&) const = default;
};

/// Elements of one field in one record; consecutive ones are bytes apart.
struct FieldRun {
  std::string name;  ///< "F", "points[2].x"
  int offset = 0;    ///< of the first element in the record
  bool operator==(const FieldRun&) const = default;
};

/// A field, or a field of a nested object: what the generated classes have one accessor for.
struct Accessor {
  std::string name;  ///< "F", "points[0..9].x"
  model::Field field;
  model::Format format;        ///< in the map's space
  int bytes = 0;               ///< of one element
  std::vector<FieldRun> runs;  ///< one, but for fields of a fixed array of objects
  int run_elements = 0;        ///< elements of each run
  Sectors sectors;
  [[nodiscard]] int elements() const { return static_cast<int>(runs.size()) * run_elements; }
  /// The sectors of all requests, if the elements of each lay side by side.
  [[nodiscard]] long long ideal_sectors() const { return 1LL * elements() * sectors.ideal; }
  [[nodiscard]] int offset(int element) const {
    return runs[static_cast<std::size_t>(element / run_elements)].offset + element % run_elements * bytes;
  }
  bool operator==(const Accessor&) const = default;
};

/// A part of the record: a run of an accessor, or bytes without data.
struct Segment {
  int accessor = -1;  ///< -1: padding
  int run = 0;
  int offset = 0;
  int bytes = 0;
  bool operator==(const Segment&) const = default;
};

/// An array of objects.
struct LayoutMap {
  std::string object;  ///< qualified name
  std::vector<model::Space> spaces;
  model::Layout layout;
  Precision precision = Precision::with_float;
  long long pitch = 1;
  int record_bytes = 0;             ///< with padding
  std::vector<Accessor> accessors;  ///< in order of declaration
  std::vector<Segment> segments;    ///< in order of offsets; they fill the record

  [[nodiscard]] int elements() const;
  [[nodiscard]] int padding_bytes() const;  ///< of one record
  /// Whether records lie there as a whole, one after the other.
  [[nodiscard]] bool is_aos() const { return pitch == 1; }
  /// Whether tiles of several objects follow each other.
  [[nodiscard]] bool has_tiles() const { return pitch > 1 && pitch < assumed_objects; }
  /// Byte of the array at which an element of `bytes` at `offset` of the record of `object` begins.
  [[nodiscard]] long long address(int offset, int bytes, long long object_number) const;
};

/// @param space decides the formats; must be the record's
[[nodiscard]] LayoutMap map_layout(const Record& record, model::Layout layout, Precision precision);

/// Different sectors that hold the warp's objects, each counted once however many requests touch it.
[[nodiscard]] long long sectors_of_warp(const LayoutMap& map);

}  // namespace physgen::plan
