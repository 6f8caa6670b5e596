// Drawings for the terminal: layout_text() of layout_boxes.h.
#include <algorithm>

#include "layout_boxes.h"

namespace physgen::command {
namespace {

using plan::sector_bytes;

constexpr std::size_t columns = 110;
constexpr std::size_t widest_name = 24;
constexpr std::size_t widest_box = 29;

using Line = std::vector<std::string>;

std::string padded(const std::string& text, std::size_t width, bool right) {
  const std::string space(width - std::min(width, text.size()), ' ');
  return right ? space + text : text + space;
}

/// The text, or its two ends.
std::string shortened(const std::string& text, std::size_t width) {
  if (text.size() <= width) return text;
  const std::size_t back = (width - 2) / 2;
  return text.substr(0, width - 2 - back) + ".." + text.substr(text.size() - back);
}

/// Columns with two spaces before each; the first one is as narrow as a line of 110 asks for.
/// @param right for each column, whether it is aligned there
void add_lines(std::string& text, std::vector<Line> lines, const std::vector<bool>& right) {
  std::vector<std::size_t> widths(right.size(), 0);
  std::size_t others = 2;
  for (std::size_t c = widths.size(); c-- > 0; others += widths[c] + 2)
    for (Line& line : lines) {
      if (c == 0) line[c] = shortened(line[c], columns - others);
      widths[c] = std::max(widths[c], line[c].size());
    }
  for (const Line& line : lines) {
    std::string row;
    for (std::size_t c = 0; c < line.size(); ++c) row += "  " + padded(line[c], widths[c], right[c]);
    text += row.substr(0, row.find_last_not_of(' ') + 1) + "\n";
  }
}

/// "| 0..7 | 8..15 : 16..17 |", with bars where sectors begin; as many boxes as fit.
std::string content(const Row& row, std::size_t width) {
  const auto bar = [](long long address) { return address % sector_bytes == 0 ? "|" : ":"; };
  std::vector<std::string> pieces;
  long long end = row.boxes.front().begin;
  for (const Box& box : row.boxes) {
    if (box.begin != end) pieces.emplace_back("| ... ");
    pieces.push_back(bar(box.begin) + (" " + shortened(box.text, widest_box)) + " ");
    end = box.end;
  }
  const std::string last = pieces.back() + bar(end);
  pieces.pop_back();
  std::size_t length = last.size(), shown = 0;
  for (const std::string& piece : pieces) length += piece.size();
  std::string text, more;
  if (length > width) {
    constexpr std::size_t most_digits = 22;  // "| ... 1048576 more ..."
    for (length = last.size() + most_digits; length + pieces[shown].size() <= width; ++shown)
      length += pieces[shown].size();
    more = "| ... " + std::to_string(pieces.size() - shown) + " more ... ";
  } else {
    shown = pieces.size();
  }
  for (std::size_t p = 0; p < shown; ++p) text += pieces[p];
  return text + more + last;
}

void draw_rows(const LayoutMap& map, std::string& text) {
  std::vector<Line> lines{{"byte", "element", "objects, with a bar where a sector of 32 bytes begins"}};
  if (map.is_aos())
    lines = {{"byte", "object", "fields at their offsets, with a bar where a sector of 32 bytes begins"}};
  const std::vector<Row> rows = layout_rows(map);
  std::size_t others = 0;  // columns beside the boxes
  for (const Row& row : rows)
    others = std::max(others, 6 + std::max<std::size_t>(7, std::min(row.name.size(), widest_name)) +
                                  (row.boxes.empty() ? 0 : std::to_string(row.boxes.front().begin).size()));
  for (const Row& row : rows) {
    if (row.boxes.empty())
      lines.push_back({"", row.name, ""});
    else
      lines.push_back(
          {std::to_string(row.boxes.front().begin), shortened(row.name, widest_name), content(row, columns - others)});
  }
  add_lines(text, lines, {true, false, false});
}

/// "4", "12-13": the sectors that a request takes.
std::string sectors_words(const plan::Sectors& sectors) {
  const std::string fewest = std::to_string(sectors.fewest);
  return sectors.fewest == sectors.most ? fewest : fewest + "-" + std::to_string(sectors.most);
}

void draw_table(const LayoutMap& map, std::string& text) {
  std::vector<Line> lines{
      {"field", "elements", "format", "offset", "bytes", "sectors/request", "of ideal", "used of 32 B"}};
  for (const Accessor& accessor : map.accessors) {
    const double over_ideal =
        static_cast<double>(accessor.sectors.total) / static_cast<double>(accessor.ideal_sectors());
    lines.push_back({accessor.name, std::to_string(accessor.elements()), format_word(accessor, map.precision),
                     std::to_string(accessor.offset(0)), std::to_string(accessor.elements() * accessor.bytes),
                     sectors_words(accessor.sectors), fixed(over_ideal, 2) + "x", fixed(sector_bytes / over_ideal, 1)});
  }
  add_lines(text, lines, {false, true, false, true, true, true, true, true});
}

}  // namespace

std::string layout_text(const std::vector<LayoutMap>& maps) {
  std::string text;
  for (const LayoutMap& map : maps) {
    text += map.object + " on " + space_words(map) + ", " + layout_word(map.layout) +
            ", Real = " + precision_word(map.precision) + "\n  " + record_words(map) + "\n\n";
    draw_rows(map, text);
    text += '\n';
    draw_table(map, text);
    text += "  " + warp_words(map) + "\n\n";
  }
  text +=
      "A request is what a warp reads at once: one element of objects 0 to 31. Ideal: these elements side by side.\n"
      "-- is padding. Offsets are those in the record; an element at offset B begins at byte B * pitch of its tile.\n";
  return text;
}

}  // namespace physgen::command
