// The drawing of an array by `physgen layout`: one list of boxes, which stand for neighbouring bytes, and the words
// beside it. layout_text() draws the list for the terminal; layout_json() writes it for other tools, such as the one
// that draws pictures.
#pragma once

#include <string>
#include <vector>

#include "plan/layout_map.h"

namespace physgen::command {

using plan::Accessor;
using plan::LayoutMap;

/// The bytes [begin, end) of an array: elements of one object side by side, one element of objects side by side, or
/// bytes without data.
struct Box {
  long long begin = 0, end = 0;
  int field = -1;                     ///< number of the accessor; -1: padding
  int element = 0, elements = 0;      ///< the first one, of the accessor, and how many
  long long object = 0, objects = 0;  ///< the first one, and how many
  std::string text;                   ///< "+12 x[0]..[2]", "0..7", "-- 4 --"
};

/// A row of a drawing: boxes in order of their bytes. Bytes between two boxes are left out.
struct Row {
  std::string name;        ///< the boxes' object or element; "...", "... 5 more ...": rows that are left out
  std::vector<Box> boxes;  ///< none where rows are left out
};

/// The rows of a drawing, a row per object where records lie as a whole, else a row per element of the first tile. They
/// are at most 30, and show both ends of what is long.
[[nodiscard]] std::vector<Row> layout_rows(const LayoutMap& map);

/// For the terminal: at most 110 columns, unless a single name is longer than fits.
[[nodiscard]] std::string layout_text(const std::vector<LayoutMap>& maps);

/// The same as JSON, for other tools: rows of boxes with the names of their members, and the costs of each field.
/// tools/report/layout_picture.py draws it.
[[nodiscard]] std::string layout_json(const std::vector<LayoutMap>& maps);

// ---- Words ----

/// "host", "cuda", "host and cuda".
[[nodiscard]] std::string space_words(const LayoutMap& map);

/// "float" or "double".
[[nodiscard]] const char* precision_word(plan::Precision precision);

/// How elements are stored: "float", "half", "int", "quaternion", "quaternion(half)".
[[nodiscard]] std::string format_word(const Accessor& accessor, plan::Precision precision);

/// Which element of its run, behind the run's name: "", "[2]", "(0,1)", ".w"; entries of fixed arrays in front:
/// "[3](0,1)".
[[nodiscard]] std::string element_index(const Accessor& accessor, int element);

/// "F(0,1)", "points[2].x[0]".
[[nodiscard]] std::string element_name(const Accessor& accessor, int element);

/// "F(0,0)..(2,2)": all elements of a run, by its first and last.
[[nodiscard]] std::string run_name(const Accessor& accessor, int run);

/// "records of 28 bytes; tiles of 32 objects, 896 bytes": the order of things in memory.
[[nodiscard]] std::string record_words(const LayoutMap& map);

/// "all 9 requests: 288 sectors, 8.00x the ideal 36; 36 different ones": the costs of reading whole objects, without a
/// cache and with one that keeps everything.
[[nodiscard]] std::string warp_words(const LayoutMap& map);

/// Number with so many decimals.
[[nodiscard]] std::string fixed(double value, int decimals);

}  // namespace physgen::command
