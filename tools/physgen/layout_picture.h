// Pictures of where elements lie, for `physgen layout`: which arrays to show, and the two ways to draw them.
#pragma once

#include <string>
#include <vector>

#include "layout_words.h"

namespace physgen::command {

/// Which arrays to draw, in the words of the command line.
struct LayoutRequest {
  std::vector<std::string> objects;  ///< with or without namespaces; empty: all of the schema's own
  std::string space = "both";        ///< host, cuda or both
  std::string real = "float";        ///< float or double
  std::string layout;                ///< empty: the object's own; all; or a layout
};

/// One map per object, layout and space; one for both spaces where they are the same.
/// @throws LayoutError
[[nodiscard]] std::vector<LayoutMap> layout_maps(const model::Schema& schema, const LayoutRequest& request);

/// For the terminal: at most 110 columns, unless a single name is longer than fits.
[[nodiscard]] std::string layout_text(const std::vector<LayoutMap>& maps);

/// One SVG document that needs no other file.
[[nodiscard]] std::string layout_svg(const std::vector<LayoutMap>& maps);

}  // namespace physgen::command
