// The catalogue: the closed sets of the domain, with one row for every memory space, layout, encoding, shape and
// element type. What JSON, the frontend, validation, plan, emitters, help texts and the drawings of `physgen layout`
// know of one of them is its row. A new one is an enumerator and a row here; generator/README.md lists what else it
// takes.
#pragma once

#include <array>
#include <cfloat>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace physgen::model {

// ---- Layouts
// ---------------------------------------------------------------------------------------------------------

enum class LayoutKind { aos, aos_padded, soa, aosoa };

/// How an array of objects lies in memory; `tile` is the objects per tile of an aosoa (a power of two), else 0.
struct Layout {
  LayoutKind kind = LayoutKind::aos;
  int tile = 0;
  bool operator==(const Layout&) const = default;
};

namespace detail {

template <class Number>
[[nodiscard]] constexpr Number align_up(Number value, Number step) {
  return (value + step - 1) / step * step;
}

// The functions of the runtime's layouts; tests compare the two.
constexpr long long pitch_of_records(long long /*objects*/, int /*tile*/) { return 1; }
constexpr long long pitch_of_tiles(long long /*objects*/, int tile) { return tile; }
constexpr long long pitch_of_arrays(long long objects, int /*tile*/) {  // whole warps, and no multiple of a page
  const long long whole = align_up(objects, 32LL);
  return whole > 0 && whole % 512 == 0 ? whole + 32 : whole;
}
constexpr int packed_record(int bytes, int /*alignment*/, int /*tile*/) { return bytes; }
constexpr int aligned_record(int bytes, int alignment, int /*tile*/) { return align_up(bytes, alignment); }
constexpr int padded_record(int bytes, int alignment, int /*tile*/) {
  return align_up(bytes, alignment < 16 ? 16 : alignment);
}
constexpr int tiled_record(int bytes, int /*alignment*/, int tile) { return tile == 2 ? align_up(bytes, 4) : bytes; }

}  // namespace detail

struct LayoutFacts {
  LayoutKind key;
  std::string_view word;  ///< of the schema, of JSON and of the command line: "aosoa"
  std::string_view type;  ///< in namespace physgen: "Aosoa"
  bool tiled;             ///< both take the objects of a tile: aosoa(32), Aosoa<32>
  long long (*pitch)(long long objects, int tile);
  int (*record_bytes)(int bytes, int alignment, int tile);  ///< of the packed bytes of a record
};

inline constexpr LayoutFacts layout_rows[] = {
    {LayoutKind::aos, "aos", "Aos", false, detail::pitch_of_records, detail::aligned_record},
    {LayoutKind::aos_padded, "aos_padded", "AosPadded", false, detail::pitch_of_records, detail::padded_record},
    {LayoutKind::soa, "soa", "Soa", false, detail::pitch_of_arrays, detail::packed_record},
    {LayoutKind::aosoa, "aosoa", "Aosoa", true, detail::pitch_of_tiles, detail::tiled_record},
};

// ---- Memory spaces
// ---------------------------------------------------------------------------------------------------

/// The memory spaces that layouts and formats are stated for.
enum class Space { host, cuda };

struct SpaceFacts {
  Space key;
  std::string_view word;   ///< of the schema and of the command line
  std::string_view type;   ///< in namespace physgen
  std::string_view place;  ///< "on the host"
  Layout standard;         ///< of objects whose schema names none
};

inline constexpr SpaceFacts space_rows[] = {
    {Space::host, "host", "Host", "on the host", {LayoutKind::aosoa, 16}},
    {Space::cuda, "cuda", "Cuda", "on CUDA", {LayoutKind::aosoa, 32}},
};

// ---- Encodings
// -------------------------------------------------------------------------------------------------------

enum class Encoding { native, float32, float64, half, bfloat16, snorm16 };

/// What of a field's range goes into its format.
enum class Scaling {
  none,
  exponent,  ///< the power of two that brings its larger end just below the largest number: Half<4>
  interval   ///< the range itself, which such a field must state: Snorm16<Interval{0.0, 1.0}>
};

/// Formats of Scaling::exponent are scaled by 2^-max_exponent to 2^max_exponent.
inline constexpr int max_exponent = 100;

struct EncodingFacts {
  Encoding key;
  std::string_view word;        ///< of the schema and of JSON: "half"
  std::string_view type;        ///< in namespace physgen::format: "Half"
  std::string_view quaternion;  ///< there, a name for quaternions of such components; empty: Quaternion<type>
  int bytes;                    ///< of an element; 0: as many as are computed with
  Scaling scaling;
  double largest;                   ///< finite size that is kept, before scaling; of steps: that is computed with
  double least;                     ///< size that is kept with all bits, for Scaling::exponent
  int steps;                        ///< over the range, for Scaling::interval
  std::string_view name;            ///< in comments and drawings: "half"; empty: the element's own
  std::string_view components;      ///< of a quaternion, in comments: "halves"
  std::string_view relative_error;  ///< largest, in comments; empty: absolute, half a step
  std::string_view rotation_error;  ///< largest of an entry of a rotation that is stored as a quaternion, in comments
};

inline constexpr double no_limit = std::numeric_limits<double>::infinity();

inline constexpr EncodingFacts encoding_rows[] = {
    {Encoding::native, "native", "Native", "", 0, Scaling::none, no_limit, 0, 0, "", "", "", "10 eps"},
    {Encoding::float32, "float32", "Float32", "", 4, Scaling::none, FLT_MAX, 0, 0, "float", "floats", "6e-8", "1.2e-6"},
    {Encoding::float64, "float64", "Float64", "", 8, Scaling::none, no_limit, 0, 0, "double", "doubles", "1.2e-16",
     "10 eps"},
    {Encoding::half, "half", "Half", "", 2, Scaling::exponent, 65504, 6.104e-5, 0, "half", "halves", "4.9e-4", "2e-3"},
    {Encoding::bfloat16, "bfloat16", "Bfloat16", "", 2, Scaling::none, 0x1.FEp127, 0, 0, "bfloat16", "bfloat16",
     "3.9e-3", "1.6e-2"},
    {Encoding::snorm16, "snorm16", "Snorm16", "Quaternion16", 2, Scaling::interval, FLT_MAX, 0, 65534, "16-bit steps",
     "16-bit steps", "", "9e-5"},
};

// ---- Shapes
// ----------------------------------------------------------------------------------------------------------

/// The structure of a field; it decides how many elements are stored.
enum class Shape { scalar, vector, matrix, symmetric, diagonal, skew, rotation, object };

/// Which rows and columns a shape can have, and how many sizes a schema states.
enum class Sides {
  fixed,   ///< always the same, none are stated: Rotation
  column,  ///< N x 1: Vector<N>
  any,     ///< R x C: Matrix<R, C>
  square   ///< N x N: Symmetric<N>
};

/// Where an element stands in a value, counted from 0.
struct Entry {
  int row = 0;
  int column = 0;
};

namespace detail {

constexpr int all_entries(int rows, int cols) { return rows * cols; }
constexpr int one_column(int rows, int /*cols*/) { return rows; }
constexpr int lower_triangle(int rows, int /*cols*/) { return rows * (rows + 1) / 2; }
constexpr int strictly_lower_triangle(int rows, int /*cols*/) { return rows * (rows - 1) / 2; }

constexpr Entry by_columns(int k, int rows) { return {k % rows, k / rows}; }
constexpr Entry in_triangle(int k, int rows, int first) {  // columns that begin `first` rows below the diagonal
  int column = 0;
  for (; k >= rows - first - column; ++column) k -= rows - first - column;
  return {column + first + k, column};
}
constexpr Entry in_lower_triangle(int k, int rows) { return in_triangle(k, rows, 0); }
constexpr Entry in_strictly_lower_triangle(int k, int rows) { return in_triangle(k, rows, 1); }

}  // namespace detail

struct ShapeFacts {
  Shape key;
  std::string_view word;    ///< of JSON: "symmetric"
  std::string_view type;    ///< in physgen::schema, and in physgen::shape: "Symmetric"; empty: it has none
  std::string_view phrase;  ///< "symmetric": what a comment adds to what the type of the value says; empty: nothing
  Sides sides;
  int side;                          ///< both sides of Sides::fixed, else the least that stores anything
  int (*count)(int rows, int cols);  ///< of stored elements
  Entry (*entry)(int k, int rows);   ///< where element k stands
  bool column;                       ///< the value is a column of `rows` entries, else a matrix of rows x cols
  bool integers;                     ///< its elements may be integers
  bool uniform;                      ///< equal elements make a value of equal entries
};

inline constexpr ShapeFacts shape_rows[] = {
    {Shape::scalar, "scalar", "Scalar", "", Sides::fixed, 1, detail::all_entries, detail::by_columns, false, true,
     true},
    {Shape::vector, "vector", "Vector", "", Sides::column, 1, detail::one_column, detail::by_columns, true, true, true},
    {Shape::matrix, "matrix", "Matrix", "", Sides::any, 1, detail::all_entries, detail::by_columns, false, true, true},
    {Shape::symmetric, "symmetric", "Symmetric", "symmetric", Sides::square, 1, detail::lower_triangle,
     detail::in_lower_triangle, false, true, true},
    {Shape::diagonal, "diagonal", "Diagonal", "diagonal", Sides::square, 1, detail::one_column, detail::by_columns,
     true, true, true},
    {Shape::skew, "skew", "Skew", "skew-symmetric", Sides::square, 2, detail::strictly_lower_triangle,
     detail::in_strictly_lower_triangle, false, true, false},
    {Shape::rotation, "rotation", "Rotation", "rotation", Sides::fixed, 3, detail::all_entries, detail::by_columns,
     false, false, true},
    {Shape::object, "object", "", "", Sides::any, 1, nullptr, nullptr, false, true, true},
};

// ---- Element types
// ---------------------------------------------------------------------------------------------------

/// The type of one stored element. `real` is the precision that the scene chooses (float or double).
enum class Element { real, index, float32, float64, int32 };

struct ElementFacts {
  Element key;
  std::string_view word;    ///< of JSON: "float32"
  std::string_view schema;  ///< "float"; of a vocabulary type, its name in physgen::schema
  std::string_view type;    ///< of C++: "std::int32_t"
  std::string_view name;    ///< in drawings; empty: the precision of the scene
  int bytes_with_float;     ///< where Real is float
  int bytes_with_double;
  bool integer;
};

inline constexpr ElementFacts element_rows[] = {
    {Element::real, "real", "Scalar", "Real", "", 4, 8, false},
    {Element::index, "index", "Index", "std::int32_t", "int", 4, 4, true},
    {Element::float32, "float32", "float", "float", "float", 4, 4, false},
    {Element::float64, "float64", "double", "double", "double", 8, 8, false},
    {Element::int32, "int32", "int", "std::int32_t", "int", 4, 4, true},
};

// ---- Reading the catalogue
// -------------------------------------------------------------------------------------------

/// All rows, in the order of the enumerators.
[[nodiscard]] std::span<const SpaceFacts> spaces();
[[nodiscard]] std::span<const LayoutFacts> layouts();
[[nodiscard]] std::span<const EncodingFacts> encodings();
[[nodiscard]] std::span<const ShapeFacts> shapes();
[[nodiscard]] std::span<const ElementFacts> elements();

/// The row of one. @throws std::invalid_argument if the value is none of the enumerators
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

// ---- Lists for messages and help
// -------------------------------------------------------------------------------------

/// "a, b or c" where `last` is " or ".
[[nodiscard]] std::string joined(const std::vector<std::string>& words, std::string_view last = ", ");

/// "aosoa(32)", "soa".
[[nodiscard]] std::string layout_word(Layout layout);

/// The words of all layouts, with this in the brackets of tiled ones: "aos", ..., "aosoa(W)".
[[nodiscard]] std::vector<std::string> layout_words(std::string_view tile);

/// What format(...) takes besides quaternion(...): "float32", "float64", "half", ...
[[nodiscard]] std::vector<std::string> encoding_words();

/// Element types, as a schema names them; those of integers, or those of real numbers: "Index", "int".
[[nodiscard]] std::vector<std::string> element_types(bool integers);

/// Types of fields, as a schema names them: "Scalar", "Vector<N>", "Matrix<R, C>", ..., "Index", "float", ...
[[nodiscard]] std::vector<std::string> field_types();

}  // namespace physgen::model
