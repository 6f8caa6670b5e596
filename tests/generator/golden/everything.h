// Everything that a schema can say: every shape, element, option and format, arrays, nesting across namespaces and from
// another schema, and fields with names that generated code uses elsewhere.
#pragma once

#include <physgen/schema.h>

#include "materials.h"

namespace tissue {
using namespace physgen::schema;

/// A moment, of a namespace around those of the others.
struct PHYSGEN_OBJECT() Stamp {
  PHYSGEN(unit("s")) double time;
  int step;
};

}  // namespace tissue

namespace tissue::model {
using namespace physgen::schema;

/// Every structure, with elements of every type.
struct PHYSGEN_OBJECT() Shapes {
  /// Scalar.
  Scalar a;
  Vector<3> v;
  /// corners i, j, k, l
  Vector<4, Index> nodes;
  /// deformation gradient
  PHYSGEN(unit("1")) Matrix<3, 3> F;
  Matrix<2, 3> B;
  Matrix<1, 4> row;
  PHYSGEN(unit("N/m")) Symmetric<3> K;
  Symmetric<2, double> C2;
  Diagonal<3> s;
  PHYSGEN(unit("1/s")) Skew<3> W;
  /// principal directions
  Rotation U;
  Rotation V;
  Vector<2, int> count;
  Matrix<2, 2, double> M;
};

/// Names that generated code uses elsewhere.
struct PHYSGEN_OBJECT() Names {
  Scalar value;
  Scalar entry;
  Scalar S;
  Scalar R;
  Scalar at;
  Scalar cursor;
  Scalar name;
  Scalar fields;
  Scalar Layout;
  Scalar host;
  Scalar plan;
  Scalar slot;
  Scalar stride;
  Scalar offset;
  Scalar format;
  Scalar Native;
  Scalar PerSpace;
  Scalar field;
  Scalar element;
  Scalar nested;
  Scalar self[2];
  Scalar assign;
  Scalar texts;
  Scalar Inner;
  Vector<2> tissue;
};

/// Fixed arrays.
struct PHYSGEN_OBJECT() Entries {
  /// Weights of the five points.
  /// They sum to one.
  PHYSGEN(unit("1"), range(0, 1)) Scalar weights[5];
  PHYSGEN(unit("N/m")) Symmetric<3> k[4];
  int flags[3];
  /// More entries than are worth unrolling
  double history[40];
  Vector<2, Index> edges[6];
  Scalar entry[2];
};

/// Units, ranges and initial values. The text of this comment is long enough to need a second line, because it goes on
/// and on without saying anything else.
///
///   An indented line.
/// The last line.
struct PHYSGEN_OBJECT(layout(host, soa), layout(cuda, aos_padded), align(32)) Options {
  /// Mass per volume of the rest shape.
  PHYSGEN(unit("kg/m^3"), range(0, 20000), initial(1060)) Scalar density;
  PHYSGEN(range(0, 0.5), initial(0.45)) Scalar nu;
  PHYSGEN(unit("1"), initial(0.5)) Vector<3> direction;
  PHYSGEN(initial(1)) Symmetric<3> metric;
  PHYSGEN(initial(-1)) int label;
  PHYSGEN(initial(7)) Vector<2, Index> group;
  PHYSGEN(initial(0.25)) Skew<3> spin;
  PHYSGEN(initial(1e-12)) double fixed;
};

/// Nested objects of every alignment.
struct PHYSGEN_OBJECT(layout(host, aos), layout(cuda, aosoa(64))) Element {
  /// Before the nested objects by name, behind them in the record.
  int flag;
  /// Constants of the tissue.
  material::Lame lame;
  material::Fibre fibres[2];
  tissue::Stamp stamp;
  Shapes shapes;
  PHYSGEN(unit("m^3")) Scalar volume;
};

}  // namespace tissue::model

namespace tissue::other {
using namespace physgen::schema;

struct PHYSGEN_OBJECT() Patch {
  tissue::model::Element elements[2];
  float weight;
  tissue::model::Options options;
};

}  // namespace tissue::other

namespace tissue::model {
using namespace physgen::schema;

/// A place and a direction, compact on CUDA.
struct PHYSGEN_OBJECT() Frame {
  PHYSGEN(format(host, quaternion()), format(cuda, quaternion(snorm16))) Rotation turn;
  PHYSGEN(unit("m"), format(cuda, half)) Vector<3> origin;
  PHYSGEN(range(0, 1), initial(0.25), format(host, snorm16), format(cuda, snorm16)) Scalar weight;
};

/// Every storage format.
struct PHYSGEN_OBJECT(layout(host, aosoa(8))) Stored {
  PHYSGEN(format(host, float32), format(cuda, float32)) Scalar single;
  PHYSGEN(format(host, float64), format(cuda, float64)) Scalar twice;
  PHYSGEN(format(host, float32), format(cuda, float32)) double narrowed;
  PHYSGEN(format(host, half), format(cuda, half)) Scalar plain_half;
  /// External force.
  PHYSGEN(unit("N"), range(0, 1000000), initial(1000), format(host, half), format(cuda, half)) Scalar load;
  PHYSGEN(format(host, bfloat16), format(cuda, bfloat16)) Scalar wide;
  PHYSGEN(unit("rad"), range(-3.25, 3.25), initial(0.5), format(host, snorm16), format(cuda, snorm16)) Scalar angle;
  PHYSGEN(unit("K"), range(273, 373), initial(310), format(cuda, snorm16)) Scalar temperature;
  PHYSGEN(unit("Pa"), range(-10000000.0, 10000000), format(host, half), format(cuda, bfloat16)) Symmetric<3> stress;
  PHYSGEN(format(cuda, half)) Matrix<3, 3> F;
  PHYSGEN(format(host, half), format(cuda, half)) Diagonal<3> stretch;
  PHYSGEN(range(-8, 8), format(host, snorm16), format(cuda, snorm16)) Skew<3> spin;
  PHYSGEN(format(cuda, quaternion())) Rotation R;
  PHYSGEN(format(host, quaternion(float32)), format(cuda, quaternion(float32))) Rotation R32;
  PHYSGEN(format(host, quaternion(float64)), format(cuda, quaternion(float64))) Rotation R64;
  PHYSGEN(format(host, quaternion(half)), format(cuda, quaternion(half))) Rotation Rhalf;
  PHYSGEN(format(host, quaternion(bfloat16)), format(cuda, quaternion(bfloat16))) Rotation Rbfloat;
  PHYSGEN(format(host, quaternion(snorm16)), format(cuda, quaternion(snorm16))) Rotation R16;
  PHYSGEN(format(host, half), format(cuda, snorm16)) Rotation entries;
  PHYSGEN(format(host, half), format(cuda, half)) Scalar halves[5];
  PHYSGEN(format(host, quaternion(half)), format(cuda, quaternion(half))) Rotation turns[3];
  PHYSGEN(format(host, quaternion(snorm16)), format(cuda, quaternion(snorm16))) Rotation many[33];
  PHYSGEN(initial(7)) int count;
  Frame frame;
  Frame frames[2];
};

/// Integers of 64 bits and bools, in every shape that has them.
struct PHYSGEN_OBJECT() Marks {
  PHYSGEN(initial(-9223372036854775808.0)) std::int64_t lowest;
  PHYSGEN(initial(18446744073709549568.0)) std::uint64_t key;
  /// whether it takes part
  PHYSGEN(initial(true)) bool alive;
  Vector<3, bool> fixed;
  Matrix<2, 2, std::int64_t> counts;
  Symmetric<3, bool> touches;
  Diagonal<2, std::uint64_t> hashes;
  Skew<3, std::int64_t> turns;
  bool flags[5];
  std::int64_t history[2];
  PHYSGEN(unit("kg"), format(host, half)) Scalar weight;
};

}  // namespace tissue::model
