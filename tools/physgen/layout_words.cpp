// See layout_words.h.
#include "layout_words.h"

#include <algorithm>
#include <cctype>
#include <cstdio>

#include "model/validate.h"

namespace physgen::command {
namespace {

using model::Shape;

/// Row and column of element k where columns of a triangle follow each other, `first` rows below the diagonal.
std::string triangle_index(int k, int n, int first) {
  int column = 0;
  while (k >= n - first - column) {
    k -= n - first - column;
    ++column;
  }
  return "(" + std::to_string(column + first + k) + "," + std::to_string(column) + ")";
}

/// Index of element k of one entry, as the shape's value takes it.
std::string index_in_entry(const Accessor& accessor, int k) {
  const model::Field& field = accessor.field;
  if (accessor.format.quaternion) return {'.', "wxyz"[k]};
  switch (field.shape) {
    case Shape::scalar:
    case Shape::object:
      return "";
    case Shape::vector:
    case Shape::diagonal:
      return "[" + std::to_string(k) + "]";
    case Shape::matrix:
    case Shape::rotation:
      return "(" + std::to_string(k % field.rows) + "," + std::to_string(k / field.rows) + ")";
    case Shape::symmetric:
      return triangle_index(k, field.rows, 0);
    case Shape::skew:
      return triangle_index(k, field.rows, 1);
  }
  return "";
}

std::string counted(long long count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

std::string layout_word(model::Layout layout) {
  switch (layout.kind) {
    case model::LayoutKind::aos:
      return "aos";
    case model::LayoutKind::aos_padded:
      return "aos_padded";
    case model::LayoutKind::soa:
      return "soa";
    case model::LayoutKind::aosoa:
      break;
  }
  return "aosoa(" + std::to_string(layout.tile) + ")";
}

model::Layout read_layout(const std::string& word) {
  for (const auto kind : {model::LayoutKind::aos, model::LayoutKind::aos_padded, model::LayoutKind::soa})
    if (word == layout_word({kind, 0})) return {kind, 0};
  const std::string begin = "aosoa(";
  if (word.starts_with(begin) && word.ends_with(')')) {
    const std::string tile = word.substr(begin.size(), word.size() - begin.size() - 1);
    const bool digits = !tile.empty() && tile.size() <= 4 &&
                        std::ranges::all_of(tile, [](unsigned char c) { return std::isdigit(c) != 0; });
    if (digits && std::stoi(tile) >= 2 && model::is_power_of_two_up_to(std::stoi(tile), model::max_tile))
      return {model::LayoutKind::aosoa, std::stoi(tile)};
    throw LayoutError("the tile of '" + word + "' is no power of two from 2 to 1024; write 'aosoa(16)' or 'aosoa(32)'");
  }
  throw LayoutError("there is no layout '" + word + "'; write aos, aos_padded, soa, 'aosoa(32)' or all");
}

std::string space_words(const LayoutMap& map) {
  std::string words;
  for (const model::Space space : map.spaces) {
    if (!words.empty()) words += " and ";
    words += space == model::Space::host ? "host" : "cuda";
  }
  return words;
}

const char* precision_word(Precision precision) { return precision == Precision::with_float ? "float" : "double"; }

std::string format_word(const Accessor& accessor, Precision precision) {
  std::string word = "int";
  switch (accessor.format.encoding) {
    case model::Encoding::float32:
      word = "float";
      break;
    case model::Encoding::float64:
      word = "double";
      break;
    case model::Encoding::half:
      word = "half";
      break;
    case model::Encoding::bfloat16:
      word = "bfloat16";
      break;
    case model::Encoding::snorm16:
      word = "snorm16";
      break;
    case model::Encoding::native:
      if (accessor.field.element == model::Element::real) word = precision_word(precision);
      if (accessor.field.element == model::Element::float32) word = "float";
      if (accessor.field.element == model::Element::float64) word = "double";
      break;
  }
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

std::string sectors_words(const Sectors& sectors) {
  const std::string fewest = std::to_string(sectors.fewest);
  return sectors.fewest == sectors.most ? fewest : fewest + "-" + std::to_string(sectors.most);
}

std::string fixed(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

double over_ideal(const Accessor& accessor) {
  return static_cast<double>(accessor.sectors.total) / (1.0 * accessor.elements() * accessor.sectors.ideal);
}

double used_per_sector(const Accessor& accessor) { return sector_bytes / over_ideal(accessor); }

std::string record_words(const LayoutMap& map) {
  std::string words = "records of " + counted(map.record_bytes, "byte");
  if (const int padding = map.padding_bytes(); padding > 0)
    words += ", " + std::to_string(padding) + " of them padding";
  if (map.layout.kind == model::LayoutKind::aosoa)
    words += "; tiles of " + std::to_string(map.pitch) + " objects, " + std::to_string(map.pitch * map.record_bytes) +
             " bytes";
  if (map.layout.kind == model::LayoutKind::soa)
    words += "; pitch " + std::to_string(map.pitch) + " for " + std::to_string(assumed_objects) + " objects";
  return words;
}

std::string warp_words(const LayoutMap& map) {
  long long total = 0;
  long long ideal = 0;
  for (const Accessor& accessor : map.accessors) {
    total += accessor.sectors.total;
    ideal += 1LL * accessor.elements() * accessor.sectors.ideal;
  }
  return "all " + counted(map.elements(), "request") + ": " + counted(total, "sector") + ", " +
         fixed(static_cast<double>(total) / static_cast<double>(ideal), 2) + "x the ideal " + std::to_string(ideal) +
         "; " + std::to_string(sectors_of_warp(map)) + " different ones";
}

}  // namespace physgen::command
