// Pictures as SVG: memory in rows of 128 bytes, coloured by field, and the cost of each accessor. See layout_picture.h.
#include <algorithm>
#include <array>
#include <set>

#include "layout_canvas.h"
#include "layout_picture.h"

namespace physgen::command {
namespace {

// Everything in pixels, but for row_bytes.
constexpr int page_width = 1184;
constexpr double margin = 24;
constexpr int row_bytes = 128;
constexpr double memory_left = 112;
constexpr double byte_width = 8;
constexpr double sector_gap = 8;
constexpr double label_height = 15, cell_height = 21, mark_height = 4, row_height = 50, gap_height = 20;
constexpr double table_row = 20;
constexpr double sector_bar = 8;  // width of one sector in the bars of the table
constexpr std::size_t most_rows = 12;
constexpr const char *black = "#000", *dark = "#333", *grey = "#666", *light = "#ccc";
constexpr const char* outline = R"(stroke="#000" stroke-width="2")";

/// Okabe and Ito's colours, which colour-blind people tell apart, and the text that is read on each.
struct Colour {
  const char* fill;
  const char* text;
};
constexpr std::array<Colour, 8> palette = {{{"#56B4E9", "#000"},
                                            {"#E69F00", "#000"},
                                            {"#009E73", "#000"},
                                            {"#F0E442", "#000"},
                                            {"#CC79A7", "#000"},
                                            {"#0072B2", "#fff"},
                                            {"#D55E00", "#000"},
                                            {"#BBBBBB", "#000"}}};
Colour colour_of(int accessor) { return palette[static_cast<std::size_t>(accessor) % palette.size()]; }

/// The first of the texts that fits; else the beginning of the last, or nothing.
std::string fitting(const std::vector<std::string>& texts, double width, double size) {
  for (const std::string& text : texts)
    if (text_width(text, size) <= width) return text;
  std::string text = texts.back();
  while (text.size() > 2 && text_width(text + "..", size) > width) text.pop_back();
  return text.size() > 2 ? text + ".." : "";
}

/// One memory request: an element of the warp's objects.
struct Request {
  int accessor;
  int element;
};

/// The element at the beginning of the record.
Request first_request(const LayoutMap& map) {
  const Segment& first = map.segments.front();
  return {first.accessor, first.run * map.accessors[static_cast<std::size_t>(first.accessor)].run_elements};
}

bool touches(const Request& request, const Cell& cell) {
  return cell.accessor == request.accessor && cell.element == request.element && cell.object < warp_objects;
}

/// Numbers of the rows of memory to draw, in order: the first ones of records, the first of each channel of a tile.
std::vector<long long> shown_rows(const LayoutMap& map) {
  std::set<long long> rows;
  const auto add = [&](long long address) { rows.insert(address / row_bytes); };
  if (map.is_aos()) {
    for (long long row = 0; row < 6 && row * row_bytes < 1LL * warp_objects * map.record_bytes; ++row) rows.insert(row);
    return {rows.begin(), rows.end()};
  }
  const Request first = first_request(map);
  const Accessor& accessor = map.accessors[static_cast<std::size_t>(first.accessor)];
  for (int object = 0; object < warp_objects; ++object)
    add(map.address(accessor.offset(first.element), accessor.bytes, object));
  for (const int number : shown_segments(map)) {
    if (number < 0) continue;
    const Segment& segment = map.segments[static_cast<std::size_t>(number)];
    const int bytes =
        segment.accessor < 0 ? segment.bytes : map.accessors[static_cast<std::size_t>(segment.accessor)].bytes;
    const int count = segment.bytes / bytes;
    for (const int element : {0, 1, count - 1})
      if (element < count) add((segment.offset + 1LL * element * bytes) * map.pitch);
  }
  std::vector<long long> all(rows.begin(), rows.end());
  if (all.size() > most_rows) all.erase(all.begin() + most_rows - 3, all.end() - 3);
  const long long next_tile = map.pitch * map.record_bytes / row_bytes;
  if (map.has_tiles() && all.back() < next_tile) all.push_back(next_tile);
  return all;
}

/// Left edge of the byte that stands so far behind the beginning of its row.
double byte_x(long long byte) {
  const long long sector = byte / sector_bytes;
  return memory_left + static_cast<double>(byte) * byte_width + static_cast<double>(sector) * sector_gap;
}

/// The part of a cell that lies in one sector of a row; bytes count from the beginning of the row.
struct Part {
  Cell cell;
  long long begin;
  long long end;
  [[nodiscard]] double x() const { return byte_x(begin); }
  [[nodiscard]] double width() const { return static_cast<double>(end - begin) * byte_width; }
};

std::vector<Part> parts_of(const LayoutMap& map, long long row) {
  std::vector<Part> parts;
  for (long long byte = 0; byte < row_bytes; byte = parts.back().end) {
    const Cell cell = map.at(row * row_bytes + byte);
    const long long sector_end = (byte / sector_bytes + 1) * sector_bytes;
    parts.push_back({cell, byte, std::min(cell.end - row * row_bytes, sector_end)});
  }
  return parts;
}

/// The text above neighbouring cells: their object where records are whole, else their element.
std::vector<std::string> group_names(const LayoutMap& map, const Cell& cell) {
  if (map.is_aos()) return {"object " + std::to_string(cell.object), std::to_string(cell.object)};
  if (cell.accessor < 0) return {"padding", ""};
  const Accessor& accessor = map.accessors[static_cast<std::size_t>(cell.accessor)];
  return {element_name(accessor, cell.element), accessor.field.name + element_index(accessor, cell.element),
          accessor.field.name};
}

/// The text in a cell: the other of the two.
std::vector<std::string> cell_names(const LayoutMap& map, const Cell& cell) {
  if (cell.accessor < 0) return {""};
  if (!map.is_aos()) return {std::to_string(cell.object), ""};
  const Accessor& accessor = map.accessors[static_cast<std::size_t>(cell.accessor)];
  const std::string index = element_index(accessor, cell.element);
  if (index.empty()) return {accessor.field.name};
  if (index.front() == '.') return {accessor.field.name + index, index.substr(1)};
  const std::size_t entry = accessor.field.array_extent == 0 ? 0 : index.find(']') + 1;
  return {accessor.field.name + index, index, index.substr(entry), ""};
}

void draw_groups(const LayoutMap& map, const std::vector<Part>& parts, double y, Canvas& canvas) {
  const auto same_group = [&](const Cell& a, const Cell& b) {
    return map.is_aos() ? a.object == b.object
                        : a.accessor == b.accessor && a.element == b.element &&
                              (a.accessor >= 0 || a.begin == b.begin) && a.object / map.pitch == b.object / map.pitch;
  };
  for (std::size_t first = 0; first < parts.size();) {
    std::size_t last = first;
    while (last + 1 < parts.size() && same_group(parts[first].cell, parts[last + 1].cell)) ++last;
    const double x = parts[first].x() + 2;
    const double end = parts[last].x() + parts[last].width() - 2;
    canvas.line(x, y + label_height - 2, end, y + label_height - 2, grey);
    canvas.text((x + end) / 2, y + label_height - 5, fitting(group_names(map, parts[first].cell), end - x, 10),
                {dark, 10, "middle"});
    first = last + 1;
  }
}

void draw_row(const LayoutMap& map, const Request& request, long long row, double y, Canvas& canvas) {
  const std::vector<Part> parts = parts_of(map, row);
  canvas.text(memory_left - 12, y + label_height + 15, std::to_string(row * row_bytes), {dark, 12, "end"});
  draw_groups(map, parts, y, canvas);
  std::set<long long> touched;
  const double top = y + label_height;
  for (const Part& part : parts) {
    const bool padding = part.cell.accessor < 0;
    const Colour colour = padding ? Colour{"", "#000"} : colour_of(part.cell.accessor);
    canvas.rectangle(part.x(), top, part.width(), cell_height, padding ? Canvas::hatched() : colour.fill,
                     R"(stroke="#fff")");
    const std::string name = fitting(cell_names(map, part.cell), part.width() - 3, 9.5);
    if (!name.empty()) canvas.text(part.x() + part.width() / 2, top + 14.5, name, {colour.text, 9.5, "middle"});
    if (touches(request, part.cell)) touched.insert(part.begin / sector_bytes);
  }
  for (const Part& part : parts)  // on top of all cells, whose borders would cover a part of it
    if (touches(request, part.cell))
      canvas.rectangle(part.x() + 1, top + 1, part.width() - 2, cell_height - 2, "none", outline);
  for (const long long sector : touched)
    canvas.rectangle(byte_x(sector * sector_bytes), top + cell_height + 3, double{sector_bytes} * byte_width,
                     mark_height, black);
}

/// @return the bottom of what was drawn; so do all that follow
double draw_memory(const LayoutMap& map, double y, Canvas& canvas) {
  canvas.text(memory_left - 12, y, "byte", {grey, 11, "end"});
  for (long long byte = 0; byte < row_bytes; byte += sector_bytes)
    canvas.text(byte_x(byte), y, "+" + std::to_string(byte), {grey, 11});
  y += 8;
  const Request request = first_request(map);
  long long next = 0;
  for (const long long row : shown_rows(map)) {
    if (row > next) {
      canvas.text(memory_left, y + 11, "... " + std::to_string((row - next) * row_bytes) + " bytes ...", {grey, 11});
      y += gap_height;
    }
    draw_row(map, request, row, y, canvas);
    y += row_height;
    next = row + 1;
  }
  canvas.text(memory_left, y + 9, "...", {grey, 11});
  y += 30;
  const Accessor& accessor = map.accessors[static_cast<std::size_t>(request.accessor)];
  canvas.text(memory_left, y,
              "Outlined: " + element_name(accessor, request.element) +
                  " of objects 0 to 31, one request of a warp. Each sector that it touches has a bar below.",
              {dark, 12});
  return y + 12;
}

double draw_table(const LayoutMap& map, double y, Canvas& canvas) {
  struct Column {
    const char* title;
    double x;
    const char* anchor;
  };
  constexpr double bar_x = 772;
  constexpr std::array<Column, 8> columns = {{{"field", memory_left + 22, "start"},
                                              {"elements", 400, "end"},
                                              {"format", 424, "start"},
                                              {"offset", 590, "end"},
                                              {"bytes", 650, "end"},
                                              {"sectors/request", bar_x - 12, "end"},
                                              {"of ideal", 1080, "end"},
                                              {"used of 32 B", page_width - margin, "end"}}};
  y += 14;
  for (const Column& column : columns) canvas.text(column.x, y, column.title, {grey, 11, column.anchor});
  canvas.line(memory_left, y + 5, page_width - margin, y + 5, light);
  for (std::size_t a = 0; a < map.accessors.size(); ++a) {
    const Accessor& accessor = map.accessors[a];
    y += table_row;
    canvas.rectangle(memory_left, y - 10, 14, 12, colour_of(static_cast<int>(a)).fill);
    const std::array<std::string, 8> texts = {fitting({accessor.name}, 210, 12),
                                              std::to_string(accessor.elements()),
                                              format_word(accessor, map.precision),
                                              std::to_string(accessor.offset(0)),
                                              std::to_string(accessor.elements() * accessor.bytes),
                                              sectors_words(accessor.sectors),
                                              fixed(over_ideal(accessor), 2) + "x",
                                              fixed(used_per_sector(accessor), 1)};
    for (std::size_t c = 0; c < texts.size(); ++c)
      canvas.text(columns[c].x, y, texts[c], {black, 12, columns[c].anchor});
    const double average = static_cast<double>(accessor.sectors.total) / accessor.elements();
    canvas.rectangle(bar_x, y - 10, average * sector_bar - 1, 12, light);
    canvas.rectangle(bar_x, y - 10, accessor.sectors.ideal * sector_bar - 1, 12, dark);
  }
  y += table_row + 2;
  std::string words = warp_words(map);
  words.front() = 'A';
  canvas.text(memory_left, y, words + ".", {dark, 12});
  return y;
}

double draw_map(const LayoutMap& map, double y, Canvas& canvas) {
  canvas.line(margin, y, page_width - margin, y, grey);
  y += 30;
  canvas.text(margin, y, map.object, {black, 18, "start", true});
  canvas.text(page_width - margin, y,
              layout_word(map.layout) + " on " + space_words(map) + ", Real = " + precision_word(map.precision),
              {black, 16, "end", true});
  y += 20;
  canvas.text(margin, y, record_words(map), {grey, 13});
  y += 26;
  y = draw_memory(map, y, canvas);
  y = draw_table(map, y, canvas);
  return y + 28;
}

double draw_legend(double y, Canvas& canvas) {
  canvas.text(margin, y, "Rows of 128 bytes in four sectors of 32, coloured by field.", {dark, 12});
  double x = 412;
  canvas.rectangle(x, y - 12, 30, 15, Canvas::hatched(), R"(stroke="#ccc")");
  canvas.text(x + 38, y, "padding", {dark, 12});
  x = 530;
  canvas.rectangle(x, y - 12, 30, 15, "none", outline);
  canvas.text(x + 38, y, "in the request", {dark, 12});
  x = 690;
  canvas.rectangle(x, y - 6, 30, mark_height, black);
  canvas.text(x + 38, y, "sector touched", {dark, 12});
  x = 856;
  canvas.rectangle(x, y - 11, 4 * sector_bar - 1, 12, dark);
  canvas.rectangle(x + 4 * sector_bar, y - 11, 4 * sector_bar - 1, 12, light);
  canvas.text(x + 8 * sector_bar + 8, y, "sectors: ideal, and too many", {dark, 12});
  return y + 20;
}

}  // namespace

std::string layout_svg(const std::vector<LayoutMap>& maps) {
  Canvas canvas(page_width, "Where arrays place every element");
  double y = draw_legend(32, canvas);
  for (const LayoutMap& map : maps) y = draw_map(map, y, canvas);
  return canvas.document(static_cast<int>(y));
}

}  // namespace physgen::command
