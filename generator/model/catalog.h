// The catalogue: the closed sets of the domain, with one row for every memory space, layout, encoding, shape and
// element type. JSON, the frontend, validation, plan, emitters, help texts and the drawings of `physgen layout` read
// its row. A new one is an enumerator and a row here; generator/README.md lists what else it takes.
#pragma once

#include <cfloat>
#include <limits>
#include <string_view>

namespace physgen::model {

// ---- Layouts ----

enum class LayoutKind { aos, aos_padded, soa, aosoa };

/// How an array of objects lies in memory; `tile` is the objects per tile of an aosoa (a power of two), else 0.
struct Layout {
  LayoutKind kind = LayoutKind::aos;
  int tile = 0;
  bool operator==(const Layout&) const = default;
};

/// Smallest multiple of `step` that is not below `value`.
template <class Number>
[[nodiscard]] constexpr Number align_up(Number value, Number step) {
  return (value + step - 1) / step * step;
}

namespace detail {

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
constexpr int tiled_record(int bytes, int /*alignment*/, int tile) { return align_up(bytes, tile < 8 ? 8 / tile : 1); }

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

// ---- Memory spaces ----

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

// ---- Encodings ----

enum class Encoding { native, float32, float64, half, bfloat16, snorm16 };

/// The part of a field's range that goes into its format.
enum class Scaling {
  none,
  exponent,  ///< the power of two that brings its larger end just below the largest number: Half<4>
  interval   ///< the range itself, which such a field must state: Snorm16<Interval{0.0, 1.0}>
};

/// Formats of Scaling::exponent are scaled by 2^-max_exponent to 2^max_exponent.
inline constexpr int max_exponent = 100;

inline constexpr double no_limit = std::numeric_limits<double>::infinity();

struct EncodingFacts {
  Encoding key;
  std::string_view word;             ///< of the schema and of JSON: "half"
  std::string_view type;             ///< in namespace physgen::format: "Half"
  std::string_view quaternion = {};  ///< there, a name for quaternions of such components; empty: Quaternion<type>
  int bytes = 0;                     ///< of an element; 0: those of the type computed with
  Scaling scaling = Scaling::none;
  double largest = no_limit;             ///< size that is kept, before scaling; of steps: that is computed with
  double least = 0;                      ///< size that is kept with all bits, for Scaling::exponent
  int steps = 0;                         ///< over the range, for Scaling::interval
  std::string_view name = {};            ///< in comments and drawings: "half"; empty: the element's own
  std::string_view components = {};      ///< of a quaternion, in comments: "halves"
  std::string_view relative_error = {};  ///< largest, in comments; empty: absolute, half a step
  std::string_view rotation_error;       ///< largest of an entry of a quaternion's matrix, in comments
};

inline constexpr EncodingFacts encoding_rows[] = {
    {.key = Encoding::native, .word = "native", .type = "Native", .rotation_error = "10 eps"},
    {.key = Encoding::float32,
     .word = "float32",
     .type = "Float32",
     .bytes = 4,
     .largest = FLT_MAX,
     .name = "float",
     .components = "floats",
     .relative_error = "6e-8",
     .rotation_error = "1.2e-6"},
    {.key = Encoding::float64,
     .word = "float64",
     .type = "Float64",
     .bytes = 8,
     .name = "double",
     .components = "doubles",
     .relative_error = "1.2e-16",
     .rotation_error = "10 eps"},
    {.key = Encoding::half,
     .word = "half",
     .type = "Half",
     .bytes = 2,
     .scaling = Scaling::exponent,
     .largest = 65504,
     .least = 6.104e-5,
     .name = "half",
     .components = "halves",
     .relative_error = "4.9e-4",
     .rotation_error = "2e-3"},
    {.key = Encoding::bfloat16,
     .word = "bfloat16",
     .type = "Bfloat16",
     .bytes = 2,
     .largest = 0x1.FEp127,
     .name = "bfloat16",
     .components = "bfloat16",
     .relative_error = "3.9e-3",
     .rotation_error = "1.6e-2"},
    {.key = Encoding::snorm16,
     .word = "snorm16",
     .type = "Snorm16",
     .quaternion = "Quaternion16",
     .bytes = 2,
     .scaling = Scaling::interval,
     .largest = FLT_MAX,
     .steps = 65534,
     .name = "16-bit steps",
     .components = "16-bit steps",
     .rotation_error = "9e-5"},
};

// ---- Shapes ----

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
  std::string_view word;         ///< of JSON: "symmetric"
  std::string_view type = {};    ///< in physgen::schema, and in physgen::shape: "Symmetric"; empty: it has none
  std::string_view phrase = {};  ///< "symmetric": what comments add to what the type of the value says
  Sides sides;
  int side = 1;                                ///< both sides of Sides::fixed, else the least that stores any
  int (*count)(int rows, int cols) = nullptr;  ///< of stored elements
  Entry (*entry)(int k, int rows) = nullptr;   ///< where element k stands
  bool column = false;                         ///< the value is a column, else a matrix of rows x cols
  bool integers = true;                        ///< its elements may be integers or bool
  bool uniform = true;                         ///< equal elements make a value of equal entries
};

inline constexpr ShapeFacts shape_rows[] = {
    {.key = Shape::scalar,
     .word = "scalar",
     .type = "Scalar",
     .sides = Sides::fixed,
     .count = detail::all_entries,
     .entry = detail::by_columns},
    {.key = Shape::vector,
     .word = "vector",
     .type = "Vector",
     .sides = Sides::column,
     .count = detail::one_column,
     .entry = detail::by_columns,
     .column = true},
    {.key = Shape::matrix,
     .word = "matrix",
     .type = "Matrix",
     .sides = Sides::any,
     .count = detail::all_entries,
     .entry = detail::by_columns},
    {.key = Shape::symmetric,
     .word = "symmetric",
     .type = "Symmetric",
     .phrase = "symmetric",
     .sides = Sides::square,
     .count = detail::lower_triangle,
     .entry = detail::in_lower_triangle},
    {.key = Shape::diagonal,
     .word = "diagonal",
     .type = "Diagonal",
     .phrase = "diagonal",
     .sides = Sides::square,
     .count = detail::one_column,
     .entry = detail::by_columns,
     .column = true},
    {.key = Shape::skew,
     .word = "skew",
     .type = "Skew",
     .phrase = "skew-symmetric",
     .sides = Sides::square,
     .side = 2,
     .count = detail::strictly_lower_triangle,
     .entry = detail::in_strictly_lower_triangle,
     .uniform = false},
    {.key = Shape::rotation,
     .word = "rotation",
     .type = "Rotation",
     .phrase = "rotation",
     .sides = Sides::fixed,
     .side = 3,
     .count = detail::all_entries,
     .entry = detail::by_columns,
     .integers = false},
    {.key = Shape::object, .word = "object", .sides = Sides::any},
};

// ---- Element types ----

/// The type of one stored element. `real` is the precision that the scene chooses (float or double).
enum class Element { real, index, float32, float64, int32, int64, uint64, boolean };

struct ElementFacts {
  Element key;
  std::string_view word;    ///< of JSON: "float32"
  std::string_view schema;  ///< "float"; of a vocabulary type, its name in physgen::schema
  std::string_view type;    ///< of C++: "std::int32_t"
  std::string_view name;    ///< in drawings; empty: the precision of the scene
  int bytes_with_float;     ///< where Real is float
  int bytes_with_double;
  bool integer;                ///< or bool: stored as it is, in no other format
  std::string_view kind = {};  ///< of integers, in messages: "a 32-bit integer"
  int unsigned_bits = 0;       ///< of integers without negatives
};

inline constexpr ElementFacts element_rows[] = {
    {Element::real, "real", "Scalar", "Real", "", 4, 8, false},
    {Element::index, "index", "Index", "std::int32_t", "int", 4, 4, true, "a 32-bit integer"},
    {Element::float32, "float32", "float", "float", "float", 4, 4, false},
    {Element::float64, "float64", "double", "double", "double", 8, 8, false},
    {Element::int32, "int32", "int", "std::int32_t", "int", 4, 4, true, "a 32-bit integer"},
    {Element::int64, "int64", "std::int64_t", "std::int64_t", "int64", 8, 8, true, "a 64-bit integer"},
    {Element::uint64, "uint64", "std::uint64_t", "std::uint64_t", "uint64", 8, 8, true, "a std::uint64_t", 64},
    {Element::boolean, "boolean", "bool", "bool", "bool", 1, 1, true, "0 or 1", 1},
};

}  // namespace physgen::model
