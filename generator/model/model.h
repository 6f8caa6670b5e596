// The model of a schema: what people declared, as plain comparable structs. The frontend fills it, the plan and the
// emitters read it, and it goes to and from JSON. Nothing of Clang or LLVM appears here.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/facts.h"

namespace physgen::model {

/// Where something was declared; line and column count from 1.
struct Location {
  std::string file;
  int line = 0;
  int column = 0;
  bool operator==(const Location&) const = default;
};

/// Closed interval of meaningful values, in the field's unit.
struct Range {
  double low = 0;
  double high = 0;
  bool operator==(const Range&) const = default;
};

/// How a field is stored in a memory space: the encoding of its elements, or, of a rotation stored as a quaternion, of
/// that one's four components.
struct Format {
  Encoding encoding = Encoding::native;
  bool quaternion = false;
  bool operator==(const Format&) const = default;
};

/// One data member of an object.
struct Field {
  std::string name;
  std::string doc;  ///< the doc comment's text, without comment markers
  Shape shape = Shape::scalar;
  Element element = Element::real;  ///< not used by Shape::object
  int rows = 1;                     ///< vector<N>: N x 1; matrix<R,C>; symmetric, diagonal, skew: N x N; rotation 3 x 3
  int cols = 1;
  std::string object;    ///< qualified name of the nested object type, for Shape::object only
  int array_extent = 0;  ///< number of entries of a fixed array; 0: not an array
  std::string unit;      ///< "Pa", empty: none stated
  std::optional<Range> range;
  std::optional<double> initial;  ///< value of every element of a new object; none: 0
  Format host_format;
  Format cuda_format;
  Location location;
  bool operator==(const Field&) const = default;

  [[nodiscard]] const Format& format(Space space) const { return space == Space::host ? host_format : cuda_format; }
};

/// One object type.
struct Object {
  std::string name;   ///< unqualified
  std::string scope;  ///< enclosing namespaces, "a::b"; empty: global
  std::string doc;
  std::string schema;  ///< of an imported object: file name of the schema that declares it; empty: this one
  std::vector<Field> fields;
  std::optional<Layout> host_layout;  ///< none: the standard one of the space
  std::optional<Layout> cuda_layout;
  int alignment = 0;  ///< alignment of one AoS record in bytes (a power of two); 0: natural
  Location location;
  bool operator==(const Object&) const = default;

  /// The schema's layout in a space, else the standard one.
  [[nodiscard]] Layout layout(Space space) const {
    return (space == Space::host ? host_layout : cuda_layout).value_or(facts(space).standard);
  }
  [[nodiscard]] std::string qualified_name() const { return scope.empty() ? name : scope + "::" + name; }
};

/// One schema header: its own objects, in order of declaration, and those of included schemas that they may nest.
struct Schema {
  std::string file;              ///< file name without folders, e.g. "elasticity.h"
  std::vector<Object> imported;  ///< from included schemas
  std::vector<Object> objects;
  bool operator==(const Schema&) const = default;
};

/// Number of stored elements of one entry of `field` (a fixed array has array_extent entries): Symmetric<3> 6,
/// Diagonal<3> 3, Skew<3> 3, Rotation 9 as a matrix. Not defined for Shape::object.
[[nodiscard]] int element_count(const Field& field);

/// The type of `field` as a schema says it: "Symmetric<3>", "Scalar", "m::Svd".
[[nodiscard]] std::string schema_type(const Field& field);

}  // namespace physgen::model
