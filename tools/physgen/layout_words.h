// The words of `physgen layout`: layouts, formats and elements as people write and read them.
#pragma once

#include <stdexcept>
#include <string>

#include "plan/layout_map.h"

namespace physgen::command {

using plan::Accessor;
using plan::assumed_objects;
using plan::Cell;
using plan::LayoutMap;
using plan::Precision;
using plan::sector_bytes;
using plan::Sectors;
using plan::Segment;
using plan::warp_objects;

/// A wrong word; what() says what to write instead.
struct LayoutError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The layout that model::layout_word() writes so. @throws LayoutError
[[nodiscard]] model::Layout read_layout(const std::string& word);

/// The layout of a word that read_layout() takes, in a space; a tiled one without its tile has that of the space's
/// standard layout: "aosoa" is aosoa(16) on the host and aosoa(32) on CUDA. @throws LayoutError
[[nodiscard]] model::Layout read_layout(const std::string& word, model::Space space);

/// The words that this takes, for messages: "aos, aos_padded, soa, aosoa or 'aosoa(32)'".
[[nodiscard]] std::string layout_choices_of_a_space();

/// "host, cuda or both".
[[nodiscard]] std::string space_choices();

/// The words that read_layout() takes, and "all", for messages: "aos, aos_padded, soa, 'aosoa(32)' or all".
[[nodiscard]] std::string layout_choices();

/// "host", "cuda", "host and cuda".
[[nodiscard]] std::string space_words(const LayoutMap& map);

/// "float" or "double".
[[nodiscard]] const char* precision_word(Precision precision);

/// How elements are stored: "float", "half", "int", "quaternion", "quaternion(half)".
[[nodiscard]] std::string format_word(const Accessor& accessor, Precision precision);

/// Which element of its run, behind the run's name: "", "[2]", "(0,1)", ".w"; entries of fixed arrays in front:
/// "[3](0,1)".
[[nodiscard]] std::string element_index(const Accessor& accessor, int element);

/// "F(0,1)", "points[2].x[0]".
[[nodiscard]] std::string element_name(const Accessor& accessor, int element);

/// "F(0,0)..(2,2)": all elements of a run, by its first and last.
[[nodiscard]] std::string run_name(const Accessor& accessor, int run);

/// The sectors that a request costs: "4", "12-13".
[[nodiscard]] std::string sectors_words(const Sectors& sectors);

/// Number with so many decimals.
[[nodiscard]] std::string fixed(double value, int decimals);

/// How often the ideal number of sectors a request takes on average.
[[nodiscard]] double over_ideal(const Accessor& accessor);

/// Bytes that a request uses of each sector on average.
[[nodiscard]] double used_per_sector(const Accessor& accessor);

/// "records of 28 bytes; tiles of 32 objects, 896 bytes": what follows what in memory.
[[nodiscard]] std::string record_words(const LayoutMap& map);

/// "all 9 requests: 288 sectors, 8.00x the ideal 36; 36 different ones": what reading whole objects costs, without a
/// cache and with one that keeps everything.
[[nodiscard]] std::string warp_words(const LayoutMap& map);

}  // namespace physgen::command
