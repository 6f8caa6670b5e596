// The words a schema is written in: element types for the fields of an object, and options for objects and fields.
// A schema is an ordinary C++20 header of structs; physgen reads it and writes the accessor classes. To other compilers
// the macros are empty and the types are plain markers, so editors understand a schema. Programs include the generated
// header in its place: the two declare the same names.
//
// Objects stand in a namespace:
//
//   #include <physgen/schema.h>
//   namespace elasticity {
//   using namespace physgen::schema;
//
//   /// Stress of one element.                                     (doc comments reach the generated classes)
//   struct PHYSGEN_OBJECT(layout(host, aosoa(16)), layout(cuda, aosoa(32))) Stress {
//     PHYSGEN(unit("Pa")) Matrix<3, 3> P;  ///< first Piola-Kirchhoff stress
//   };
//   }
//
// A field has one of the types below, float, double, int, std::int64_t, std::uint64_t, bool, another object, or a fixed
// array of one of these: `Symmetric<3> k[4]`. It has no pointers, references or functions: one object is a record of
// numbers. Use `Index` to refer to an object of another array.
#ifndef PHYSGEN_SCHEMA_H
#define PHYSGEN_SCHEMA_H

#ifdef PHYSGEN_GENERATED_HEADER
#error "a program includes a generated header in place of the schema: remove the #include of the schema"
#endif

#if defined(__clang__) && !defined(__CUDACC__)
/// Marks a struct as an object type: `struct PHYSGEN_OBJECT() Name { ... };`. Options: layout(...), once per memory
/// space, and align(...).
#define PHYSGEN_OBJECT(...) [[clang::annotate("physgen.object" __VA_OPT__(, ) __VA_ARGS__)]]
/// Options of a field, or of all fields of one declaration: `PHYSGEN(unit("m"), initial(1)) Vector<3> x, y;`. Options:
/// unit(...), range(...), initial(...), each at most once, and format(...), once per memory space.
#define PHYSGEN(...) [[clang::annotate("physgen.field" __VA_OPT__(, ) __VA_ARGS__)]]
#else
#define PHYSGEN_OBJECT(...)
#define PHYSGEN(...)
#endif

#if __has_include(<cstdint>)
#include <cstdint>
#else  // physgen reads schemas without headers of the system
namespace std {
using int64_t = __INT64_TYPE__;
using uint64_t = __UINT64_TYPE__;
}  // namespace std
#endif

namespace physgen::schema {

// ---- Types of fields. `Element` is Scalar, Index, float, double, int, std::int64_t, std::uint64_t or bool. ----

/// A real number of the precision that the scene chooses, float or double. Write float or double where the precision is
/// not the scene's choice.
struct Scalar {};

/// Number of an object in some array, or a count: a 32-bit signed integer.
struct Index {};

/// Column vector of Size elements: Vector<3>, Vector<4, Index>.
template <int Size, class Element = Scalar>
struct Vector {};

/// Matrix of Rows x Cols elements, stored by columns.
template <int Rows, int Cols, class Element = Scalar>
struct Matrix {};

/// Symmetric matrix; stores Size (Size + 1) / 2 elements.
template <int Size, class Element = Scalar>
struct Symmetric {};

/// Diagonal matrix; stores Size elements.
template <int Size, class Element = Scalar>
struct Diagonal {};

/// Skew-symmetric matrix; stores Size (Size - 1) / 2 elements.
template <int Size, class Element = Scalar>
struct Skew {};

/// Rotation of space: a 3 x 3 orthogonal matrix of determinant +1.
struct Rotation {};

// ---- Options. Their types are in `detail`, so that a schema may have its own Unit or Range. ----

namespace detail {
enum class Space { host, cuda };
enum class Arrangement { aos, aos_padded, soa, aosoa };
struct Pattern {
  Arrangement arrangement;
  int tile;
};
struct Layout {
  Space space;
  Pattern pattern;
};
struct Alignment {
  int bytes;
};
struct Unit {
  const char* text;
};
struct Range {
  double low, high;
};
struct Initial {
  double value;
};
enum class Encoding { native, float32, float64, half, bfloat16, snorm16 };
struct StorageFormat {
  Encoding encoding;
  int quaternions;  // 1: the encoding is that of a quaternion's components
};
struct Format {
  Space space;
  StorageFormat stored;
};
}  // namespace detail

// ---- Options of objects ----

/// The memory of the processor, pinned memory too.
inline constexpr detail::Space host = detail::Space::host;
/// The memory of a CUDA device.
inline constexpr detail::Space cuda = detail::Space::cuda;

/// One whole record after the other.
inline constexpr detail::Pattern aos{detail::Arrangement::aos, 0};
/// As aos, records filled up to multiples of 16 bytes: for objects that are gathered in no order, such as nodes.
inline constexpr detail::Pattern aos_padded{detail::Arrangement::aos_padded, 0};
/// Every element of the record in an array of its own.
inline constexpr detail::Pattern soa{detail::Arrangement::soa, 0};
/// As soa within tiles of `tile` objects, a power of two from 2 to 1024: for objects that are streamed in order.
[[nodiscard]] constexpr detail::Pattern aosoa(int tile) { return {detail::Arrangement::aosoa, tile}; }

/// The layout of arrays of this object in a space, where the program does not choose another: layout(cuda, aosoa(32)).
/// @param pattern aos, aos_padded, soa or aosoa(tile)
[[nodiscard]] constexpr detail::Layout layout(detail::Space space, detail::Pattern pattern) { return {space, pattern}; }

/// Alignment of one record in the layouts aos and aos_padded: a power of two up to 256 bytes.
[[nodiscard]] constexpr detail::Alignment align(int bytes) { return {bytes}; }

// ---- Options of fields ----

/// The unit of the field's elements, a string literal: unit("Pa"), unit("m^3"), unit("1/m").
[[nodiscard]] constexpr detail::Unit unit(const char* text) { return {text}; }

/// The elements' meaningful values, both ends included, in the field's unit.
[[nodiscard]] constexpr detail::Range range(double low, double high) { return {low, high}; }

// Ways to store elements, apart from the precision that they are computed with:
/// In single or double precision, whatever the scene chooses.
inline constexpr detail::StorageFormat float32{detail::Encoding::float32, 0};
inline constexpr detail::StorageFormat float64{detail::Encoding::float64, 0};
/// IEEE half: 11 significant bits up to 65504, relative error 4.9e-4. With a range(...), elements are scaled by the
/// power of two that brings its larger end to 32768.
inline constexpr detail::StorageFormat half{detail::Encoding::half, 0};
/// 8 significant bits with the range of float: relative error 3.9e-3.
inline constexpr detail::StorageFormat bfloat16{detail::Encoding::bfloat16, 0};
/// 16 bits, equal steps over the field's range(...): absolute error its width / 131068.
inline constexpr detail::StorageFormat snorm16{detail::Encoding::snorm16, 0};
/// A Rotation as a unit quaternion: 4 components, as precise as computed, or in one of the above: quaternion(half).
[[nodiscard]] constexpr detail::StorageFormat quaternion(detail::StorageFormat component = {detail::Encoding::native,
                                                                                            0}) {
  return {component.encoding, component.quaternions + 1};
}

/// Chooses how the field is stored in a space, where the program does not choose otherwise: format(cuda, half). Kernels
/// read and write the same values; those that a format cannot hold are rounded, or, beyond its range, lost.
[[nodiscard]] constexpr detail::Format format(detail::Space space, detail::StorageFormat stored) {
  return {space, stored};
}

/// The value of every element of the field in a new object; 0 without this option.
[[nodiscard]] constexpr detail::Initial initial(double value) { return {value}; }

}  // namespace physgen::schema

#endif  // PHYSGEN_SCHEMA_H
