// See layout_boxes.h.
#include "layout_boxes.h"

#include <algorithm>
#include <cstdio>

namespace physgen::command {
namespace {

using plan::sector_bytes;
using plan::Segment;

constexpr int first_objects = 8;       // in which the places of records of whole words in their sectors repeat
constexpr std::size_t most_rows = 20;  // of elements, and those of a segment and of the next tile
constexpr std::size_t first_sectors = 4;

/// The accessor of data.
const Accessor& accessor_of(const LayoutMap& map, const Segment& segment) {
  return map.accessors[static_cast<std::size_t>(segment.accessor)];
}

/// The segments to show; of the entries of a fixed array of objects the first and the last, with null for the others.
/// Repeated padding goes with the segment before it.
std::vector<const Segment*> shown_segments(const LayoutMap& map) {
  std::vector<const Segment*> shown;
  bool hidden = false;
  for (const Segment& segment : map.segments) {
    if (segment.accessor >= 0)
      hidden = segment.run > 0 && segment.run + 1 < static_cast<int>(accessor_of(map, segment).runs.size());
    if (!hidden)
      shown.push_back(&segment);
    else if (shown.back() != nullptr)
      shown.push_back(nullptr);
  }
  return shown;
}

/// "5", "0..7".
std::string span(long long first, long long last) {
  return first == last ? std::to_string(first) : std::to_string(first) + ".." + std::to_string(last);
}

Box padding(long long begin, long long bytes, const std::string& text) {
  return {begin, begin + bytes, -1, 0, 0, 0, 0, text};
}

Row record_row(const LayoutMap& map, long long object) {
  Row row{std::to_string(object), {}};
  for (const Segment* segment : shown_segments(map)) {
    if (segment == nullptr) continue;
    const long long begin = object * map.record_bytes + segment->offset;
    Box box = padding(begin, segment->bytes, "-- " + std::to_string(segment->bytes) + " --");
    if (segment->accessor >= 0) {
      const Accessor& accessor = accessor_of(map, *segment);
      box.field = segment->accessor;
      box.elements = accessor.run_elements;
      box.element = segment->run * box.elements;
      box.object = object;
      box.objects = 1;
      box.text = run_name(accessor, segment->run);
    }
    box.text.insert(0, "+" + std::to_string(segment->offset) + " ");
    row.boxes.push_back(std::move(box));
  }
  return row;
}

/// One element of the objects of a tile: its first sectors and its last one.
Row channel_row(const LayoutMap& map, const Segment& segment, int element, long long first_object) {
  const Accessor& accessor = accessor_of(map, segment);
  const int bytes = accessor.bytes;
  const long long begin = map.address(accessor.offset(element), bytes, first_object);
  const long long end_object = first_object + std::min(map.pitch, plan::assumed_objects);
  Row row{element_name(accessor, element), {}};
  const auto at = [&](long long object) { return begin + (object - first_object) * bytes; };
  const auto add = [&](long long from, long long to) {
    row.boxes.push_back({at(from), at(to), segment.accessor, element, 1, from, to - from, span(from, to - 1)});
  };
  const auto sector_end = [&](long long object) {
    return std::min(object + (sector_bytes - at(object) % sector_bytes + bytes - 1) / bytes, end_object);
  };
  long long object = first_object;
  for (; object < end_object && row.boxes.size() < first_sectors; object = sector_end(object))
    add(object, sector_end(object));
  if (object < end_object) add(std::max(object, end_object - std::max(1, sector_bytes / bytes)), end_object);
  if (const long long spare = map.pitch - plan::assumed_objects; spare > 0)
    row.boxes.push_back(padding(at(end_object), spare * bytes, std::to_string(spare) + " spare"));
  return row;
}

/// A segment of the first tile: all its elements, or the first two and the last.
void add_rows(const LayoutMap& map, const Segment& segment, bool all, std::vector<Row>& rows) {
  if (segment.accessor < 0) {
    const long long bytes = segment.bytes * map.pitch;
    const std::string text = "-- " + std::to_string(bytes) + " bytes padding --";
    rows.push_back({"--", {padding(segment.offset * map.pitch, bytes, text)}});
    return;
  }
  const int elements = accessor_of(map, segment).run_elements;
  for (int k = 0; k < elements; ++k) {
    if (!all && k == 2 && elements > 4) {
      k = elements - 1;
      rows.push_back({"...", {}});
    }
    rows.push_back(channel_row(map, segment, segment.run * elements + k, 0));
  }
}

/// Index of element k of one entry, as the shape's value takes it.
std::string index_in_entry(const Accessor& accessor, int k) {
  const model::Field& field = accessor.field;
  if (accessor.format.quaternion) return {'.', "wxyz"[k]};
  if (field.shape == model::Shape::scalar) return "";
  const model::ShapeFacts& shape = model::facts(field.shape);
  const auto [row, column] = shape.entry(k, field.rows);
  return shape.column ? "[" + std::to_string(row) + "]"
                      : "(" + std::to_string(row) + "," + std::to_string(column) + ")";
}

std::string counted(long long count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::vector<Row> rows_of_records(const LayoutMap& map) {
  std::vector<Row> rows;
  for (long long object = 0; object < first_objects; ++object) rows.push_back(record_row(map, object));
  rows.push_back({"...", {}});
  rows.push_back(record_row(map, plan::warp_objects - 1));
  return rows;
}

std::vector<Row> rows_of_channels(const LayoutMap& map) {
  const bool all = map.elements() <= 12;
  std::vector<Row> rows;
  const std::vector<const Segment*> shown = shown_segments(map);
  for (std::size_t s = 0; s < shown.size(); ++s) {
    if (rows.size() > most_rows - 5 && s + 3 < shown.size()) {
      rows.push_back({"... " + std::to_string(shown.size() - 2 - s) + " more ...", {}});
      s = shown.size() - 2;
    }
    if (shown[s] == nullptr)
      rows.push_back({"...", {}});
    else
      add_rows(map, *shown[s], all, rows);
  }
  if (map.has_tiles()) {
    const Segment& first = map.segments.front();
    rows.push_back(channel_row(map, first, first.run * accessor_of(map, first).run_elements, map.pitch));
    rows.push_back({"...", {}});
  }
  return rows;
}

}  // namespace

std::vector<Row> layout_rows(const LayoutMap& map) {
  return map.is_aos() ? rows_of_records(map) : rows_of_channels(map);
}

std::string space_words(const LayoutMap& map) {
  std::string words;
  for (const model::Space space : map.spaces) {
    if (!words.empty()) words += " and ";
    words += model::facts(space).word;
  }
  return words;
}

const char* precision_word(plan::Precision precision) {
  return precision == plan::Precision::with_float ? "float" : "double";
}

std::string format_word(const Accessor& accessor, plan::Precision precision) {
  const model::EncodingFacts& encoding = model::facts(accessor.format.encoding);
  std::string word(encoding.scaling == model::Scaling::interval ? encoding.word : encoding.name);
  if (accessor.format.encoding == model::Encoding::native) word = model::facts(accessor.field.element).name;
  if (word.empty()) word = precision_word(precision);
  return accessor.format.quaternion ? "quaternion(" + word + ")" : word;
}

std::string element_index(const Accessor& accessor, int element) {
  const int in_run = element % accessor.run_elements;
  const int extent = accessor.field.array_extent;
  if (extent == 0) return index_in_entry(accessor, in_run);
  const int entry_elements = accessor.run_elements / extent;
  return "[" + std::to_string(in_run / entry_elements) + "]" + index_in_entry(accessor, in_run % entry_elements);
}

std::string element_name(const Accessor& accessor, int element) {
  return accessor.runs[static_cast<std::size_t>(element / accessor.run_elements)].name +
         element_index(accessor, element);
}

std::string run_name(const Accessor& accessor, int run) {
  std::string name = element_name(accessor, run * accessor.run_elements);
  if (accessor.run_elements == 1) return name;
  const std::string last = element_index(accessor, accessor.run_elements - 1);
  return name + ".." + (last.front() == '.' ? last.substr(1) : last);  // "R.w..z"
}

std::string fixed(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string record_words(const LayoutMap& map) {
  std::string words = "records of " + counted(map.record_bytes, "byte");
  if (const int padding = map.padding_bytes(); padding > 0)
    words += ", " + std::to_string(padding) + " of them padding";
  if (map.has_tiles())
    words += "; tiles of " + std::to_string(map.pitch) + " objects, " + std::to_string(map.pitch * map.record_bytes) +
             " bytes";
  else if (!map.is_aos())
    words += "; pitch " + std::to_string(map.pitch) + " for " + std::to_string(plan::assumed_objects) + " objects";
  return words;
}

std::string warp_words(const LayoutMap& map) {
  long long total = 0;
  long long ideal = 0;
  for (const Accessor& accessor : map.accessors) {
    total += accessor.sectors.total;
    ideal += accessor.ideal_sectors();
  }
  return "all " + counted(map.elements(), "request") + ": " + counted(total, "sector") + ", " +
         fixed(static_cast<double>(total) / static_cast<double>(ideal), 2) + "x the ideal " + std::to_string(ideal) +
         "; " + std::to_string(plan::sectors_of_warp(map)) + " different ones";
}

}  // namespace physgen::command
