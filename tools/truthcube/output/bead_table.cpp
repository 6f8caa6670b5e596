// Reading does not depend on the locale.
#include <physgen/error.h>
#include <truthcube/output/bead_table.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace physgen::truthcube {

namespace {

constexpr std::array<std::string_view, 7> column_names{"x", "y", "z", "ux", "uy", "uz", "compression"};
constexpr std::size_t required_columns = 6;
constexpr std::string_view expected_header = "x,y,z,ux,uy,uz and, if there is one, compression";

// The place of a message: "beads.csv:12: ".
std::string at(const std::filesystem::path& file, int line) {
  return file.string() + ":" + std::to_string(line) + ": ";
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// The content of a cell, quoted, as a terminal can show it.
std::string quoted(std::string_view cell) {
  constexpr std::size_t most = 40;
  std::string text(cell.substr(0, most));
  std::ranges::replace_if(text, [](unsigned char c) { return c < ' ' || c > '~'; }, '?');
  return "\"" + text + (cell.size() > most ? "...\"" : "\"");
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (;;) {
    const std::size_t comma = line.find(',');
    cells.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

// For each column of the file, which of column_names it is.
std::vector<std::size_t> read_header(std::string_view line, const std::string& place) {
  if (line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);  // the mark that some programs put before UTF-8
  std::vector<std::size_t> columns;
  for (const std::string_view cell : cells_of(line)) {
    const auto name = std::ranges::find(column_names, cell);
    const auto column = static_cast<std::size_t>(name - column_names.begin());
    if (name == column_names.end()) {
      throw Error(place + "unknown column " + quoted(cell) + "; columns are " + std::string(expected_header) +
                  ", separated by commas");
    }
    if (std::ranges::find(columns, column) != columns.end()) {
      throw Error(place + "the column " + std::string(cell) + " is there twice");
    }
    columns.push_back(column);
  }
  for (std::size_t c = 0; c < required_columns; ++c) {
    if (std::ranges::find(columns, c) == columns.end()) {
      throw Error(place + "no column " + std::string(column_names[c]) + "; columns are " +
                  std::string(expected_header));
    }
  }
  return columns;
}

double read_number(std::string_view cell, std::string_view column, const std::string& place) {
  std::string_view digits = cell;
  if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value)) {
    throw Error(place + quoted(cell) + " in column " + std::string(column) + " is not a finite number");
  }
  return value;
}

// A bead with two displacements would count twice in every measure.
void require_one_row_per_bead(const BeadTable& table) {
  std::vector<const BeadRow*> rows;
  rows.reserve(table.rows.size());
  for (const BeadRow& row : table.rows) rows.push_back(&row);
  const auto key = [](const BeadRow* row) { return std::pair(row->compression, row->rest); };
  std::ranges::stable_sort(rows, {}, key);
  const auto found = std::ranges::adjacent_find(rows, {}, key);
  if (found == rows.end()) return;
  const BeadRow &first = **found, &second = **(found + 1);
  throw Error(at(table.file, second.line) + "this bead has a displacement " +
              (first.compression ? "at the same compression " : "") + "in line " + std::to_string(first.line) +
              ", too: remove one of them" +
              (first.compression ? "" : ", or say in a column compression to which step each belongs"));
}

}  // namespace

BeadTable read_bead_table(const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file))
    throw Error(file.string() + ": cannot be read as a bead table: it is a folder");
  std::ifstream stream(file);
  if (!stream) {
    throw Error(file.string() + ": cannot be read as a bead table: " + std::generic_category().message(errno));
  }
  BeadTable table{file, {}};
  std::vector<std::size_t> columns;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    const std::string place = at(file, ++number);
    if (trimmed(line).empty()) continue;
    if (columns.empty()) {
      columns = read_header(line, place);
      continue;
    }
    const std::vector<std::string_view> cells = cells_of(line);
    if (cells.size() != columns.size()) {
      throw Error(place + std::to_string(cells.size()) + " values for " + std::to_string(columns.size()) + " columns");
    }
    std::array<double, column_names.size()> values{};
    std::optional<double> compression;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      values[columns[c]] = read_number(cells[c], column_names[columns[c]], place);
      if (columns[c] == required_columns) compression = values[columns[c]];
    }
    table.rows.push_back({{values[0], values[1], values[2]}, {values[3], values[4], values[5]}, compression, number});
  }
  if (stream.bad()) throw Error(file.string() + ": cannot be read to its end");
  if (table.rows.empty()) throw Error(file.string() + ": has no rows of beads");
  require_one_row_per_bead(table);
  return table;
}

std::vector<fem::Location> locate_beads(const BeadTable& table, std::span<const fem::Point> rest,
                                        const fem::TetMesh& mesh) {
  std::vector<fem::Point> points;
  points.reserve(table.rows.size());
  for (const BeadRow& row : table.rows) points.push_back(row.rest);
  try {
    return fem::locate(rest, mesh, points);
  } catch (const fem::OutsideMesh& outside) {
    throw Error(at(table.file, table.rows[outside.point()].line) + "this bead lies outside the mesh (are its " +
                "coordinates in metres?): " + outside.what());
  }
}

std::optional<BeadErrors> compare_beads(const BeadTable& table, double compression,
                                        std::span<const fem::Point> computed) {
  if (computed.size() != table.rows.size()) {
    throw Error(table.file.string() + ": " + std::to_string(computed.size()) + " displacements for " +
                std::to_string(table.rows.size()) + " rows");
  }
  constexpr double same_compression = 1e-6;
  constexpr double millimetres = 1e3;
  std::vector<double> errors;
  for (std::size_t r = 0; r < computed.size(); ++r) {
    const BeadRow& row = table.rows[r];
    if (row.compression && std::abs(*row.compression - compression) > same_compression) continue;
    errors.push_back(millimetres * std::hypot(row.displacement[0] - computed[r][0],
                                              row.displacement[1] - computed[r][1],
                                              row.displacement[2] - computed[r][2]));
  }
  if (errors.empty()) return std::nullopt;
  std::ranges::sort(errors);
  const auto count = static_cast<double>(errors.size());
  double sum = 0;
  double squares = 0;
  for (const double e : errors) {
    sum += e;
    squares += e * e;
  }
  const std::size_t rank95 = (errors.size() * 95 + 99) / 100;  // rounded up
  return BeadErrors{errors.size(), sum / count, std::sqrt(squares / count), errors[rank95 - 1], errors.back()};
}

}  // namespace physgen::truthcube
