// Reading the catalogue: its rows, by enumerator and by word, and lists of its words for messages and help.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/catalog.h"

namespace physgen::model {

/// All rows, in the order of the enumerators.
[[nodiscard]] std::span<const SpaceFacts> spaces();
[[nodiscard]] std::span<const LayoutFacts> layouts();
[[nodiscard]] std::span<const EncodingFacts> encodings();
[[nodiscard]] std::span<const ShapeFacts> shapes();
[[nodiscard]] std::span<const ElementFacts> elements();

/// The row of one. @throws std::invalid_argument if the value is not an enumerator
[[nodiscard]] const SpaceFacts& facts(Space space);
[[nodiscard]] const LayoutFacts& facts(LayoutKind kind);
[[nodiscard]] const EncodingFacts& facts(Encoding encoding);
[[nodiscard]] const ShapeFacts& facts(Shape shape);
[[nodiscard]] const ElementFacts& facts(Element element);

/// The row whose `word` this is; null: there is none.
template <class Facts>
[[nodiscard]] const Facts* find_word(std::span<const Facts> rows, std::string_view word) {
  for (const Facts& row : rows)
    if (row.word == word) return &row;
  return nullptr;
}

// ---- Lists for messages and help ----

/// "aosoa(32)", "soa".
[[nodiscard]] std::string layout_word(Layout layout);

/// The words of all layouts, with this in the brackets of tiled ones: "aos", ..., "aosoa(W)".
[[nodiscard]] std::vector<std::string> layout_words(std::string_view tile);

/// The arguments of format(...) besides quaternion(...): "float32", "float64", "half", ...
[[nodiscard]] std::vector<std::string> encoding_words();

/// Element types, as a schema names them; those of integers, or those of real numbers: "Index", "int".
[[nodiscard]] std::vector<std::string> element_types(bool integers);

/// Types of fields, as a schema names them: "Scalar", "Vector<N>", "Matrix<R, C>", ..., "Index", "float", ...
[[nodiscard]] std::vector<std::string> field_types();

}  // namespace physgen::model
