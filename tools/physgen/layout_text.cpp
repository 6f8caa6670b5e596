// Pictures for the terminal. See layout_picture.h.
#include <algorithm>

#include "layout_picture.h"

namespace physgen::command {
namespace {

constexpr std::size_t columns = 110;
constexpr std::size_t widest_name = 24;
constexpr std::size_t widest_cell = 22;
constexpr std::size_t most_rows = 20;  // of channels in one drawing
constexpr std::size_t indent = 2;

std::string right(const std::string& text, std::size_t width) {
  return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}
std::string left(const std::string& text, std::size_t width) {
  return text.size() < width ? text + std::string(width - text.size(), ' ') : text;
}

/// The text, or its two ends.
std::string shortened(const std::string& text, std::size_t width) {
  if (text.size() <= width) return text;
  const std::size_t back = (width - 2) / 2;
  return text.substr(0, width - 2 - back) + ".." + text.substr(text.size() - back);
}

/// "5", "0..7".
std::string span(long long first, long long last) {
  return first == last ? std::to_string(first) : std::to_string(first) + ".." + std::to_string(last);
}

void add_line(std::string& text, const std::string& line) {
  text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
}

// ---- Records as a whole: a line per object ----

struct Column {
  std::string offset;
  std::string content;
  std::size_t gap = 3;  ///< columns between this content and the next one, with the bar
  [[nodiscard]] std::size_t width() const { return std::max(offset.size() + (gap == 1 ? 1 : 0), content.size()) + gap; }
};

std::size_t width_of(const std::vector<Column>& cells) {
  std::size_t width = 1;
  for (const Column& cell : cells) width += cell.width();
  return width;
}

/// The segments of a record, those in the middle as one if there are too many.
std::vector<Column> record_columns(const LayoutMap& map, std::size_t width) {
  std::vector<Column> cells;
  for (const int number : shown_segments(map)) {
    if (number < 0) {
      cells.push_back({"", "..."});
      continue;
    }
    const Segment& segment = map.segments[static_cast<std::size_t>(number)];
    const std::string content = segment.accessor < 0
                                    ? "-- " + std::to_string(segment.bytes) + " --"
                                    : run_name(map.accessors[static_cast<std::size_t>(segment.accessor)], segment.run);
    cells.push_back({std::to_string(segment.offset), shortened(content, widest_cell)});
  }
  if (width_of(cells) <= width) return cells;
  std::vector<Column> tight = cells;
  for (Column& cell : tight) cell.gap = 1;
  if (width_of(tight) <= width) return tight;
  const std::size_t all = cells.size();
  const std::vector<Column> back(cells.end() - 2, cells.end());
  cells.resize(all - 2);
  const auto elided = [&] { return Column{"", "... " + std::to_string(all - 2 - cells.size()) + " more ..."}; };
  while (!cells.empty() && width_of(cells) + width_of(back) + elided().width() > width) cells.pop_back();
  if (!cells.empty() && cells.back().offset.empty()) cells.pop_back();  // elided already
  cells.push_back(elided());
  cells.insert(cells.end(), back.begin(), back.end());
  return cells;
}

void draw_records(const LayoutMap& map, std::string& text) {
  const std::size_t bytes_width = std::max<std::size_t>(6, std::to_string(31LL * map.record_bytes).size());
  const std::string margin(indent, ' ');
  const auto sectors = [&](long long object) {
    const long long begin = object * map.record_bytes;
    return span(begin / sector_bytes, (begin + map.record_bytes - 1) / sector_bytes);
  };
  const std::size_t sectors_width = std::max<std::size_t>(7, sectors(warp_objects - 1).size());
  const auto cells = record_columns(map, columns - indent - bytes_width - 12 - sectors_width);
  std::string offsets;
  std::string record;
  for (const Column& cell : cells) {
    const std::string space(cell.gap / 2, ' ');
    offsets += " " + space + left(cell.offset.empty() ? "" : "+" + cell.offset, cell.width() - 1 - space.size());
    record += "|" + space + left(cell.content, cell.width() - 1 - space.size());
  }
  record += "|";
  add_line(text, margin + right("byte", bytes_width) + "  object  " + left(offsets, record.size()) + "  sectors");
  for (const long long object : {0LL, 1LL, 2LL, 3LL, -1LL, 31LL}) {
    if (object < 0) {
      add_line(text, margin + right("...", bytes_width) + "  " + right("...", 6));
      continue;
    }
    std::string line = margin;
    line.append(right(std::to_string(object * map.record_bytes), bytes_width)).append("  ");
    line.append(right(std::to_string(object), 6)).append("  ").append(record).append("  ").append(sectors(object));
    add_line(text, line);
  }
}

// ---- Channels: a line per element of the record ----

struct Row {
  std::string name;
  std::string byte;
  std::string content;
};

/// The objects of a channel from byte `begin` on: "| 0..7 | 8..15 |", with bars where sectors begin.
std::string channel(const LayoutMap& map, long long begin, int bytes, long long first_object) {
  struct Piece {
    std::string objects;
    char bar;  // in front
  };
  const long long end_object = first_object + std::min(map.pitch, assumed_objects);
  std::vector<Piece> pieces;
  const auto bar = [](long long address) { return address % sector_bytes == 0 ? '|' : ':'; };
  const auto add = [&](long long from, long long to) {
    pieces.push_back({span(from, to - 1), bar(begin + (from - first_object) * bytes)});
  };
  const auto sector_end = [&](long long object) {
    const long long address = begin + (object - first_object) * bytes;
    return std::min(object + (sector_bytes - address % sector_bytes + bytes - 1) / bytes, end_object);
  };
  long long object = first_object;
  for (; object < end_object && pieces.size() < 4; object = sector_end(object)) add(object, sector_end(object));
  if (object < end_object) {
    const long long last_begin =
        std::max(object, end_object - std::max<long long>(1, sector_bytes / bytes));  // sectors are whole at the end
    if (last_begin > object) pieces.push_back({"...", '|'});
    add(last_begin, end_object);
  }
  std::string text;
  for (const Piece& piece : pieces) text += std::string(1, piece.bar) + " " + piece.objects + " ";
  text += bar(begin + (end_object - first_object) * bytes);
  if (map.pitch > assumed_objects) text += " " + std::to_string(map.pitch - assumed_objects) + " spare";
  return text;
}

/// The channels of one segment of the first tile: all, or the first two and the last.
void add_rows(const LayoutMap& map, const Segment& segment, bool all, std::vector<Row>& rows) {
  const long long begin = segment.offset * map.pitch;
  if (segment.accessor < 0) {
    rows.push_back(
        {"--", std::to_string(begin), "-- " + std::to_string(segment.bytes * map.pitch) + " bytes padding --"});
    return;
  }
  const Accessor& accessor = map.accessors[static_cast<std::size_t>(segment.accessor)];
  for (int k = 0; k < accessor.run_elements; ++k) {
    if (!all && k == 2 && accessor.run_elements > 4) {
      k = accessor.run_elements - 1;
      rows.push_back({"...", "", ""});
    }
    const long long byte = begin + map.pitch * accessor.bytes * k;
    rows.push_back({element_name(accessor, segment.run * accessor.run_elements + k), std::to_string(byte),
                    channel(map, byte, accessor.bytes, 0)});
  }
}

void draw_channels(const LayoutMap& map, std::string& text) {
  const bool all = static_cast<std::size_t>(map.elements()) <= 12;
  std::vector<Row> rows;
  const std::vector<int> shown = shown_segments(map);
  for (std::size_t s = 0; s < shown.size(); ++s) {
    if (rows.size() > most_rows - 5 && s + 3 < shown.size()) {
      rows.push_back({"... " + std::to_string(shown.size() - 2 - s) + " more ...", "", ""});
      s = shown.size() - 2;
    }
    if (shown[s] < 0)
      rows.push_back({"...", "", ""});
    else
      add_rows(map, map.segments[static_cast<std::size_t>(shown[s])], all, rows);
  }
  if (map.has_tiles()) {
    const Cell cell = map.at(map.pitch * map.record_bytes);
    const Accessor& accessor = map.accessors[static_cast<std::size_t>(cell.accessor)];
    rows.push_back({element_name(accessor, cell.element), std::to_string(cell.begin),
                    channel(map, cell.begin, accessor.bytes, cell.object)});
    rows.push_back({"...", "", ""});
  }
  std::size_t name_width = 7;
  std::size_t byte_width = 6;
  for (Row& row : rows) {
    row.name = shortened(row.name, widest_name);
    name_width = std::max(name_width, row.name.size());
    byte_width = std::max(byte_width, row.byte.size());
  }
  const std::string margin(indent, ' ');
  add_line(text, margin + right("byte", byte_width) + "  " + left("element", name_width) +
                     "  objects, with a bar where a sector of 32 bytes begins");
  for (const Row& row : rows)
    add_line(text, margin + right(row.byte, byte_width) + "  " + left(row.name, name_width) + "  " + row.content);
}

// ---- The table of accessors ----

using Line = std::vector<std::string>;

std::vector<Line> table_lines(const LayoutMap& map) {
  std::vector<Line> lines{
      {"field", "elements", "format", "offset", "bytes", "sectors/request", "of ideal", "used of 32 B"}};
  for (const Accessor& accessor : map.accessors)
    lines.push_back({accessor.name, std::to_string(accessor.elements()), format_word(accessor, map.precision),
                     std::to_string(accessor.offset(0)), std::to_string(accessor.elements() * accessor.bytes),
                     sectors_words(accessor.sectors), fixed(over_ideal(accessor), 2) + "x",
                     fixed(used_per_sector(accessor), 1)});
  return lines;
}

void draw_table(const LayoutMap& map, std::string& text) {
  std::vector<Line> lines = table_lines(map);
  std::vector<std::size_t> widths(lines.front().size(), 0);
  std::size_t others = indent;
  for (std::size_t c = widths.size(); c-- > 0;) {
    if (c == 0)
      for (Line& line : lines) line[0] = shortened(line[0], columns - others);
    for (const Line& line : lines) widths[c] = std::max(widths[c], line[c].size());
    others += widths[c] + 2;
  }
  for (const Line& line : lines) {
    std::string row(indent, ' ');
    for (std::size_t c = 0; c < line.size(); ++c)
      row += (c == 0 || c == 2 ? left(line[c], widths[c]) : right(line[c], widths[c])) + "  ";
    add_line(text, row);
  }
}

}  // namespace

std::string layout_text(const std::vector<LayoutMap>& maps) {
  std::string text;
  for (const LayoutMap& map : maps) {
    add_line(text, map.object + " on " + space_words(map) + ", " + layout_word(map.layout) +
                       ", Real = " + precision_word(map.precision));
    add_line(text, std::string(indent, ' ') + record_words(map));
    text += '\n';
    if (map.is_aos())
      draw_records(map, text);
    else
      draw_channels(map, text);
    text += '\n';
    draw_table(map, text);
    add_line(text, std::string(indent, ' ') + warp_words(map));
    text += '\n';
  }
  text +=
      "A request is what a warp reads at once: one element of objects 0 to 31. Ideal: these elements side by side.\n"
      "-- is padding. Offsets are those in the record; an element at offset B begins at byte B * pitch of its tile.\n";
  return text;
}

}  // namespace physgen::command
