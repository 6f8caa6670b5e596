// See layout_map.h.
#include "plan/layout_map.h"

#include <physgen/layout/address.h>

#include <algorithm>
#include <map>

namespace physgen::plan {
namespace {

std::vector<Accessor> accessors_of(const Record& record, Precision precision) {
  std::vector<Accessor> accessors;
  std::map<std::string, std::size_t> known;
  for (const Run& run : runs(record)) {
    const std::string name = run.name_of_all_entries();
    const auto [found, is_new] = known.emplace(name, accessors.size());
    if (is_new) {
      const int bytes = element_bytes(run.field(), record.space).of(precision);
      accessors.push_back({name, run.field(), run.field().format(record.space), bytes, {}, run.count, {}});
    }
    accessors[found->second].runs.push_back({run.name(), run.offset.of(precision)});
  }
  return accessors;
}

/// The record from its first byte to its last.
std::vector<Segment> segments_of(const LayoutMap& map) {
  std::vector<Segment> data;
  for (std::size_t a = 0; a < map.accessors.size(); ++a) {
    const Accessor& accessor = map.accessors[a];
    for (std::size_t r = 0; r < accessor.runs.size(); ++r)
      data.push_back(
          {static_cast<int>(a), static_cast<int>(r), accessor.runs[r].offset, accessor.run_elements * accessor.bytes});
  }
  std::ranges::sort(data, {}, &Segment::offset);
  std::vector<Segment> all;
  int end = 0;
  const auto fill_up_to = [&](int offset) {
    if (end < offset) all.push_back({-1, 0, end, offset - end});
  };
  for (const Segment& segment : data) {
    fill_up_to(segment.offset);
    all.push_back(segment);
    end = segment.offset + segment.bytes;
  }
  fill_up_to(map.record_bytes);
  return all;
}

/// Counts different sectors of elements whose addresses do not fall.
class SectorCount {
 public:
  void add(long long address, int bytes) {
    const long long first = std::max(address / sector_bytes, last_ + 1);
    const long long last = (address + bytes - 1) / sector_bytes;
    if (last < first) return;
    count_ += last - first + 1;
    last_ = last;
  }
  [[nodiscard]] long long count() const { return count_; }

 private:
  long long last_ = -1;
  long long count_ = 0;
};

Sectors sectors_of(const LayoutMap& map, const Accessor& accessor) {
  Sectors sectors;
  sectors.ideal = warp_objects * accessor.bytes / sector_bytes;
  for (int element = 0; element < accessor.elements(); ++element) {
    SectorCount request;
    for (int object = 0; object < warp_objects; ++object)
      request.add(map.address(accessor.offset(element), accessor.bytes, object), accessor.bytes);
    const int count = static_cast<int>(request.count());
    sectors.fewest = element == 0 ? count : std::min(sectors.fewest, count);
    sectors.most = std::max(sectors.most, count);
    sectors.total += count;
  }
  return sectors;
}

}  // namespace

int LayoutMap::elements() const {
  int count = 0;
  for (const Accessor& accessor : accessors) count += accessor.elements();
  return count;
}

int LayoutMap::padding_bytes() const {
  int bytes = 0;
  for (const Segment& segment : segments)
    if (segment.accessor < 0) bytes += segment.bytes;
  return bytes;
}

long long LayoutMap::address(int offset, int bytes, long long object_number) const {
  return law::element(index_t{0}, AnyPitch{pitch}, record_bytes, object_number, offset, bytes);
}

LayoutMap map_layout(const Record& record, model::Layout layout, Precision precision) {
  LayoutMap map;
  map.object = record.object->qualified_name();
  map.spaces = {record.space};
  map.layout = layout;
  map.precision = precision;
  const model::LayoutFacts& facts = model::facts(layout.kind);
  map.pitch = facts.pitch(assumed_objects, layout.tile);
  map.record_bytes = facts.record_bytes(record.bytes.of(precision), record.alignment.of(precision), layout.tile);
  map.accessors = accessors_of(record, precision);
  map.segments = segments_of(map);
  for (Accessor& accessor : map.accessors) accessor.sectors = sectors_of(map, accessor);
  return map;
}

long long sectors_of_warp(const LayoutMap& map) {
  SectorCount sectors;
  for (long long tile = 0; tile * map.pitch < warp_objects; ++tile) {
    for (const Segment& segment : map.segments) {
      if (segment.accessor < 0) continue;
      const int bytes = map.accessors[static_cast<std::size_t>(segment.accessor)].bytes;
      for (int offset = segment.offset; offset < segment.offset + segment.bytes; offset += bytes)
        for (long long i = tile * map.pitch; i < std::min<long long>((tile + 1) * map.pitch, warp_objects); ++i)
          sectors.add(map.address(offset, bytes, i), bytes);
    }
  }
  return sectors.count();
}

}  // namespace physgen::plan
