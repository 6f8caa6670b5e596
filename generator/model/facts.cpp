// See facts.h.
#include "model/facts.h"

#include <stdexcept>

namespace physgen::model {
namespace {

// A row is found by its number.
template <class Facts, std::size_t N>
consteval bool in_order(const Facts (&rows)[N]) {
  for (std::size_t i = 0; i < N; ++i)
    if (static_cast<std::size_t>(rows[i].key) != i) return false;
  return true;
}
static_assert(in_order(space_rows), "the rows of spaces stand in the order of their enumerators");
static_assert(in_order(layout_rows), "the rows of layouts stand in the order of their enumerators");
static_assert(in_order(encoding_rows), "the rows of encodings stand in the order of their enumerators");
static_assert(in_order(shape_rows), "the rows of shapes stand in the order of their enumerators");
static_assert(in_order(element_rows), "the rows of element types stand in the order of their enumerators");

template <class Facts, std::size_t N, class Key>
const Facts& at(const Facts (&rows)[N], Key key) {
  const auto number = static_cast<std::size_t>(key);
  if (number >= N) throw std::invalid_argument("the catalogue has no row " + std::to_string(number) + " of its kind");
  return rows[number];
}

std::string schema_type(const ShapeFacts& shape) {
  const char* sizes = shape.sides == Sides::fixed ? "" : shape.sides == Sides::any ? "<R, C>" : "<N>";
  return std::string(shape.type) + sizes;
}

}  // namespace

std::span<const SpaceFacts> spaces() { return space_rows; }
std::span<const LayoutFacts> layouts() { return layout_rows; }
std::span<const EncodingFacts> encodings() { return encoding_rows; }
std::span<const ShapeFacts> shapes() { return shape_rows; }
std::span<const ElementFacts> elements() { return element_rows; }

const SpaceFacts& facts(Space space) { return at(space_rows, space); }
const LayoutFacts& facts(LayoutKind kind) { return at(layout_rows, kind); }
const EncodingFacts& facts(Encoding encoding) { return at(encoding_rows, encoding); }
const ShapeFacts& facts(Shape shape) { return at(shape_rows, shape); }
const ElementFacts& facts(Element element) { return at(element_rows, element); }

std::string layout_word(Layout layout) {
  const LayoutFacts& row = facts(layout.kind);
  return std::string(row.word) + (row.tiled ? "(" + std::to_string(layout.tile) + ")" : "");
}

std::vector<std::string> layout_words(std::string_view tile) {
  std::vector<std::string> words;
  for (const LayoutFacts& row : layout_rows) {
    words.emplace_back(row.word);
    if (row.tiled) words.back().append("(").append(tile).append(")");
  }
  return words;
}

std::vector<std::string> encoding_words() {
  std::vector<std::string> words;
  for (const EncodingFacts& row : encoding_rows)
    if (row.key != Encoding::native) words.emplace_back(row.word);
  return words;
}

std::vector<std::string> element_types(bool integers) {
  std::vector<std::string> types;
  for (const ElementFacts& row : element_rows)
    if (row.integer == integers) types.emplace_back(row.schema);
  return types;
}

std::vector<std::string> field_types() {
  std::vector<std::string> types{std::string(facts(Element::real).schema)};
  for (const ShapeFacts& row : shape_rows)
    if (row.key != Shape::scalar && !row.type.empty()) types.push_back(schema_type(row));
  for (const ElementFacts& row : element_rows)
    if (row.key != Element::real) types.emplace_back(row.schema);
  return types;
}

}  // namespace physgen::model
