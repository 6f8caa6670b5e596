// See npy_header.h. The format is NumPy's: numpy.org, "numpy.lib.format".
#include "npy_header.h"

#include <physgen/error.h>

#include <array>
#include <charconv>
#include <istream>
#include <limits>
#include <string_view>
#include <vector>

namespace physgen::files {

namespace {

constexpr std::string_view magic = "\x93NUMPY";

struct Row {
  ElementType type;
  std::string_view word;
};
constexpr std::array types{Row{ElementType::float32, "<f4"}, Row{ElementType::float64, "<f8"},
                           Row{ElementType::half, "<f2"},    Row{ElementType::int32, "<i4"},
                           Row{ElementType::int64, "<i8"},   Row{ElementType::uint64, "<u8"},
                           Row{ElementType::boolean, "|b1"}};

std::string read_bytes(std::istream& in, std::size_t count, const std::string& place) {
  std::string bytes(count, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(count));
  if (!in) throw Error(place + ": ends within its header; it is truncated, or no .npy file");
  return bytes;
}

/// What stands behind 'key': in the text of a dictionary.
std::string_view behind(std::string_view text, std::string_view key, const std::string& place) {
  const std::string quoted = "'" + std::string(key) + "':";
  const std::size_t at = text.find(quoted);
  if (at == std::string_view::npos) throw Error(place + ": its header has no " + std::string(key) + "; it is damaged");
  std::string_view rest = text.substr(at + quoted.size());
  rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
  return rest;
}

/// The numbers of "(3, 4)".
std::vector<std::int64_t> shape_in(std::string_view text, const std::string& place) {
  const std::string_view inner = text.substr(0, text.find(')'));
  if (inner.size() == text.size() || !inner.starts_with('('))
    throw Error(place + ": its header has no shape; it is damaged");
  std::vector<std::int64_t> shape;
  for (const char* at = inner.data() + 1; at < inner.data() + inner.size();) {
    std::int64_t extent = 0;
    const auto [end, error] = std::from_chars(at, inner.data() + inner.size(), extent);
    if (error != std::errc() || extent < 0)
      throw Error(place + ": its header has a shape of no numbers; it is damaged");
    shape.push_back(extent);
    for (at = end; at < inner.data() + inner.size() && (*at == ',' || *at == ' ');) ++at;
  }
  return shape;
}

}  // namespace

bool is_npy_type(ElementType type) {
  for (const Row& row : types)
    if (row.type == type) return true;
  return false;
}

std::string npy_header(const NpyTable& table) {
  std::string_view word;
  for (const Row& row : types)
    if (row.type == table.type) word = row.word;
  std::string text = "{'descr': '" + std::string(word) + "', 'fortran_order': False, 'shape': (" +
                     std::to_string(table.rows) + "," + (table.flat ? "" : " " + std::to_string(table.columns)) +
                     "), }";
  constexpr std::size_t before = 10;  // magic, version and length
  text.resize(align_up(before + text.size() + 1, std::size_t{64}) - before - 1, ' ');
  text += '\n';
  std::string header(magic);
  header += {'\x01', '\x00', static_cast<char>(text.size() & 0xff), static_cast<char>(text.size() >> 8)};
  return header + text;
}

NpyTable read_npy_header(std::istream& in, const std::string& place) {
  const std::string head = read_bytes(in, magic.size() + 2, place);
  if (!head.starts_with(magic)) throw Error(place + ": is no .npy file; write one by numpy.save() or save_npy()");
  const int version = static_cast<unsigned char>(head[magic.size()]);
  if (version < 1 || version > 3)
    throw Error(place + ": is a .npy file of version " + std::to_string(version) + "; this library reads 1 to 3");
  std::size_t length = 0;
  const std::string written = read_bytes(in, version == 1 ? 2 : 4, place);
  for (std::size_t b = 0; b < written.size(); ++b)
    length |= static_cast<std::size_t>(static_cast<unsigned char>(written[b])) << (8 * b);
  constexpr std::size_t longest = 1 << 16;
  if (length > longest) throw Error(place + ": its header has " + std::to_string(length) + " bytes; it is damaged");
  const std::string text = read_bytes(in, length, place);

  NpyTable table;
  const std::string_view described = behind(text, "descr", place);
  const std::string word(described.substr(0, described.find(',')));  // with its quotes
  bool known = false;
  for (const Row& row : types) {
    if (word != "'" + std::string(row.word) + "'") continue;
    table.type = row.type;
    known = true;
  }
  if (!known) {
    throw Error(place + ": holds numbers of type " + word +
                "; convert them by .astype() to one of '<f2', '<f4', '<f8', '<i4', '<i8', '<u8' and 'bool'");
  }
  const std::vector<std::int64_t> shape = shape_in(behind(text, "shape", place), place);
  constexpr std::int64_t most = std::numeric_limits<int>::max() / 8;
  if (shape.empty() || shape.size() > 2 || (shape.size() == 2 && shape[1] > most)) {
    throw Error(place + ": has " + std::to_string(shape.size()) +
                " dimensions, or too many columns; a field is a row for each object: .reshape(objects, elements)");
  }
  table.rows = shape[0];
  table.flat = shape.size() == 1;
  if (!table.flat) table.columns = static_cast<int>(shape[1]);
  if (!table.flat && table.columns != 1 && behind(text, "fortran_order", place).starts_with("True")) {
    throw Error(place + ": stands in Fortran's order, column by column; save numpy.ascontiguousarray() of it");
  }
  return table;
}

}  // namespace physgen::files
