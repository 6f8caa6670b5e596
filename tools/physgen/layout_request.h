// Which arrays `physgen layout` shows, and the words of the command line that say so.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "plan/layout_map.h"

namespace physgen::command {

/// A wrong word; what() says what to write instead.
struct LayoutError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The arrays to show, in the words of the command line.
struct LayoutRequest {
  std::vector<std::string> objects;  ///< with or without namespaces; empty: all of the schema's own
  std::string space = "both";        ///< host, cuda or both
  std::string real = "float";        ///< float or double
  std::string layout;                ///< empty: the object's own; all; or a word of read_layout()
};

/// One map per object, layout and space; one for both spaces where they are the same.
/// @throws LayoutError
[[nodiscard]] std::vector<plan::LayoutMap> layout_maps(const model::Schema& schema, const LayoutRequest& request);

/// The layout of a word in a space; a tiled one without its tile has that of the space's standard layout: "aosoa" is
/// aosoa(16) on the host and aosoa(32) on CUDA. @throws LayoutError
[[nodiscard]] model::Layout read_layout(const std::string& word, model::Space space);

/// The words that read_layout() takes, for messages: "aos, aos_padded, soa, 'aosoa(32)' or aosoa".
[[nodiscard]] std::string layout_choices_of_a_space();

/// "aosoa(16) on the host and aosoa(32) on CUDA".
[[nodiscard]] std::string standard_layouts();

/// The words of LayoutRequest::layout, for messages: "aos, aos_padded, soa, 'aosoa(32)', aosoa or all".
[[nodiscard]] std::string layout_choices();

/// "host, cuda or both".
[[nodiscard]] std::string space_choices();

}  // namespace physgen::command
